import * as z from 'zod/mini';
import { CURRENT_VERSION } from './migrations.ts';

z.config(z.locales.en());

/**
 * The document: the whole state of a project that a person can edit, save and undo. What changes by itself (the time,
 * the observer in flight) is not in it. It is plain JSON; keys are sorted when written, so that files compare well.
 */
/** How many nodes a project may hold, and how many what is made of it when its groups are opened out. */
export const MAX_NODES = 10_000;
/** How deep groups may lie in groups. */
export const MAX_GROUP_DEPTH = 16;
const MAX_ARRAY_LENGTH = 100_000;
const MAX_TEXT_LENGTH = 100_000;

/** What nodes, sockets, parameters and groups are called in a document. */
export const IDENTIFIER = /^[A-Za-z][A-Za-z0-9_-]{0,63}$/;
/** A socket; `name.2` is the second edge of one that takes many. */
const INPUT_NAME = /^[A-Za-z][A-Za-z0-9_-]{0,63}(\.[1-9][0-9]{0,3})?$/;
const NAME_RULE = 'a name is a letter and at most 63 more letters, digits, - or _';
const identifier = z.string().check(z.regex(IDENTIFIER, NAME_RULE));
const text = z.string().check(z.maxLength(MAX_TEXT_LENGTH));
const title = z.string().check(z.maxLength(200));
const color = z.string().check(z.regex(/^#[0-9a-f]{6}$/, 'a colour is # and six digits of 0…9, a…f'));
const shortText = (longest: number) => z.string().check(z.minLength(1), z.maxLength(longest));
const arrayUpTo = <T extends z.ZodMiniType>(most: number, of: T) => z.readonly(z.array(of).check(z.maxLength(most)));
const point = z.readonly(z.tuple([z.number(), z.number()]));

const paramValueSchema = z.union([
  z.number(),
  z.boolean(),
  text,
  arrayUpTo(MAX_ARRAY_LENGTH, z.number()),
  arrayUpTo(MAX_ARRAY_LENGTH, text),
]);

const nodeSchema = z.strictObject({
  type: shortText(64),
  /** Only what differs from the node's defaults. */
  params: z.record(identifier, paramValueSchema),
  /** What a person calls it; else it goes by the title of its type. */
  title: z.optional(title),
  /** Passes on what it gets instead of doing its work. */
  muted: z.optional(z.literal(true)),
  /** Shown without its parameters. */
  collapsed: z.optional(z.literal(true)),
});

const edgeSchema = z.strictObject({
  from: z.strictObject({ node: identifier, output: identifier }),
  to: z.strictObject({
    node: identifier,
    input: z.string().check(z.regex(INPUT_NAME, `${NAME_RULE}, here with a number after a dot where it takes many`)),
  }),
});

const noteSchema = z.strictObject({ text, at: point, size: point, color: z.optional(color) });
const frameSchema = z.strictObject({
  title,
  nodes: arrayUpTo(MAX_NODES, identifier),
  color: z.optional(color),
});

/** Nodes and what joins them: the document itself, and the inside of each group. */
const graphShape = {
  nodes: z.record(identifier, nodeSchema),
  /** Keyed by the input that the edge feeds (`node.input`): an input has at most one source. */
  edges: z.record(z.string().check(z.maxLength(140)), edgeSchema),
  /** Where each node stands on the canvas [px]. */
  layout: z.record(identifier, point),
  notes: z.record(identifier, noteSchema),
  /** Nodes that are shown with a frame around them. */
  frames: z.record(identifier, frameSchema),
};

const groupSocketSchema = z.strictObject({
  name: identifier,
  type: shortText(64),
  title: z.optional(title),
});
const groupSchema = z.strictObject({
  title,
  ...graphShape,
  /** In the order in which they are shown. Inside, nodes of the types `group-input` and `group-output` carry them. */
  inputs: arrayUpTo(256, groupSocketSchema),
  outputs: arrayUpTo(256, groupSocketSchema),
});

const fileSchema = z.strictObject({
  /** SHA-256 of its content, where it is known. */
  hash: z.optional(z.string().check(z.regex(/^[0-9a-f]{64}$/, 'a hash is 64 digits of 0…9, a…f'))),
  /** [bytes] */
  size: z.optional(z.int().check(z.nonnegative())),
});

export const documentSchema = z.strictObject({
  format: z.literal('slowlight'),
  version: z.literal(CURRENT_VERSION),
  /** What the project is called. */
  title: z.optional(title),
  /** What there is to be seen in it, for those who open it. */
  lookFor: z.optional(text),
  ...graphShape,
  /** Subgraphs, each used by any number of nodes of the type `group` by its key. */
  groups: z.record(identifier, groupSchema),
  /** Scene files that the project refers to, by the name under which nodes read them. */
  files: z.record(shortText(1000), fileSchema),
});

export type ParamValue = z.infer<typeof paramValueSchema>;
export type GraphNode = z.infer<typeof nodeSchema>;
export type GraphEdge = z.infer<typeof edgeSchema>;
export type GraphNote = z.infer<typeof noteSchema>;
export type GraphFrame = z.infer<typeof frameSchema>;
export type FileReference = z.infer<typeof fileSchema>;
export type GroupSocket = z.infer<typeof groupSocketSchema>;
export type NodeGroup = z.infer<typeof groupSchema>;
export type GraphDocument = z.infer<typeof documentSchema>;
/** One level of a document: its own, or a group's. */
export type Graph = Pick<GraphDocument, keyof typeof graphShape>;

/** A document that cannot be read, with the place in it. */
export class DocumentError extends Error {
  constructor(message: string) {
    super(message);
    this.name = 'DocumentError';
  }
}

export const emptyGraph = (): Graph => ({ nodes: {}, edges: {}, layout: {}, notes: {}, frames: {} });

export const emptyDocument = (): GraphDocument => ({
  format: 'slowlight',
  version: CURRENT_VERSION,
  ...emptyGraph(),
  groups: {},
  files: {},
});

export const edgeKey = (to: GraphEdge['to']): string => `${to.node}.${to.input}`;

/** What a table holds under a key of its own; a name such as `constructor` is no entry unless it was made one. */
export const own = <T>(table: Readonly<Record<string, T>>, key: string): T | undefined =>
  Object.hasOwn(table, key) ? table[key] : undefined;

/** The level of a document that a group is, or the document's own. */
export const graphIn = (document: GraphDocument, group?: string): Graph | undefined =>
  group === undefined ? document : own(document.groups, group);
