import { applyCommand, type Command } from '../graph/commands.ts';
import { emptyDocument, type GraphDocument } from '../graph/document.ts';

/** The chain that a new project starts with: node id and type, in the order of the flow. */
const CHAIN = [
  ['read', 'read'],
  ['scene', 'scene'],
  ['console', 'relativity-console'],
  ['camera', 'scene-camera'],
  ['rasterize', 'relativity-rasterize'],
  ['toneMap', 'tone-map'],
  ['output', 'output'],
] as const;
/** The socket that joins each node of the chain to the next. */
const JOINTS = ['scene', 'scene', 'relativity', 'view', 'gbuffer', 'image'] as const;

/** Read → Scene → Relativity Console → Scene Camera → Relativity Rasterize → Tone Map → Output. */
export function newProject(source = ''): GraphDocument {
  const nodes = CHAIN.map(([node, type], i): Command => ({ kind: 'add-node', node, type, at: [i * 240, 0] }));
  const edges = JOINTS.map((socket, i): Command => {
    const edge = { from: { node: CHAIN[i]![0], output: socket }, to: { node: CHAIN[i + 1]![0], input: socket } };
    return { kind: 'connect', edge };
  });
  const file: Command[] = source ? [{ kind: 'set-param', node: 'read', param: 'source', value: source }] : [];
  return applyCommand(emptyDocument(), { kind: 'batch', commands: [...nodes, ...edges, ...file] }).document;
}

/** Opens another file in a project: what the person had set for the last scene gives way to what the new one suggests. */
export function openCommand(source: string): Command {
  const set = (node: string, param: string, value?: string): Command => ({
    kind: 'set-param',
    node,
    param,
    ...(value === undefined ? {} : { value }),
  });
  const commands = [
    set('read', 'source', source),
    set('console', 'speedOfLight'),
    set('camera', 'camera'),
    set('camera', 'ride'),
    set('camera', 'fieldOfView'),
  ];
  return { kind: 'batch', commands };
}
