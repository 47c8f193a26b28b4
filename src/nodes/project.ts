import { applyCommand, type Command } from '../graph/commands.ts';
import { emptyDocument, type Graph, type GraphDocument, graphIn, own, type ParamValue } from '../graph/document.ts';
import { inside } from '../graph/edits/fragment.ts';
import { FreshKeys } from '../graph/edits/fresh.ts';
import { placeOf } from '../graph/edits/place.ts';
import { chainOf, nearestOf } from './chain.ts';

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

/** Sets a parameter of a node that an evaluation names, where its definition is; without a value it goes back to its default. */
export function setCommand(document: GraphDocument, id: string, param: string, value?: ParamValue): Command {
  const { group, node } = placeOf(document, id) ?? { node: id };
  return inside(group, { kind: 'set-param', node, param, ...(value === undefined ? {} : { value }) });
}

/** What a person set for one scene, and the next one suggests anew: node type and parameter. */
const OF_SCENE = [
  ['read', 'variants'],
  ['retime', 'speed'],
  ['retime', 'offset'],
  ['relativity-console', 'speedOfLight'],
  ['scene-camera', 'camera'],
  ['scene-camera', 'ride'],
  ['scene-camera', 'fieldOfView'],
] as const;

/**
 * Opens another file in a project: what the person had set for the last scene gives way to what the new one suggests. Undefined where no
 * node reads a file.
 */
export function openCommand(document: GraphDocument, source: string): Command | undefined {
  const reader = nearestOf(document, 'read');
  if (!reader) return undefined;
  const cleared = OF_SCENE.flatMap(([type, param]) => {
    const node = nearestOf(document, type);
    return node ? [setCommand(document, node.id, param)] : [];
  });
  return {
    kind: 'batch',
    commands: [
      setCommand(document, reader.id, 'source', source),
      ...cleared,
      { kind: 'describe', what: 'lookFor' },
      ...landings(document),
    ],
  };
}

/** The fly nodes between console and camera, in the order of the flow. */
export function flightsIn(document: GraphDocument): string[] {
  const nodes = new Map(chainOf(document).map((node) => [node.id, node]));
  const flights: string[] = [];
  let at = nearestOf(document, 'scene-camera');
  for (;;) {
    const [source] = at?.inputs.get('relativity') ?? [];
    at = source?.kind === 'output' ? nodes.get(source.node) : undefined;
    if (at?.type !== 'fly' || flights.includes(at.id)) return flights;
    flights.unshift(at.id);
  }
}

/**
 * Lets a thing fly, as the node's defaults have it; `at`: the world time at which it passes its place [s]. Does nothing
 * where no camera is given what could fly.
 */
export function flyCommand(document: GraphDocument, object: string, at: number): Command {
  const camera = nearestOf(document, 'scene-camera');
  const place = camera && placeOf(document, camera.id);
  const level = place && graphIn(document, place.group);
  const edge = level && own(level.edges, `${place.node}.relativity`);
  if (!edge) return { kind: 'batch', commands: [] };
  const node = new FreshKeys(level.nodes).take('fly1');
  const [x, y] = level.layout[place.node] ?? [0, 0];
  const commands: Command[] = [
    { kind: 'add-node', node, type: 'fly', at: [x - 120, y + 240], params: at === 0 ? { object } : { object, at } },
    { kind: 'connect', edge: { from: edge.from, to: { node, input: 'relativity' } } },
    { kind: 'connect', edge: { from: { node, output: 'relativity' }, to: edge.to } },
  ];
  return inside(place.group, { kind: 'batch', commands });
}

/** Takes a flight out: the thing moves as its file says again. */
export function landCommand(document: GraphDocument, id: string): Command {
  const { group, node } = placeOf(document, id) ?? { node: id };
  const commands = [...joinedWithout(graphIn(document, group), node), { kind: 'remove-nodes', nodes: [node] } as const];
  return inside(group, { kind: 'batch', commands });
}

/** What a node is fed goes to all that it feeds. */
function joinedWithout(level: Graph | undefined, node: string): Command[] {
  const before = level && own(level.edges, `${node}.relativity`);
  if (!before) return [];
  const after = Object.values(level.edges).filter(({ from }) => from.node === node);
  return after.map(({ to }) => ({ kind: 'connect', edge: { from: before.from, to } }));
}

/** Takes all flights out, one after the other. */
function landings(document: GraphDocument): Command[] {
  const commands: Command[] = [];
  let left = document;
  for (let [flight] = flightsIn(left); flight !== undefined; [flight] = flightsIn(left)) {
    const command = landCommand(left, flight);
    left = applyCommand(left, command).document;
    commands.push(command);
  }
  return commands;
}
