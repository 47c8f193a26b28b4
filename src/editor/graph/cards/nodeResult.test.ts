import { expect, it } from 'vitest';
import type { GraphDocument } from '../../../graph/document/document.ts';
import { applyCommand, type Command } from '../../../graph/edits/commands.ts';
import { groupCommand } from '../../../graph/edits/group.ts';
import { Evaluator } from '../../../graph/evaluation/evaluator.ts';
import { nodeLibrary } from '../../../nodes/library.ts';
import { newProject } from '../../../nodes/project/projectCommands.ts';
import type { LoadedScene } from '../../../nodes/services.ts';
import { workerServices } from '../../../nodes/services.ts';
import { nodeResultOf } from './nodeResult.ts';

const edited = (document: GraphDocument, ...commands: Command[]): GraphDocument =>
  commands.reduce((held, command) => applyCommand(held, command).document, document);
const grouped = (document: GraphDocument, nodes: readonly string[]): GraphDocument =>
  edited(document, groupCommand(document, { nodes }, 'Group', nodeLibrary).command);
const readScene = () => Promise.reject(new Error('there are no files'));
const evaluated = async (document: GraphDocument) =>
  (await new Evaluator(nodeLibrary).evaluate(document, ['output', 'scene'], { ...workerServices, readScene })).results;

/** A box with a motion, in place of the file. */
const boxes = edited(newProject(''), {
  kind: 'batch',
  commands: [
    { kind: 'add-node', node: 'box', type: 'box', at: [0, 0], params: { name: 'A' } },
    { kind: 'add-node', node: 'moved', type: 'transform', at: [0, 0], params: {} },
    { kind: 'disconnect', to: { node: 'scene', input: 'geometry.1' } },
    {
      kind: 'connect',
      edge: { from: { node: 'box', output: 'geometry' }, to: { node: 'moved', input: 'geometry' } },
    },
    {
      kind: 'connect',
      edge: { from: { node: 'moved', output: 'geometry' }, to: { node: 'scene', input: 'geometry.1' } },
    },
  ],
});

const outcome = async (document: GraphDocument, id: string) =>
  nodeResultOf(await evaluated(document), document, id, document.nodes[id]);

it('of a group is that of its first output, also through a nested group', async () => {
  const once = grouped(boxes, ['box', 'moved']);
  const twice = grouped(once, ['group']);
  for (const document of [once, twice]) {
    const [id] = Object.entries(document.nodes).find(([, { type }]) => type === 'group')!;
    const found = await outcome(document, id);
    expect(found?.status).toBe('done');
    const [given] = Object.values((found as { outputs: Record<string, LoadedScene> }).outputs);
    expect(given!.scene.objects.map(({ path }) => path)).toEqual(['/A']);
  }
});

it('of a group of images is its last image', async () => {
  const document = grouped(boxes, ['lighting', 'toneMap']);
  const found = (await outcome(document, 'group')) as { outputs: Record<string, unknown> };
  expect(Object.values(found.outputs)[0]).toMatchObject({ step: { kind: 'tone' } });
});

it('of a group with a failed node is blocked, and of a muted one undefined', async () => {
  const broken = edited(boxes, { kind: 'set-param', node: 'box', param: 'width', value: -1 });
  const document = grouped(broken, ['box']);
  expect(await outcome(document, 'group')).toMatchObject({ status: 'blocked' });
  const muted = edited(grouped(boxes, ['moved']), { kind: 'mute', nodes: ['group'], muted: true });
  expect(await outcome(muted, 'group')).toBeUndefined();
});
