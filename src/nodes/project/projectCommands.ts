import {
  emptyDocument,
  type Graph,
  type GraphDocument,
  graphIn,
  own,
  type ParamValue,
} from '../../graph/document/document.ts';
import { applyCommand, type Command } from '../../graph/edits/commands.ts';
import { insideGroup } from '../../graph/edits/fragment.ts';
import { FreshKeys } from '../../graph/edits/freshKeys.ts';
import { locateNode } from '../../graph/edits/locateNode.ts';
import { nearestToOutput, nodesFeedingOutput } from './outputChain.ts';

/** Nodes of a new project: id and type, in order of data flow. */
const DEFAULT_NODES = [
  ['read', 'read'],
  ['retime', 'retime'],
  ['scene', 'scene'],
  ['console', 'relativity-console'],
  ['camera', 'scene-camera'],
  ['rasterize', 'relativity-rasterize'],
  ['lighting', 'deferred-lighting'],
  ['toneMap', 'tone-map'],
  ['falseColour', 'false-colour'],
  ['output', 'output'],
] as const;
/** Output and input that connect each node to the next. */
const DEFAULT_EDGES = [
  ['geometry', 'geometry'],
  ['geometry', 'geometry.1'],
  ['scene', 'scene'],
  ['relativity', 'relativity'],
  ['view', 'view'],
  ['gbuffer', 'gbuffer'],
  ['image', 'image'],
  ['image', 'image'],
  ['image', 'image'],
] as const;

/**
 * A project that shows a file: Read → Retime → Scene → Relativity Console → Scene Camera → Relativity Rasterize →
 * Deferred Lighting → Tone Map → False Colour → Output.
 * @example
 * newProject('street.usda').nodes.read.params.source; // 'street.usda'
 */
export function newProject(source = ''): GraphDocument {
  const nodes = DEFAULT_NODES.map(([node, type], i): Command => ({ kind: 'add-node', node, type, at: [i * 240, 0] }));
  const edges = DEFAULT_EDGES.map(([output, input], i): Command => {
    const edge = { from: { node: DEFAULT_NODES[i]![0], output }, to: { node: DEFAULT_NODES[i + 1]![0], input } };
    return { kind: 'connect', edge };
  });
  const file: Command[] = source ? [{ kind: 'set-param', node: 'read', param: 'source', value: source }] : [];
  return applyCommand(emptyDocument(), { kind: 'batch', commands: [...nodes, ...edges, ...file] }).document;
}

/**
 * Sets a parameter of a node given by its evaluation id, in the group definition if it is in one; without a value it is
 * reset to the default.
 * @example
 * import { applyCommand } from 'slowlight/graph';
 * const project = newProject('street.usda');
 * const { document } = applyCommand(project, setParamCommand(project, 'console', 'speedOfLight', 10));
 * document.nodes.console.params.speedOfLight; // 10 m/s
 */
export function setParamCommand(document: GraphDocument, id: string, param: string, value?: ParamValue): Command {
  const { group, node } = locateNode(document, id) ?? { node: id };
  return insideGroup(group, { kind: 'set-param', node, param, ...(value === undefined ? {} : { value }) });
}

/** Scene-specific parameters, which the next scene suggests anew: node type and parameter. */
const SCENE_PARAMS = [
  ['read', 'variants'],
  ['retime', 'speed'],
  ['retime', 'offset'],
  ['relativity-console', 'speedOfLight'],
  ['scene-camera', 'camera'],
  ['scene-camera', 'ride'],
  ['scene-camera', 'fieldOfView'],
] as const;

/**
 * Opens another file in a project; scene-specific parameters are reset to what the new scene suggests. Undefined if
 * there is no read node.
 * @example
 * import { applyCommand } from 'slowlight/graph';
 * const project = newProject('street.usda');
 * const { document } = applyCommand(project, openFileCommand(project, 'dice.usda')!);
 * document.nodes.read.params.source; // 'dice.usda'
 */
