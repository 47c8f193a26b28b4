export const CURRENT_VERSION = 6;

type Migration = (data: Record<string, unknown>) => Record<string, unknown>;

/** `MIGRATIONS[n]` turns a document of version n into version n + 1. Every change of the schema adds an entry. */
const MIGRATIONS: Readonly<Record<number, Migration>> = {
  1: migrateAdaptToMetering,
  2: migrateToGroupsAndGeometry,
  3: (data) => migrateLevels(data, withDeferredLighting),
  4: (data) => migrateLevels(data, withStayInPlace),
  5: (data) => migrateLevels(data, withLinearSpectrum),
};

/** Migrates parsed JSON to the current version; anything that is not a document is left for the schema to refuse. */
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

/** 1 → 2: the tone map's switch `adapt` became `metering`, whose default equals `adapt` on. */
function migrateAdaptToMetering(data: Record<string, unknown>): Record<string, unknown> {
  if (!isRecord(data.nodes)) return data;
  const nodes = Object.entries(data.nodes).map(
    ([id, node]) => [id, isToneMap(node) ? adaptToMetering(node) : node] as const,
  );
  return { ...data, nodes: Object.fromEntries(nodes) };
}

type ToneMapNode = { readonly type: string; readonly params: Record<string, unknown> };
const isToneMap = (node: unknown): node is ToneMapNode =>
  isRecord(node) && node.type === 'tone-map' && isRecord(node.params);

function adaptToMetering({ params, ...node }: { params: Record<string, unknown> }) {
  const { adapt, ...rest } = params;
  return { ...node, params: adapt === false ? { ...rest, metering: 'manual' } : rest };
}

/**
 * 2 → 3: groups, notes, frames and file references were added; reading yields geometry, of which a scene takes any
 * number.
 */
function migrateToGroupsAndGeometry(data: Record<string, unknown>): Record<string, unknown> {
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
    return [`${stringOrEmpty(to.node)}.${stringOrEmpty(to.input)}`, edge];
  };
  const all = isRecord(edges) ? Object.fromEntries(Object.values(edges).map(renamed).map(keyed)) : edges;
  return { ...data, edges: all, notes: {}, frames: {}, groups: {}, files: {} };
}

/** Migrates the document's own level and those of its groups. */
function migrateLevels(data: Record<string, unknown>, migrated: Migration): Record<string, unknown> {
  const { groups } = data;
  if (!isRecord(groups)) return migrated(data);
  const inside = Object.entries(groups).map(([id, group]) => [id, isRecord(group) ? migrated(group) : group]);
  return { ...migrated(data), groups: Object.fromEntries(inside) };
}

/** 3 → 4: a G-buffer is shaded by a node before its tone map, and false colours are a node after it. */
function withDeferredLighting(level: Record<string, unknown>): Record<string, unknown> {
  if (!isRecord(level.nodes) || !isRecord(level.edges)) return level;
  let made: LevelData = { nodes: level.nodes, edges: level.edges, layout: isRecord(level.layout) ? level.layout : {} };
  for (const [id, node] of Object.entries(level.nodes)) if (isToneMap(node)) made = withLighting(made, id, node);
  const nodes = Object.entries(made.nodes).map(([id, node]) => [id, isRasterizer(node) ? withoutShadows(node) : node]);
  return { ...level, ...made, nodes: Object.fromEntries(nodes) };
}

interface LevelData {
  readonly nodes: Record<string, unknown>;
  readonly edges: Record<string, unknown>;
  readonly layout: Record<string, unknown>;
}

function withLighting({ nodes, edges, layout }: LevelData, id: string, { params, ...node }: ToneMapNode): LevelData {
  const { falseColor, ...own } = params;
  const lighting = uniqueNodeKey(nodes, 'lighting');
  const falseColour = uniqueNodeKey(nodes, 'falseColour');
  const source = edges[`${id}.gbuffer`];
  const from = isRecord(source) && isRecord(source.from) ? stringOrEmpty(source.from.node) : '';
  const rasterizer = nodes[from];
  const shadows = isRasterizer(rasterizer) ? rasterizer.params.shadows : undefined;
  const onwards = Object.entries(edges).flatMap(([key, edge]): [string, unknown][] => {
    if (!isRecord(edge) || !isRecord(edge.from) || !isRecord(edge.to)) return [[key, edge]];
    if (key === `${id}.gbuffer`) return [edgeEntry(edge.from, lighting, 'gbuffer')];
    if (key === `${id}.falseColor`) return [edgeEntry(edge.from, falseColour, 'of')];
    if (key === `${from}.shadows` && isRasterizer(rasterizer)) return [edgeEntry(edge.from, lighting, 'shadows')];
    return [[key, edge.from.node === id ? { ...edge, from: { node: falseColour, output: 'image' } } : edge]];
  });
  return {
    nodes: {
      ...nodes,
      [lighting]: { type: 'deferred-lighting', params: shadows === false ? { shadows } : {} },
      [id]: { ...node, params: own },
      [falseColour]: { type: 'false-colour', params: falseColor === undefined ? {} : { of: falseColor } },
    },
    edges: Object.fromEntries([
      ...onwards,
      edgeEntry({ node: lighting, output: 'image' }, id, 'image'),
      edgeEntry({ node: id, output: 'image' }, falseColour, 'image'),
    ]),
    layout: shiftLayout(layout, id, lighting, falseColour),
  };
}

