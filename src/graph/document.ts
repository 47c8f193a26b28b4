import { z } from 'zod';
import { CURRENT_VERSION, migrate } from './migrations.ts';

/**
 * The document: the whole state of a project that a person can edit, save and undo. What changes by itself (the time,
 * the observer in flight) is not in it. It is plain JSON; keys are sorted when written, so that files compare well.
 */
const identifier = z.string().regex(/^[A-Za-z][A-Za-z0-9_-]{0,63}$/);
const paramValueSchema = z.union([
  z.number(),
  z.boolean(),
  z.string(),
  z.array(z.number()).readonly(),
  z.array(z.string()).readonly(),
]);

const nodeSchema = z.strictObject({
  type: z.string().min(1),
  /** Only what differs from the node's defaults. */
  params: z.record(z.string(), paramValueSchema),
});

const edgeSchema = z.strictObject({
  from: z.strictObject({ node: identifier, output: z.string().min(1) }),
  to: z.strictObject({ node: identifier, input: z.string().min(1) }),
});

const documentSchema = z.strictObject({
  format: z.literal('slowlight'),
  version: z.literal(CURRENT_VERSION),
  nodes: z.record(identifier, nodeSchema),
  /** Keyed by the input that the edge feeds (`node.input`): an input has at most one source. */
  edges: z.record(z.string(), edgeSchema),
  /** Where each node stands on the canvas [px]. */
  layout: z.record(identifier, z.tuple([z.number(), z.number()])),
});

export type ParamValue = z.infer<typeof paramValueSchema>;
export type GraphNode = z.infer<typeof nodeSchema>;
export type GraphEdge = z.infer<typeof edgeSchema>;
export type GraphDocument = z.infer<typeof documentSchema>;

/** A document that cannot be read, with the place in it. */
export class DocumentError extends Error {
  constructor(message: string) {
    super(message);
    this.name = 'DocumentError';
  }
}

export const emptyDocument = (): GraphDocument => ({
  format: 'slowlight',
  version: CURRENT_VERSION,
  nodes: {},
  edges: {},
  layout: {},
});

export const edgeKey = (to: GraphEdge['to']): string => `${to.node}.${to.input}`;

/** Reads parsed JSON of any version. */
export function readDocument(data: unknown): GraphDocument {
  const result = documentSchema.safeParse(migrate(data));
  if (result.success) return result.data;
  const issue = result.error.issues[0];
  throw new DocumentError(`${issue?.path.join('.') || 'the file'}: ${issue?.message ?? 'not a Slowlight project'}`);
}

export function parseDocument(text: string): GraphDocument {
  let data: unknown;
  try {
    data = JSON.parse(text);
  } catch (error) {
    throw new DocumentError(`not JSON: ${error instanceof Error ? error.message : String(error)}`);
  }
  return readDocument(data);
}

/** The same document always gives the same text, however it was edited. */
export const serializeDocument = (document: GraphDocument): string => `${JSON.stringify(sorted(document), null, 2)}\n`;

function sorted(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(sorted);
  if (typeof value !== 'object' || value === null) return value;
  const entries = Object.entries(value).sort(([a], [b]) => (a < b ? -1 : 1));
  return Object.fromEntries(entries.map(([key, item]) => [key, sorted(item)]));
}
