// @vitest-environment jsdom
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { saying } from '../../../tests/support/inWords.ts';
import { workerServices } from '../../nodes/services.ts';
import { makeScene } from '../../scene/defaults.ts';
import { ObserverController } from '../flight/observerController.ts';
import { LocalFiles } from '../loading/localFiles.ts';
import { createEditor, type Editor, projectOfScene } from '../state/editor.ts';
import { Autosave, type AutosaveFailure } from './autosave.ts';
import type { SessionRecord, SessionStore } from './sessionStore.ts';

const sessions = {
  save: vi.fn<(session: SessionRecord) => Promise<void>>(async () => {}),
  saveFiles: vi.fn(async () => {}),
  delete: vi.fn<(id: string) => Promise<void>>(async () => {}),
};
let editor: Editor;
let localFiles: LocalFiles;
let reported: AutosaveFailure[];
let autosave: Autosave;

beforeEach(async () => {
  vi.useFakeTimers();
  vi.clearAllMocks();
  sessions.save.mockResolvedValue();
  vi.stubGlobal('navigator', {});
  reported = [];
  localFiles = new LocalFiles();
  const services = { ...workerServices, readScene: async (name: string) => ({ scene: makeScene({ name }) }) };
  editor = createEditor({ services, project: projectOfScene('a.usda'), playing: false });
  await vi.advanceTimersByTimeAsync(10);
  const store = sessions as unknown as SessionStore;
  const address = () => '/?scene=a.usda';
  autosave = new Autosave({
    editor,
    observerController: new ObserverController(editor),
    localFiles,
    sessions: store,
    id: 'tab',
    address,
  });
  autosave.onFailure = (failure) => reported.push(failure);
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

const expose = (exposure: number) => editor.set('toneMap', 'exposure', exposure, 'exposure', 'drag');
const exposureKept = () => {
  const { document } = sessions.save.mock.lastCall?.[0] ?? {};
  return (document as ReturnType<typeof projectOfScene>['document']).nodes.toneMap?.params.exposure;
};

it('nothing is stored without edits; of a drag the last edit, at the latest after two seconds', async () => {
  dispatchEvent(new Event('pagehide'));
  expect(sessions.save).not.toHaveBeenCalled();
  for (let i = 1; i <= 30; i++) {
    expose(i / 10);
    await vi.advanceTimersByTimeAsync(100);
  }
  expect(sessions.save).toHaveBeenCalledTimes(1);
  await vi.advanceTimersByTimeAsync(400);
  expect(sessions.save).toHaveBeenCalledTimes(2);
  expect(exposureKept()).toBe(3);
  expect(sessions.save.mock.lastCall?.[0]).toMatchObject({
    id: 'tab',
    address: '/?scene=a.usda',
    unsaved: true,
    name: 'a',
  });
});

it('an edit is stored immediately when the page is left', () => {
  expose(1);
  dispatchEvent(new Event('pagehide'));
  expect(exposureKept()).toBe(1);
});

it('files are stored once; too large ones are reported, and everything else is stored', async () => {
  editor.open(localFiles.add(new Map([['s.usda', new Blob(['x'])]]), 's.usda'));
  await vi.advanceTimersByTimeAsync(400);
  expose(1);
  await vi.advanceTimersByTimeAsync(400);
  expect(sessions.saveFiles.mock.calls).toEqual([['tab', '1', localFiles.setOf('local:1/s.usda')?.files]]);
  const large = Object.defineProperty(new Blob(['x']), 'size', { value: 2 ** 30 });
  editor.open(localFiles.add(new Map([['big.usda', large]]), 'big.usda'));
  await vi.advanceTimersByTimeAsync(400);
  expect(await autosave.saveNow()).toBe(false);
  expect(sessions.saveFiles).toHaveBeenCalledTimes(1);
  expect(sessions.save.mock.lastCall?.[0].name).toBe('big');
  expect(reported).toEqual([{ kind: 'files', size: '1.00 GiB' }]);
});

it('full storage is reported once, and again after a success', async () => {
  sessions.save.mockRejectedValue(new Error('no room is left'));
  for (const exposure of [1, 2]) {
    expose(exposure);
    expect(await autosave.saveNow()).toBe(false);
  }
  expect(reported).toEqual([{ kind: 'work', why: saying(/^no room is left$/) }]);
  sessions.save.mockResolvedValue();
  expect(await autosave.saveNow()).toBe(true);
  sessions.save.mockRejectedValue(new Error('gone'));
  await autosave.saveNow();
  expect(reported).toHaveLength(2);
});

it('unsaved projects are set aside with their files when another one is opened; the latest three are kept', async () => {
  editor.open(localFiles.add(new Map([['s.usda', new Blob(['x'])]]), 's.usda'));
  editor.openProject(projectOfScene('b.usda'));
  await vi.advanceTimersByTimeAsync(400);
  const others = () => sessions.save.mock.calls.map(([session]) => session).filter(({ id }) => id !== 'tab');
  expect(others(), 'of who only looked').toEqual([]);
  editor.undo();
  await vi.advanceTimersByTimeAsync(400);
  expose(1);
  editor.openProject(projectOfScene('b.usda'));
  await vi.advanceTimersByTimeAsync(400);
  const [replaced] = others();
  expect(replaced).toMatchObject({ name: 's', unsaved: true, passed: true });
  expect(replaced?.document).toMatchObject({ nodes: { toneMap: { params: { exposure: 1 } } } });
  expect(sessions.saveFiles).toHaveBeenCalledWith(replaced?.id, '1', localFiles.setOf('local:1/s.usda')?.files);
  editor.undo();
  editor.redo();
  await vi.advanceTimersByTimeAsync(400);
  expect(others(), 'doing it again').toHaveLength(1);
  for (const exposure of [2, 3, 4]) {
    expose(exposure);
    editor.openProject(projectOfScene('c.usda'));
    await vi.advanceTimersByTimeAsync(400);
  }
  expect(others()).toHaveLength(4);
  expect(sessions.delete.mock.calls).toEqual([[replaced?.id]]);
});
