import { expect, it } from 'vitest';
import { noFiles } from '../../../tests/support/noFiles.ts';
import { groupingOf } from '../../graph/edits/group.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import type { Services } from '../../nodes/services.ts';
import { makeScene } from '../../scene/defaults.ts';
import { InputError } from '../../scene/types.ts';
import { createStudio, sourceOf } from './studio.ts';

const settled = () => new Promise((done) => setTimeout(done, 2));
const refused = new InputError({
  severity: 'error',
  code: 'file.empty',
  place: 'bad.usda',
  message: 'the file is empty',
});

/** Reads anything at once, refuses `bad.usda`, and never finishes `slow.usda`. */
const services: Services = {
  ...noFiles,
  readScene: (source, { signal, progress }) => {
    if (source === 'bad.usda') return Promise.reject(refused);
    if (source !== 'slow.usda') return Promise.resolve({ scene: makeScene({ name: source }) });
    progress(0.5, 'parse');
    return new Promise((_resolve, reject) => signal?.addEventListener('abort', () => reject(new Error('stopped'))));
  },
};

async function open(...sources: string[]) {
  const studio = createStudio({ services, source: sources[0]!, playing: false });
  await settled();
  for (const source of sources.slice(1)) {
    studio.open(source);
    await settled();
  }
  return { studio, state: () => studio.store.getState() };
}

it('the last good scene stays while another is refused, and undo takes the refusal away', async () => {
  const { studio, state } = await open('a.usda', 'bad.usda');
  expect(state()).toMatchObject({ openSource: 'a.usda', notices: [{ place: 'bad.usda', text: 'the file is empty' }] });
  expect(state().picture?.scene.name).toBe('a.usda');
  studio.undo();
  await settled();
  expect(state().notices).toEqual([]);
});

it('reading can be cancelled: the scene before it stays, and the document is its own again', async () => {
  const { studio, state } = await open('a.usda', 'slow.usda');
  expect(state().loading).toEqual({ source: 'slow.usda', part: 0.5, stage: 'parse' });
  studio.cancelLoading();
  await settled();
  expect(state()).toMatchObject({ openSource: 'a.usda', loading: undefined });
  expect(sourceOf(state().history.document)).toBe('a.usda');
});

it('reading again with another variant can be cancelled: the choice is taken back', async () => {
  let stopped = 0;
  const slowRed: Services = {
    ...noFiles,
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
  const studio = createStudio({ services: slowRed, source: 'a.usda', playing: false });
  const variants = () => studio.store.getState().history.document.nodes.read?.params.variants;
  await settled();
  studio.set('read', 'variants', ['paint=blue'], 'edit.variant');
  await settled();
  studio.set('read', 'variants', ['paint=red'], 'edit.variant');
  studio.set('toneMap', 'exposure', 1, 'exposure');
  await settled();
  studio.cancelLoading();
  await settled();
  expect([stopped, variants()]).toEqual([1, ['paint=blue']]);
  expect(studio.store.getState()).toMatchObject({ loading: undefined, openSource: 'a.usda' });
});

it('an edit while a scene is read does not begin the reading anew; another file ends it', async () => {
  const { studio, state } = await open('a.usda', 'slow.usda');
  studio.set('toneMap', 'exposure', 1, 'exposure');
  await settled();
  expect(state().loading?.source).toBe('slow.usda');
  studio.open('b.usda');
  await settled();
  expect(state()).toMatchObject({ openSource: 'b.usda', loading: undefined, notices: [] });
  expect(state().picture?.scene.name).toBe('b.usda');
});

it('a node in a group is set where its definition is, and what does not fit is told', async () => {
  const { studio, state } = await open('a.usda');
  const grouping = groupingOf(state().history.document, { nodes: ['toneMap'] }, 'Picture', nodeLibrary);
  studio.edit(grouping.command, 'group');
  studio.set('group/toneMap', 'exposure', 2, 'exposure');
  await settled();
  expect(state().picture?.exposure).toBe(2);
  expect(state().history.document.groups.group?.nodes.toneMap?.params).toEqual({ exposure: 2 });
  studio.set('group/gone', 'exposure', 2, 'exposure');
  expect(state().notices).toMatchObject([{ kind: 'error', text: 'there is no node "group/gone"' }]);
});