/** Shifts the tone map and the nodes to its right, to make space for a node before and one after it. */
function shiftLayout(layout: LevelData['layout'], id: string, before: string, after: string): LevelData['layout'] {
  const at = layout[id];
  if (!Array.isArray(at)) return layout;
  const [x, y] = at;
  const moved = Object.entries(layout).map(([other, place]) => {
    if (!Array.isArray(place) || !(place[0] >= x)) return [other, place];
    return [other, [place[0] + (other === id ? COLUMN_WIDTH : 2 * COLUMN_WIDTH), place[1]]];
  });
  return { ...Object.fromEntries(moved), [before]: [x, y], [after]: [x + 2 * COLUMN_WIDTH, y] };
}
/** Distance between columns [px]. */
const COLUMN_WIDTH = 240;

const edgeEntry = (from: unknown, node: string, input: string): [string, unknown] => [
  `${node}.${input}`,
  { from, to: { node, input } },
];

function uniqueNodeKey(nodes: LevelData['nodes'], name: string): string {
  let free = name;
  for (let i = 2; Object.hasOwn(nodes, free); i++) free = `${name}${i}`;
  return free;
}

const isRasterizer = (node: unknown): node is { params: Record<string, unknown> } =>
  isRecord(node) && node.type === 'relativity-rasterize' && isRecord(node.params);

function withoutShadows({ params, ...node }: { readonly params: Record<string, unknown> }) {
  const { shadows: _, ...rest } = params;
  return { ...node, params: rest };
}

/** 4 → 5: the parameter `hold` of films became `stayInPlace`, because *Hold* is something else. */
function withStayInPlace(level: Record<string, unknown>): Record<string, unknown> {
  const { nodes, edges } = level;
  if (!isRecord(nodes) || !isRecord(edges)) return level;
  const renamed = Object.entries(nodes).map(([id, node]) => {
    if (!isFilm(node) || !Object.hasOwn(node.params, 'hold')) return [id, node];
    const { hold, ...params } = node.params;
    return [id, { ...node, params: { ...params, stayInPlace: hold } }];
  });
  const led = Object.entries(edges).map(([key, edge]) => {
    if (!isRecord(edge) || !isRecord(edge.to) || edge.to.input !== 'hold') return [key, edge];
    const node = stringOrEmpty(edge.to.node);
    return isFilm(nodes[node]) ? edgeEntry(edge.from, node, 'stayInPlace') : [key, edge];
  });
  return { ...level, nodes: Object.fromEntries(renamed), edges: Object.fromEntries(led) };
}

const isFilm = (node: unknown): node is { params: Record<string, unknown> } =>
  isRecord(node) && node.type === 'save-video' && isRecord(node.params);

/** 5 → 6: the colours `shifted-primaries` gave way to `linear-spectrum`, the method that they stood for. */
function withLinearSpectrum(level: Record<string, unknown>): Record<string, unknown> {
  if (!isRecord(level.nodes)) return level;
  const nodes = Object.entries(level.nodes).map(([id, node]) => {
    if (!isRasterizer(node) || node.params.colors !== 'shifted-primaries') return [id, node];
    return [id, { ...node, params: { ...node.params, colors: 'linear-spectrum' } }];
  });
  return { ...level, nodes: Object.fromEntries(nodes) };
}

/** Non-strings are left for the schema to refuse. */
const stringOrEmpty = (value: unknown): string => (typeof value === 'string' ? value : '');

const MAKES_GEOMETRY: ReadonlySet<unknown> = new Set(['read', 'retime']);

const isRecord = (data: unknown): data is Record<string, unknown> =>
  typeof data === 'object' && data !== null && !Array.isArray(data);
