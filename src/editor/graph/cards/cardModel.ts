import type { LevelTypes } from '../../../graph/analysis/inferTypes.ts';
import { type GraphLevel, inputName, socketsOf } from '../../../graph/analysis/sockets.ts';
import type { GraphEdge, GraphNode, ParamValue } from '../../../graph/document/document.ts';
import { own } from '../../../graph/document/document.ts';
import { GROUP, GROUP_INPUT, GROUP_OUTPUT, groupKeyOf, REROUTE } from '../../../graph/document/structuralTypes.ts';
import type { NodeResult } from '../../../graph/evaluation/resultCache.ts';
import {
  isParamActive,
  type NodeProblem,
  type NodeType,
  resolveParams,
  resolveSpec,
  type Socket,
} from '../../../graph/nodeType.ts';
import { type LocalizedText, msg } from '../../../messages/message.ts';
import { nodeLibrary } from '../../../nodes/library.ts';
import { socketTitle } from '../../../nodes/titles.ts';
import { type DisplayValue, displayParam } from './displayValue.ts';
import { hasPicturePreview, hasTextPreview, previewedImage, textPreview } from './resultPreview.ts';

/** A socket as displayed. */
export interface SocketModel {
  /** Name used by edges: `geometry.2`. */
  readonly name: string;
  readonly title: LocalizedText;
  /** Index within an input that takes many edges. */
  readonly number?: number;
  /** Data type, as inferred from the connections. */
  readonly type: string;
  readonly connected: boolean;
}

/** A row of a node: an input at the left, an output at the right, a parameter's value. */
export interface CardRow {
  readonly input?: SocketModel;
  readonly output?: SocketModel;
  /** Title of the parameter, and its value unless an edge drives it. */
  readonly title?: LocalizedText;
  readonly value?: DisplayValue;
}

/** Everything displayed of a node, as plain data, so that equal models are not re-rendered. */
export interface CardModel {
  readonly id: string;
  readonly type: string;
  readonly category: NodeType['category'] | 'unknown';
  /** The user's title; otherwise that of the type or of the group. */
  readonly title: LocalizedText;
  /** Title of the type, where the title does not already say it. */
  readonly kind?: LocalizedText;
  readonly muted: boolean;
  readonly collapsed: boolean;
  readonly rows: readonly CardRow[];
  /** Number of set parameters that are not listed. */
  readonly more: number;
  /** Whether it has a line for its result. */
  readonly hasPreview: boolean;
  readonly preview?: DisplayValue;
  /**
   * Whether it shows a picture of its result; `metered`: with the histogram of the luminance that its tone curve gets.
   */
  readonly picture?: 'plain' | 'metered';
  readonly problem?: Pick<NodeProblem, 'severity' | 'message' | 'place'>;
  /** An input comes from a node that failed. */
  readonly blocked: boolean;
}

/** What card models are made from, besides the nodes. */
export interface CardContext {
  readonly level: GraphLevel;
  readonly types: LevelTypes;
  readonly edges: ReadonlyMap<string, ConnectedSockets>;
  /** Result of a node of the level, or of a group. */
  resultOf(node: string): NodeResult | undefined;
  problemOf(node: string): NodeProblem | undefined;
  /** Whether nodes show pictures. */
  readonly pictures: boolean;
}

/** The connected sockets of a node. */
export interface ConnectedSockets {
  readonly inputs: readonly string[];
  readonly outputs: readonly string[];
}

const NO_CONNECTIONS: ConnectedSockets = { inputs: [], outputs: [] };

export function connectedSockets(edges: Readonly<Record<string, GraphEdge>>): ReadonlyMap<string, ConnectedSockets> {
  const found = new Map<string, { inputs: string[]; outputs: string[] }>();
  const endsOf = (node: string) => {
    const ends = found.get(node) ?? { inputs: [], outputs: [] };
    found.set(node, ends);
    return ends;
  };
  for (const { from, to } of Object.values(edges)) {
    endsOf(to.node).inputs.push(to.input);
    const { outputs } = endsOf(from.node);
    if (!outputs.includes(from.output)) outputs.push(from.output);
  }
  return found;
}