export function openFileCommand(document: GraphDocument, source: string): Command | undefined {
  const reader = nearestToOutput(document, 'read');
  if (!reader) return undefined;
  const cleared = SCENE_PARAMS.flatMap(([type, param]) => {
    const node = nearestToOutput(document, type);
    return node ? [setParamCommand(document, node.id, param)] : [];
  });
  return {
    kind: 'batch',
    commands: [
      setParamCommand(document, reader.id, 'source', source),
      ...cleared,
      { kind: 'describe', what: 'lookFor' },
      { kind: 'set-marks', marks: [] },
      ...removeFlightCommands(document),
    ],
  };
}

/** The fly nodes between console and camera, in order of data flow. */
export function flyNodesIn(document: GraphDocument): string[] {
  const nodes = new Map(nodesFeedingOutput(document).map((node) => [node.id, node]));
  const flights: string[] = [];
  let at = nearestToOutput(document, 'scene-camera');
  for (;;) {
    const [source] = at?.inputs.get('relativity') ?? [];
    at = source?.kind === 'output' ? nodes.get(source.node) : undefined;
    if (at?.type !== 'fly' || flights.includes(at.id)) return flights;
    flights.unshift(at.id);
  }
}

/**
 * Makes an object fly with the fly node's defaults; `at`: world time at which it passes its position [s]. Does nothing
 * if there is no node before the camera to attach to.
 * @example
 * import { applyCommand } from 'slowlight/graph';
 * const project = newProject('street.usda');
 * const { document } = applyCommand(project, flyCommand(project, '/Cart', 2));
 * document.nodes.fly1.params.object; // '/Cart'
 */
export function flyCommand(document: GraphDocument, object: string, at: number): Command {
  const camera = nearestToOutput(document, 'scene-camera');
  const place = camera && locateNode(document, camera.id);
  const level = place && graphIn(document, place.group);
  const edge = level && own(level.edges, `${place.node}.relativity`);
  if (!edge) return { kind: 'batch', commands: [] };
  const node = new FreshKeys(level.nodes).next('fly1');
  const [x, y] = level.layout[place.node] ?? [0, 0];
  const commands: Command[] = [
    { kind: 'add-node', node, type: 'fly', at: [x - 120, y + 240], params: at === 0 ? { object } : { object, at } },
    { kind: 'connect', edge: { from: edge.from, to: { node, input: 'relativity' } } },
    { kind: 'connect', edge: { from: { node, output: 'relativity' }, to: edge.to } },
  ];
  return insideGroup(place.group, { kind: 'batch', commands });
}

/** Removes a flight: the object moves as in its file again. */
export const removeFlightCommand = (document: GraphDocument, id: string): Command =>
  removeLinkCommand(document, id, 'relativity');

/** Removes a node, and connects what feeds its `input` directly to all nodes that it feeds. */
export function removeLinkCommand(document: GraphDocument, id: string, input: string): Command {
  const { group, node } = locateNode(document, id) ?? { node: id };
  const commands = [
    ...bypassCommands(graphIn(document, group), node, input),
    { kind: 'remove-nodes', nodes: [node] } as const,
  ];
  return insideGroup(group, { kind: 'batch', commands });
}

function bypassCommands(level: Graph | undefined, node: string, input: string): Command[] {
  const before = level && own(level.edges, `${node}.${input}`);
  if (!before) return [];
  const after = Object.values(level.edges).filter(({ from }) => from.node === node);
  return after.map(({ to }) => ({ kind: 'connect', edge: { from: before.from, to } }));
}

/** Commands each of which is for the document that those before it leave, until there is none. */
export function oneByOne(document: GraphDocument, next: (left: GraphDocument) => Command | undefined): Command[] {
  const commands: Command[] = [];
  let left = document;
  for (let command = next(left); command; command = next(left)) {
    left = applyCommand(left, command).document;
    commands.push(command);
  }
  return commands;
}

const removeFlightCommands = (document: GraphDocument): Command[] =>
  oneByOne(document, (left) => {
    const [flight] = flyNodesIn(left);
    return flight === undefined ? undefined : removeFlightCommand(left, flight);
  });
