export const CURRENT_VERSION = 3;

type Migration = (data: Record<string, unknown>) => Record<string, unknown>;

/** `MIGRATIONS[n]` turns a document of version n into one of version n + 1. A change of the schema adds one entry. */
const MIGRATIONS: Readonly<Record<number, Migration>> = { 1: meterInsteadOfAdapting, 2: withGroupsAndNotes };

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

/** 2 → 3: groups, notes, frames and references to files came; there were none before. */
function withGroupsAndNotes(data: Record<string, unknown>): Record<string, unknown> {
  return { ...data, notes: {}, frames: {}, groups: {}, files: {} };
}

const isRecord = (data: unknown): data is Record<string, unknown> =>
  typeof data === 'object' && data !== null && !Array.isArray(data);
