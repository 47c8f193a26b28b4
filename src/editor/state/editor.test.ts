import { describe, expect, it } from 'vitest';
import { saying } from '../../../tests/support/inWords.ts';
import { applyCommand, type Command } from '../../graph/edits/commands.ts';
import { groupCommand } from '../../graph/edits/group.ts';
import { CancelledError } from '../../graph/evaluation/evaluator.ts';
import { msg } from '../../messages/message.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { newProject } from '../../nodes/project/projectCommands.ts';
import { type Services, workerServices } from '../../nodes/services.ts';
import { makeScene } from '../../scene/defaults.ts';
import { InputError } from '../../scene/types.ts';
import { createEditor, isUnsaved, projectOfScene, sourceOf } from './editor.ts';

const settled = () => new Promise((done) => setTimeout(done, 2));
const refused = new InputError({
  severity: 'error',
  code: 'file.empty',
  place: 'bad.usda',
  message: msg`the file is empty`,
});

/** Reads any file at once, refuses `bad.usda`, and never finishes `slow.usda`. */
const services: Services = {
  ...workerServices,
  readScene: (source, { signal, progress }) => {
    if (source === 'bad.usda') return Promise.reject(refused);
    if (source !== 'slow.usda') return Promise.resolve({ scene: makeScene({ name: source }) });
    progress(0.5, 'parse');
    return new Promise((_resolve, reject) => signal?.addEventListener('abort', () => reject(new Error('stopped'))));
  },
};

async function open(...sources: string[]) {
  const editor = createEditor({ services, project: projectOfScene(sources[0]!), playing: false });
  await settled();
  for (const source of sources.slice(1)) {
    editor.open(source);
    await settled();
  }
  return { editor, state: () => editor.store.getState() };
}

it('the last valid scene stays when another is rejected, and undo removes the error', async () => {
  const { editor, state } = await open('a.usda', 'bad.usda');
  expect(state()).toMatchObject({
    pictureSource: { source: 'a.usda' },
    notices: [{ place: 'bad.usda', text: msg`the file is empty` }],
  });
  expect(state().picture?.scene.name).toBe('a.usda');
  editor.undo();
  await settled();
  expect(state().notices).toEqual([]);
});

it('reading can be cancelled: the previous scene and document are restored', async () => {
  const { editor, state } = await open('a.usda', 'slow.usda');
  expect(state().loading).toEqual({ node: 'read', source: 'slow.usda', part: 0.5, stage: 'parse' });
  editor.cancelLoading();
  await settled();
  expect(state()).toMatchObject({ pictureSource: { source: 'a.usda' }, loading: undefined });
  expect(sourceOf(state().history.document)).toBe('a.usda');
});

it('reading with another variant can be cancelled: the choice is undone', async () => {
  let stopped = 0;
  const slowRed: Services = {
    ...workerServices,
    readScene: (source, { variants, signal }) =>
      variants?.get('paint') !== 'red'
        ? Promise.resolve({ scene: makeScene({ name: source }) })
        : new Promise((_resolve, reject) => {
            signal?.addEventListener('abort', () => {
              stopped++;
              reject(new Error('stopped'));
            });
          }),
  };
  const editor = createEditor({ services: slowRed, project: projectOfScene('a.usda'), playing: false });
  const variants = () => editor.store.getState().history.document.nodes.read?.params.variants;
  await settled();
  editor.set('read', 'variants', ['paint=blue'], 'edit.variant');
  await settled();
  editor.set('read', 'variants', ['paint=red'], 'edit.variant');
  editor.set('toneMap', 'exposure', 1, 'exposure');
  await settled();
  editor.cancelLoading();
  await settled();
  expect([stopped, variants()]).toEqual([1, ['paint=blue']]);
  expect(editor.store.getState()).toMatchObject({ loading: undefined, pictureSource: { source: 'a.usda' } });
});

it('an edit while a scene is read does not restart reading; another file cancels it', async () => {
  const { editor, state } = await open('a.usda', 'slow.usda');
  editor.set('toneMap', 'exposure', 1, 'exposure');
  await settled();
  expect(state().loading?.source).toBe('slow.usda');
  editor.open('b.usda');
  await settled();
  expect(state()).toMatchObject({ pictureSource: { source: 'b.usda' }, loading: undefined, notices: [] });
  expect(state().picture?.scene.name).toBe('b.usda');
});

it('a reference render continues through unrelated edits; changes of its own inputs restart it', async () => {
  const traced: { readonly seed: unknown; stopped: boolean; readonly done: () => void }[] = [];
  const tracing: Services = {
    ...services,
    renderStill: ({ options: { seed }, width, height }, { signal, progress }) =>
      new Promise((done, reject) => {
        const job = { seed, stopped: false, done: () => done(new Float32Array(3 * width * height)) };
        traced.push(job);
        progress(0.25, 'trace');
        signal?.addEventListener('abort', () => {
          job.stopped = true;
          reject(new CancelledError());
        });
      }),
  };
  const editor = createEditor({ services: tracing, project: projectOfScene('a.usda'), playing: false });
  const state = () => editor.store.getState();
  await settled();
  const edge = (from: string, output: string, to: string, input: string): Command => ({
    kind: 'connect',
    edge: { from: { node: from, output }, to: { node: to, input } },
  });
  const before = state().picture;
  editor.edit(
    {
      kind: 'batch',
      commands: [
        { kind: 'add-node', node: 'truth', type: 'reference-render', at: [0, 0] },
        edge('rasterize', 'gbuffer', 'truth', 'gbuffer'),
        edge('truth', 'image', 'toneMap', 'image'),
      ],
    },
    'add',
  );
  await settled();
  expect(state().loading).toMatchObject({ node: 'truth', part: 0.25, stage: 'trace' });
  expect(state().picture).toBe(before);
  editor.set('toneMap', 'exposure', 1, 'exposure');
  await settled();
  expect(traced).toMatchObject([{ seed: 0, stopped: false }]);
  editor.set('truth', 'seed', 5, 'seed');
  await settled();
  expect(traced).toMatchObject([{ stopped: true }, { seed: 5, stopped: false }]);
  traced[1]?.done();
  await settled();
  expect(state()).toMatchObject({ loading: undefined, notices: [], picture: { exposure: 1 } });
  expect(state().picture?.frameGraph?.passes).toMatchObject([{ kind: 'still', still: { width: 480, height: 270 } }]);
  editor.set('truth', 'seed', 6, 'seed');
  await settled();
  editor.cancelLoading();
  await settled();
  expect(traced[2]?.stopped).toBe(true);
  expect(state().loading).toBeUndefined();
  expect(state().picture?.frameGraph).toBeDefined();
});

