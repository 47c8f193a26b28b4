import { applyCommand, type Command } from '../graph/commands.ts';
import { edgeKey, emptyDocument, type GraphDocument, type GraphEdge, type ParamValue } from '../graph/document.ts';

/** The chain that a new project starts with: node id and type, in the order of the flow. */
const CHAIN = [
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
/** The output and the input that join each node of the chain to the next. */
const JOINTS = [
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

/** Read → Retime → Scene → Relativity Console → Scene Camera → Relativity Rasterize → Deferred Lighting → Tone Map → False Colour → Output. */
export function newProject(source = ''): GraphDocument {
  const nodes = CHAIN.map(([node, type], i): Command => ({ kind: 'add-node', node, type, at: [i * 240, 0] }));
  const edges = JOINTS.map(([output, input], i): Command => {
    const edge = { from: { node: CHAIN[i]![0], output }, to: { node: CHAIN[i + 1]![0], input } };
    return { kind: 'connect', edge };
  });
  const file: Command[] = source ? [{ kind: 'set-param', node: 'read', param: 'source', value: source }] : [];
  return applyCommand(emptyDocument(), { kind: 'batch', commands: [...nodes, ...edges, ...file] }).document;
}

const set = (node: string, param: string, value?: ParamValue): Command => ({
  kind: 'set-param',
  node,
  param,
  ...(value === undefined ? {} : { value }),
});

/** Opens another file in a project: what the person had set for the last scene gives way to what the new one suggests. */
export function openCommand(document: GraphDocument, source: string): Command {
  const commands = [
    set('read', 'source', source),
    set('read', 'variants'),
    set('retime', 'speed'),
    set('retime', 'offset'),
    set('console', 'speedOfLight'),
    set('camera', 'camera'),
    set('camera', 'ride'),
    set('camera', 'fieldOfView'),
    ...landings(document, flightsIn(document)),
  ];
  return { kind: 'batch', commands };
}

/** The same files with others beside them: all that was set stays. */
export const supplyCommand = (source: string): Command => set('read', 'source', source);

/** Where flights are: between the console, which knows c, and the camera. */
const BEFORE = 'console';
const AFTER = { node: 'camera', input: 'relativity' };
const connect = (from: string, to: GraphEdge['to']): Command => ({
  kind: 'connect',
  edge: { from: { node: from, output: 'relativity' }, to },
});

/** The fly nodes of a document, in the order of the flow. */
export function flightsIn({ nodes, edges }: GraphDocument): string[] {
  const found: string[] = [];
  let at = edges[edgeKey(AFTER)]?.from.node;
  while (at !== undefined && nodes[at]?.type === 'fly' && !found.includes(at)) {
    found.unshift(at);
    at = edges[edgeKey({ node: at, input: 'relativity' })]?.from.node;
  }
  return found;
}

/** Lets a thing fly, as the node's defaults have it; `at`: the world time at which it passes its place [s]. */
export function flyCommand(document: GraphDocument, object: string, at: number): Command {
  const flights = flightsIn(document);
  let number = 1;
  while (document.nodes[`fly${number}`]) number++;
  const node = `fly${number}`;
  const commands: Command[] = [
    { kind: 'add-node', node, type: 'fly', at: [number * 240, 240] },
    connect(flights.at(-1) ?? BEFORE, { node, input: 'relativity' }),
    connect(node, AFTER),
    set(node, 'object', object),
    ...(at === 0 ? [] : [set(node, 'at', at)]),
  ];
  return { kind: 'batch', commands };
}

/** Takes a flight out: the thing moves as its file says again. */
export const landCommand = (document: GraphDocument, node: string): Command => ({
  kind: 'batch',
  commands: landings(document, [node]),
});

function landings(document: GraphDocument, landed: readonly string[]): Command[] {
  if (landed.length === 0) return [];
  const left = flightsIn(document).filter((node) => !landed.includes(node));
  const chain = [BEFORE, ...left];
  return [
    ...landed.map((node): Command => ({ kind: 'remove-nodes', nodes: [node] })),
    ...left.map((node, i) => connect(chain[i]!, { node, input: 'relativity' })),
    connect(chain.at(-1)!, AFTER),
  ];
}
