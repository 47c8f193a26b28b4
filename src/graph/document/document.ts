import * as z from 'zod/mini';
import { type Message, msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { CURRENT_VERSION } from './migrations.ts';

/**
 * The document: the whole state of a project that can be edited, saved and undone. State that changes by itself (time,
 * the flying observer) is not included. It is plain JSON; keys are sorted when written, to make diffs small.
 */
/** Maximum number of nodes of a project, as stored and with its groups expanded. */
export const MAX_NODES = 10_000;
/** Maximum nesting of groups. */
export const MAX_GROUP_DEPTH = 16;
const MAX_ARRAY_LENGTH = 100_000;
const MAX_TEXT_LENGTH = 100_000;

/** Ids of nodes, sockets, parameters and groups. */
export const IDENTIFIER = /^[A-Za-z][A-Za-z0-9_-]{0,63}$/;
/** An input; `name.2` is the second edge of an input that takes many. */
const INPUT_NAME = /^[A-Za-z][A-Za-z0-9_-]{0,63}(\.[1-9][0-9]{0,3})?$/;
const COLOR = /^#[0-9a-f]{6}$/;
const HASH = /^[0-9a-f]{64}$/;
const NAME_RULE = msg`a name is a letter and at most 63 more letters, digits, - or _`;
/** What texts of these patterns are, for messages; by the pattern. */
export const PATTERN_RULES: ReadonlyMap<string, Message> = new Map([
  [String(IDENTIFIER), NAME_RULE],
  [String(INPUT_NAME), msg`${NAME_RULE}, here with a number after a dot where it takes many`],
  [String(COLOR), msg`a colour is # and six digits of 0…9, a…f`],
  [String(HASH), msg`a hash is 64 digits of 0…9, a…f`],
]);
/** What values of parameters are, for messages. */
export const VALUE_RULE = msg`a value is a number, true or false, a text, or a list of numbers or of texts`;
const identifier = z.string().check(z.regex(IDENTIFIER));
const text = z.string().check(z.maxLength(MAX_TEXT_LENGTH));
const title = z.string().check(z.maxLength(200));
const color = z.string().check(z.regex(COLOR));
const shortText = (longest: number) => z.string().check(z.minLength(1), z.maxLength(longest));
const arrayUpTo = <T extends z.ZodMiniType>(most: number, of: T) => z.readonly(z.array(of).check(z.maxLength(most)));
const point = z.readonly(z.tuple([z.number(), z.number()]));
const vector = z.readonly(z.tuple([z.number(), z.number(), z.number()]));

const paramValueSchema = z.union([
  z.number(),
  z.boolean(),
  text,
  arrayUpTo(MAX_ARRAY_LENGTH, z.number()),
  arrayUpTo(MAX_ARRAY_LENGTH, text),
]);

const nodeSchema = z.strictObject({
  /** Id of its node type. */
  type: shortText(64),
  /** Only values that differ from the node's defaults. */
  params: z.record(identifier, paramValueSchema),
  /** The user's title; otherwise the type's title is shown. */
  title: z.optional(title),
  /** Passes its input through instead of being evaluated. */
  muted: z.optional(z.literal(true)),
  /** Displayed without its parameters. */
  collapsed: z.optional(z.literal(true)),
});

const edgeSchema = z.strictObject({
  /** An output of a node. */
  from: z.strictObject({ node: identifier, output: identifier }),
  /** An input of another. */
  to: z.strictObject({
    node: identifier,
    input: z.string().check(z.regex(INPUT_NAME)),
  }),
});

const noteSchema = z.strictObject({
  text,
  /** Top left corner on the canvas [px]. */
  at: point,
  /** Width and height [px]. */
  size: point,
  /** `#rrggbb`, sRGB. */
  color: z.optional(color),
});
const frameSchema = z.strictObject({
  title,
  /** Ids of those around which it lies. */
  nodes: arrayUpTo(MAX_NODES, identifier),
  /** `#rrggbb`, sRGB. */
  color: z.optional(color),
});

/** Nodes and edges: of the document itself, and of each group. */
const graphShape = {
  /** By id. */
  nodes: z.record(identifier, nodeSchema),
  /** By the input that the edge feeds (`node.input`): an input has at most one source. */
  edges: z.record(z.string().check(z.maxLength(140)), edgeSchema),
  /** Position of each node on the canvas [px]. */
  layout: z.record(identifier, point),
  /** Texts on the canvas, by id. */
  notes: z.record(identifier, noteSchema),
  /** Frames around nodes, by id. */
  frames: z.record(identifier, frameSchema),
};

const groupSocketSchema = z.strictObject({
  /** Unique in its list. */
  name: identifier,
  /** Type of its data. */
  type: shortText(64),
  title: z.optional(title),
});
const groupSchema = z.strictObject({
  title,
  ...graphShape,
  /** In display order. Inside, nodes of types `group-input` and `group-output` have them as sockets. */
  inputs: arrayUpTo(256, groupSocketSchema),
  /** The same at its other end. */
  outputs: arrayUpTo(256, groupSocketSchema),
});

const markSchema = z.strictObject({
  /** Unique in its list. */
  name: shortText(80),
  /** Path of the thing at which it happened; absent: at the observer. */
  thing: z.optional(text),
  /** World time [s]. */
  time: z.number(),
  /** World frame [m]. */
  position: vector,
  /** What the clock that was there showed [s]. */
  properTime: z.number(),
  /** What the observer's own clock showed when it was marked [s]. */
  ownTime: z.number(),
  /** The observer's γβ then, world frame. */
  u: vector,
});

const fileSchema = z.strictObject({
  /** SHA-256 of its content, if known. */
  hash: z.optional(z.string().check(z.regex(HASH))),
  /** [bytes] */
  size: z.optional(z.int().check(z.nonnegative())),
});

export const documentSchema = z.strictObject({
  /** Tells projects from other JSON. */
  format: z.literal('slowlight'),
  /** Of the schema; files of earlier versions are migrated when they are read. */
  version: z.literal(CURRENT_VERSION),
  /** Title of the project. */
  title: z.optional(title),
  /** What to look for, for viewers of the project. */
  lookFor: z.optional(text),
  ...graphShape,
  /** Subgraphs by id, each used by any number of `group` nodes. */
  groups: z.record(identifier, groupSchema),
  /** Files that the project references, by the names under which nodes read them. */
  files: z.record(shortText(1000), fileSchema),
  /** Events that were marked with the stopwatch of the clocks, in that order. */
  marks: z.optional(arrayUpTo(1000, markSchema)),
});

/** The value of a parameter: a number, a switch, a text, or a list of numbers or texts. */
export type ParamValue = z.infer<typeof paramValueSchema>;
/** A node: its type, and the parameters that are not at their defaults. */
export interface GraphNode extends z.infer<typeof nodeSchema> {}
/** From an output of a node to an input of another. */
export interface GraphEdge extends z.infer<typeof edgeSchema> {}
/** A text on the canvas, with place and size [px]. */
export interface GraphNote extends z.infer<typeof noteSchema> {}
/** A titled frame around nodes. */
export interface GraphFrame extends z.infer<typeof frameSchema> {}
/** An event of spacetime that was marked, at a thing as it was seen, or at the observer. */
export interface EventMark extends z.infer<typeof markSchema> {}
/** What is known of a file that a project reads: hash and size [bytes]. */
export interface FileReference extends z.infer<typeof fileSchema> {}
/** An input or output of a group. */
export interface GroupSocket extends z.infer<typeof groupSocketSchema> {}
/** A subgraph that any number of `group` nodes use. */
export interface NodeGroup extends z.infer<typeof groupSchema> {}
/** A project: nodes, edges and groups, with their places on the canvas [px]. Plain JSON. */
export interface GraphDocument extends z.infer<typeof documentSchema> {}
/** One level of a document: its own, or a group's. */
export type Graph = Pick<GraphDocument, keyof typeof graphShape>;

/**
 * A document that cannot be read, with the place of the error.
 * @example
 * try {
 *   parseDocument('{ "format": "slowlight", "version": 5, "nodes": 7 }');
 * } catch (error) {
 *   error instanceof DocumentError && error.message.startsWith('nodes:'); // true
 * }
 */
export class DocumentError extends MessageError {
  constructor(text: Message) {
    super(text);
    this.name = 'DocumentError';
  }
}

export const emptyGraph = (): Graph => ({ nodes: {}, edges: {}, layout: {}, notes: {}, frames: {} });

/**
 * A project without nodes.
 * @example
 * emptyDocument(); // { format: 'slowlight', version: 6 }
 */
export const emptyDocument = (): GraphDocument => ({
  format: 'slowlight',
  version: CURRENT_VERSION,
  ...emptyGraph(),
  groups: {},
  files: {},
});

export const edgeKey = (to: GraphEdge['to']): string => `${to.node}.${to.input}`;

/** An own property of a table; names such as `constructor` are not found unless defined. */
export const own = <T>(table: Readonly<Record<string, T>>, key: string): T | undefined =>
  Object.hasOwn(table, key) ? table[key] : undefined;

/** The graph of a group, or the document's own. */
export const graphIn = (document: GraphDocument, group?: string): Graph | undefined =>
  group === undefined ? document : own(document.groups, group);
