export const CURRENT_VERSION = 3;

type Migration = (data: Record<string, unknown>) => Record<string, unknown>;

/** `MIGRATIONS[n]` turns a document of version n into one of version n + 1. A change of the schema adds one entry. */
const MIGRATIONS: Readonly<Record<number, Migration>> = { 1: meterInsteadOfAdapting, 2: withGroupsAndGeometry };

/** Brings parsed JSON to the current version; what is no document at all is left to the schema to refuse. */
export function migrate(data: unknown, migrations = MIGRATIONS, current = CURRENT_VERSION): unknown {
  if (!isRecord(data)) return data;
  let document = data;
  while (typeof document.version === 'number' && document.version < current) {
    const step = migrations[document.version];
    if (!step) return document;
    document = { ...step(document), version: document.version + 1 };
  }
  return document;
}

/** 1 → 2: the tone map's switch `adapt` gave way to `metering`, whose default is what it was on. */
function meterInsteadOfAdapting(data: Record<string, unknown>): Record<string, unknown> {
  if (!isRecord(data.nodes)) return data;
  const nodes = Object.entries(data.nodes).map(([id, node]) => [id, isToneMap(node) ? metered(node) : node] as const);
  return { ...data, nodes: Object.fromEntries(nodes) };
}

const isToneMap = (node: unknown): node is { type: string; params: Record<string, unknown> } =>
  isRecord(node) && node.type === 'tone-map' && isRecord(node.params);

function metered({ params, ...node }: { params: Record<string, unknown> }) {
  const { adapt, ...rest } = params;
  return { ...node, params: adapt === false ? { ...rest, metering: 'manual' } : rest };
}

/** 2 → 3: groups, notes, frames and references to files came; what is read is geometry, of which a scene takes any number. */
function withGroupsAndGeometry(data: Record<string, unknown>): Record<string, unknown> {
  const { nodes, edges } = data;
  const typeOf = (id: unknown): unknown =>
    isRecord(nodes) && typeof id === 'string' && isRecord(nodes[id]) ? nodes[id].type : undefined;
  const renamed = (edge: unknown): unknown => {
    if (!isRecord(edge) || !isRecord(edge.from) || !isRecord(edge.to)) return edge;
    const output =
      MAKES_GEOMETRY.has(typeOf(edge.from.node)) && edge.from.output === 'scene' ? 'geometry' : edge.from.output;
    const type = typeOf(edge.to.node);
    const input =
      edge.to.input !== 'scene'
        ? edge.to.input
        : type === 'retime'
          ? 'geometry'
          : type === 'scene'
            ? 'geometry.1'
            : 'scene';
    return { from: { ...edge.from, output }, to: { ...edge.to, input } };
  };
  const keyed = (edge: unknown): readonly [string, unknown] => {
    const to = isRecord(edge) && isRecord(edge.to) ? edge.to : {};
    return [`${nameIn(to.node)}.${nameIn(to.input)}`, edge];
  };
  const all = isRecord(edges) ? Object.fromEntries(Object.values(edges).map(renamed).map(keyed)) : edges;
  return { ...data, edges: all, notes: {}, frames: {}, groups: {}, files: {} };
}

/** What is no text is left to the schema to refuse. */
const nameIn = (value: unknown): string => (typeof value === 'string' ? value : '');

const MAKES_GEOMETRY: ReadonlySet<unknown> = new Set(['read', 'retime']);

const isRecord = (data: unknown): data is Record<string, unknown> =>
  typeof data === 'object' && data !== null && !Array.isArray(data);