const TONE_MAP = 'tone-map';
/** Maximum number of set parameters listed on a node. */
const MAX_SET_PARAMS = 5;
/** The socket of a group's input or output node to which new sockets are drawn. */
export const NEW_SOCKET = 'new-socket';

export function cardModel(id: string, node: GraphNode, around: CardContext): CardModel {
  const { level, types } = around;
  const type = own(nodeLibrary, node.type);
  const ends = around.edges.get(id) ?? NO_CONNECTIONS;
  const sockets = socketsOf(level, node, nodeLibrary);
  const typeOf = (side: 'inputs' | 'outputs', name: string) => types.typeOf(id, side, name) ?? 'any';
  const outputs = outputsOf(node, sockets?.outputs ?? {}, ends).map(
    ([name, title]): SocketModel => ({
      name,
      title,
      type: typeOf('outputs', name),
      connected: ends.outputs.includes(name),
    }),
  );
  const plain = ownInputs(node, type, sockets?.inputs ?? {});
  const inputs = [...inputsOf(plain, ends), ...strayInputs(plain, type, ends), ...newSocketInput(node)].map(
    (socket): SocketModel => ({ ...socket, type: typeOf('inputs', socket.name) }),
  );
  const { rows, more } = type ? paramRows(node, type, ends, (name) => typeOf('inputs', name)) : { rows: [], more: 0 };
  const first = outputs[0];
  const tells =
    first !== undefined && !isConstant(node, type) && node.type !== GROUP_INPUT && hasTextPreview(first.type);
  return {
    id,
    type: node.type,
    category: type?.category ?? 'unknown',
    ...titleOf(level, node, type),
    muted: node.muted === true,
    collapsed: node.collapsed === true,
    rows: [...pairSockets(inputs, outputs), ...rows],
    more,
    hasPreview: tells,
    ...resultModel(around, id, first, tells),
    ...(around.pictures && first && previewedImage(around.resultOf(id), first.name) && pictureModeOf(node, first)),
  };
}

/** The picture mode of a node, by its output type; none for muted nodes, which have no result of their own. */
export function pictureModeOf(
  node: GraphNode,
  first: Pick<SocketModel, 'type'> | undefined,
): Pick<CardModel, 'picture'> {
  if (node.muted || node.type === REROUTE || !first || !hasPicturePreview(first.type)) return {};
  return { picture: node.type === TONE_MAP ? 'metered' : 'plain' };
}

const isConstant = (node: GraphNode, type: NodeType | undefined): boolean =>
  type?.category === 'utility' && ['number', 'vector', 'color', 'text', REROUTE].includes(node.type);

function titleOf(
  { document }: GraphLevel,
  node: GraphNode,
  type: NodeType | undefined,
): Pick<CardModel, 'title' | 'kind'> {
  const kind = node.type === GROUP ? own(document.groups, groupKeyOf(node))?.title : undefined;
  const ofType = kind || type?.title || node.type;
  return node.title ? { title: node.title, kind: ofType } : { title: ofType };
}

function resultModel(
  around: CardContext,
  id: string,
  first: SocketModel | undefined,
  tells: boolean,
): Pick<CardModel, 'preview' | 'problem' | 'blocked'> {
  const result = around.resultOf(id);
  const problem = around.problemOf(id);
  const preview = first && tells ? textPreview(result, first.name, first.type) : undefined;
  return {
    ...(preview && { preview }),
    ...(problem && { problem: { severity: problem.severity, message: problem.message, place: problem.place } }),
    blocked: result?.status === 'blocked',
  };
}

type TitledSocket = readonly [name: string, title: LocalizedText];

/** Title of a socket without one: its type, if the name says no more. */
const titleOfSocket = (name: string, { title, type }: Socket): LocalizedText =>
  title ?? (name === type ? socketTitle(type) : name);