it('a node in a group is edited in the group’s definition, and invalid values are reported', async () => {
  const { editor, state } = await open('a.usda');
  const grouping = groupCommand(state().history.document, { nodes: ['toneMap'] }, 'Picture', nodeLibrary);
  editor.edit(grouping.command, 'group');
  editor.set('group/toneMap', 'exposure', 2, 'exposure');
  await settled();
  expect(state().picture?.exposure).toBe(2);
  expect(state().history.document.groups.group?.nodes.toneMap?.params).toEqual({ exposure: 2 });
  // What is said again is not shown twice.
  for (let i = 0; i < 2; i++) editor.set('group/gone', 'exposure', 2, 'exposure');
  expect(state().notices).toMatchObject([{ kind: 'error', text: saying('there is no node "group/gone"') }]);
});

describe('projects', () => {
  const other = { document: newProject('b.usda'), origin: 'other.slowlight.json', unsaved: false };

  it('opening one in place of another can be undone and redone', async () => {
    const { editor, state } = await open('a.usda');
    editor.openProject(other);
    await settled();
    expect(state().pictureSource).toMatchObject({ origin: 'other.slowlight.json', source: 'b.usda' });
    editor.undo();
    await settled();
    expect(state().pictureSource).toMatchObject({ origin: '', source: 'a.usda' });
    editor.redo();
    await settled();
    expect(state().pictureSource.origin).toBe('other.slowlight.json');
  });

  it('one that cannot be shown keeps the last picture, and the reason is reported', async () => {
    const { editor, state } = await open('a.usda');
    const output: Command = { kind: 'remove-nodes', nodes: ['output'] };
    editor.openProject({ ...other, document: applyCommand(other.document, output).document });
    await settled();
    expect(state().picture?.scene.name).toBe('a.usda');
    expect(state().notices).toMatchObject([{ text: saying('no output node'), ofDocument: true }]);
    editor.openProject({ ...other, document: newProject('bad.usda') });
    await settled();
    expect(state()).toMatchObject({
      unreadableNode: 'read',
      pictureSource: { source: 'a.usda' },
      notices: [{ place: 'bad.usda' }],
    });
  });

  it('reading one can be cancelled: the previous one is restored, whatever was changed meanwhile', async () => {
    const { editor, state } = await open('a.usda');
    editor.openProject({ ...other, document: newProject('slow.usda') });
    editor.set('toneMap', 'exposure', 1, 'exposure');
    await settled();
    editor.cancelLoading();
    await settled();
    expect(state()).toMatchObject({ loading: undefined, history: { origin: '' } });
    expect(sourceOf(state().history.document)).toBe('a.usda');
  });

  it('a scene opened in a project without a file node gets a new project', async () => {
    const { editor, state } = await open('a.usda');
    editor.edit({ kind: 'remove-nodes', nodes: ['read'] }, 'remove');
    editor.open('b.usda');
    await settled();
    expect(state().pictureSource.source).toBe('b.usda');
    editor.undo();
    expect(state().history.document.nodes.read).toBeUndefined();
  });

  it('unsaved changes are marked until saved or undone; viewing a scene is no change', async () => {
    const { editor, state } = await open('a.usda', 'b.usda');
    expect(isUnsaved(state())).toBe(false);
    editor.set('toneMap', 'exposure', 1, 'exposure', 'drag');
    expect(isUnsaved(state())).toBe(true);
    editor.markSaved();
    expect(isUnsaved(state())).toBe(false);
    editor.set('toneMap', 'exposure', 2, 'exposure');
    editor.undo();
    expect(isUnsaved(state())).toBe(false);
    editor.undo();
    expect(isUnsaved(state())).toBe(true);
    editor.redo();
    expect(isUnsaved(state())).toBe(false);
    editor.openProject({ ...other, unsaved: true });
    expect(isUnsaved(state())).toBe(true);
  });
});

it('a faulty shader text of a node that leads nowhere is marked, without a notice', async () => {
  const { editor, state } = await open('a.usda');
  const params = { effect: 'written', text: 'fn effect(p: Pixel) -> vec4f { return 1; }' };
  editor.edit({ kind: 'add-node', node: 'alone', type: 'post-process', at: [0, 0], params }, msg`add`);
  await expect
    .poll(() => state().results.get('alone'))
    .toMatchObject({ status: 'failed', problem: { place: 'alone' } });
  expect(state().notices).toEqual([]);
  editor.set('alone', 'effect', 'gaussian-blur', msg`set`);
  await expect.poll(() => state().results.has('alone')).toBe(false);
});
