export const CURRENT_VERSION = 1;

type Migration = (data: Record<string, unknown>) => Record<string, unknown>;

/** `MIGRATIONS[n]` turns a document of version n into one of version n + 1. A change of the schema adds one entry. */
const MIGRATIONS: Readonly<Record<number, Migration>> = {};

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

const isRecord = (data: unknown): data is Record<string, unknown> =>
  typeof data === 'object' && data !== null && !Array.isArray(data);