function outputsOf(
  node: GraphNode,
  outputs: Readonly<Record<string, Socket>>,
  ends: ConnectedSockets,
): readonly TitledSocket[] {
  const known = Object.entries(outputs).map(([name, socket]): TitledSocket => [name, titleOfSocket(name, socket)]);
  const stray = ends.outputs.filter((name) => !Object.hasOwn(outputs, name)).map((name): TitledSocket => [name, name]);
  return [...known, ...stray, ...(node.type === GROUP_INPUT ? [[NEW_SOCKET, msg`new`] satisfies TitledSocket] : [])];
}

/** Inputs that are not parameters. */
const ownInputs = (
  node: GraphNode,
  type: NodeType | undefined,
  inputs: Readonly<Record<string, Socket>>,
): Readonly<Record<string, Socket>> =>
  node.type === GROUP || node.type === GROUP_OUTPUT ? inputs : (type?.inputs ?? {});

type PlainSocket = Omit<SocketModel, 'type'>;

function inputsOf(inputs: Readonly<Record<string, Socket>>, ends: ConnectedSockets): PlainSocket[] {
  return Object.entries(inputs).flatMap(([name, socket]): PlainSocket[] => {
    const title = titleOfSocket(name, socket);
    if (!socket.many) return [{ name, title, connected: ends.inputs.includes(name) }];
    const taken = connectedNumbers(name, ends);
    // One free socket is always offered.
    return [...taken, (taken.at(-1) ?? 0) + 1].map((number) => ({
      name: `${name}.${number}`,
      title,
      number,
      connected: taken.includes(number),
    }));
  });
}

const connectedNumbers = (name: string, { inputs }: ConnectedSockets): number[] =>
  inputs
    .map(inputName)
    .flatMap(({ base, number }) => (base === name && number !== undefined ? [number] : []))
    .sort((a, b) => a - b);

/** Edges to inputs that do not exist: displayed, so that they can be removed. */
const strayInputs = (
  inputs: Readonly<Record<string, Socket>>,
  type: NodeType | undefined,
  ends: ConnectedSockets,
): PlainSocket[] =>
  ends.inputs
    .filter((name) => {
      const { base } = inputName(name);
      return !Object.hasOwn(inputs, base) && !Object.hasOwn(type?.params ?? {}, base);
    })
    .map((name) => ({ name, title: name, connected: true }));

const newSocketInput = (node: GraphNode): PlainSocket[] =>
  node.type === GROUP_OUTPUT ? [{ name: NEW_SOCKET, title: msg`new`, connected: false }] : [];

function pairSockets(inputs: readonly SocketModel[], outputs: readonly SocketModel[]): CardRow[] {
  return Array.from({ length: Math.max(inputs.length, outputs.length) }, (_, i) => ({
    ...(inputs[i] && { input: inputs[i] }),
    ...(outputs[i] && { output: outputs[i] }),
  }));
}

/** Parameters that are driven or set; for utility nodes, all that are active. */
function paramRows(node: GraphNode, type: NodeType, ends: ConnectedSockets, typeOf: (name: string) => string) {
  if (node.type === GROUP) return { rows: [], more: 0 };
  const values = resolveParams(type, node.params);
  const isDriven = (name: string) => ends.inputs.includes(name) && !Object.hasOwn(type.inputs, name);
  const shown = Object.entries(type.params).filter(
    ([name, spec]) =>
      isDriven(name) ||
      (isParamActive(type, spec, values) && (type.category === 'utility' || Object.hasOwn(node.params, name))),
  );
  const kept = shown.filter(([name], i) => i < MAX_SET_PARAMS || isDriven(name));
  const rows = kept.map(([name, described]): CardRow => {
    const spec = resolveSpec(type, described, values);
    const driven = isDriven(name);
    const value: ParamValue = values[name] ?? spec.default;
    const input = { name, title: spec.title, type: typeOf(name), connected: driven };
    return {
      title: spec.title,
      ...(spec.kind !== 'list' && { input }),
      ...(!driven && { value: displayParam(spec, value) }),
    };
  });
  return { rows, more: shown.length - kept.length };
}
