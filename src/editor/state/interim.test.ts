import { beforeEach, expect, it, vi } from 'vitest';
import { saying } from '../../../tests/support/inWords.ts';
import type { RunRecord } from '../../dynamics/runRecord.ts';
import { applyCommand, type Command } from '../../graph/edits/commands.ts';
import { CancelledError, type HeavyRequest } from '../../graph/evaluation/evaluator.ts';
import type { Outputs } from '../../graph/nodeType.ts';
import { inEnglish, msg } from '../../messages/message.ts';
import { newProject } from '../../nodes/project/projectCommands.ts';
import { type Services, workerServices } from '../../nodes/services.ts';
import { makeScene } from '../../scene/defaults.ts';
import { createEditor } from './editor.ts';

/** Heavy work controlled by the test. */
interface Led extends HeavyRequest {
  readonly give: (name: string) => void;
  readonly end: (name: string, more?: Outputs) => void;
  readonly progress: (part: number) => void;
  stopped: boolean;
}
const led = vi.hoisted((): Led[] => []);
const outputs = (name: string): Outputs => ({ geometry: { scene: makeScene({ name, endTime: name.length }) } });
vi.mock('./heavyWorkers.ts', () => ({
  heavyWorkers:
    () =>
    (order: HeavyRequest, work: { signal?: AbortSignal; progress: Led['progress']; interim: (of: Outputs) => void }) =>
      new Promise<Outputs>((done, fail) => {
        const progress = (part: number) => (work.progress as (part: number, what: string) => void)(part, 'simulate');
        const give = (name: string) => work.interim(outputs(name));
        const job: Led = {
          ...order,
          give,
          end: (name, more) => done({ ...outputs(name), ...more }),
          progress,
          stopped: false,
        };
        led.push(job);
        work.signal?.addEventListener('abort', () => {
          job.stopped = true;
          fail(new CancelledError());
        });
      }),
}));

const edge = (from: string, to: string, input: string): Command => ({
  kind: 'connect',
  edge: { from: { node: from, output: 'geometry' }, to: { node: to, input } },
});
const document = applyCommand(newProject('a.usda'), {
  kind: 'batch',
  commands: [
    { kind: 'add-node', node: 'work', type: 'subdivide', at: [0, 0] },
    edge('retime', 'work', 'geometry'),
    edge('work', 'scene', 'geometry.1'),
  ],
}).document;
const services: Services = { ...workerServices, readScene: async () => ({ scene: makeScene({ name: 'a' }) }) };
const settled = () => new Promise((done) => setTimeout(done, 30));

async function open(of = document) {
  const editor = createEditor({ services, project: { document: of, origin: 'p', unsaved: false }, playing: false });
  await settled();
  return {
    editor,
    state: () => editor.store.getState(),
    end: () => editor.store.getState().picture?.scene.endTime,
  };
}
beforeEach(() => {
  led.length = 0;
});

it('the picture shows the motion computed so far', async () => {
  const { state, end } = await open();
  led[0]!.progress(0.25);
  expect(state()).toMatchObject({ loading: { node: 'work', part: 0.25, stage: 'simulate' } });
  expect(state().picture).toBeUndefined();
  led[0]!.give('ab');
  await expect.poll(() => state().interim).toBe('running');
  expect(state()).toMatchObject({ pictureSource: { origin: 'p' }, loading: { part: 0.25 } });
  expect(end()).toBe(2);
  expect(state().results.get('work')).toMatchObject({ status: 'done', interim: true });
  led[0]!.give('abc');
  led[0]!.give('abcd');
  await expect.poll(() => end()).toBe(4);
  led[0]!.end('abcdef');
  await settled();
  expect([state().loading, state().interim, state().notices]).toEqual([undefined, undefined, []]);
  expect(end()).toBe(6);
  expect(led).toHaveLength(1);
});

it('stopped work keeps its state through edits, and resumes from there on request', async () => {
  const { editor, state, end } = await open();
  led[0]!.give('abc');
  await settled();
  editor.cancelLoading();
  await settled();
  expect(led[0]!.stopped).toBe(true);
  expect(state().interim).toBe('stopped');
  expect(state().loading).toBeUndefined();
  expect(end()).toBe(3);
  expect(state().history.document).toBe(document);
  editor.set('toneMap', 'exposure', 1, 'exposure');
  await settled();
  expect(state()).toMatchObject({ interim: 'stopped', picture: { exposure: 1 } });
  expect(led).toHaveLength(1);

  editor.resumeWork();
  await settled();
  expect(led[1]).toMatchObject({ interims: true, resume: outputs('abc') });
  expect(state()).toMatchObject({ interim: 'running' });
  led[1]!.end('abcdef');
  await settled();
  expect(state().interim).toBeUndefined();
  expect(end()).toBe(6);
});

it('other work starts although some is stopped; the stopped state is kept', async () => {
  const { editor, state, end } = await open();
  led[0]!.give('abc');
  await settled();
  editor.cancelLoading();
  await settled();
  editor.set('work', 'levels', 2, 'levels');
  await settled();
  expect(led[1]).toMatchObject({ params: { levels: 2 } });
  expect(led[1]!.resume).toBeUndefined();
  led[1]!.give('ab');
  await settled();
  expect(state().interim).toBe('running');
  editor.undo();
  await settled();
  expect([led.length, led[1]!.stopped]).toEqual([2, true]);
  expect(state().interim).toBe('stopped');
  expect(state().loading).toBeUndefined();
  expect(end()).toBe(3);
});

it('work without an interim result is cancelled', async () => {
  const { editor, state } = await open();
  editor.cancelLoading();
  await settled();
  expect(led[0]!.stopped).toBe(true);
  expect(state().loading).toBeUndefined();
  expect(state().picture).toBeUndefined();
});

it('cancelling stops newly started work, and does not restart it', async () => {
  const { editor, state } = await open();
  led[0]!.give('abc');
  await settled();
  editor.set('work', 'levels', 2, 'levels');
  await settled();
  editor.cancelLoading();
  await settled();
  expect(led.map(({ stopped }) => stopped)).toEqual([true, true]);
  expect(state()).toMatchObject({ interim: 'stopped' });
  expect(state().loading).toBeUndefined();
});

it('a run that stopped early is reported once', async () => {
  const { editor, state } = await open();
  const zero = Float64Array.of(0);
  const stop = { t: 1.5, message: msg`too fast` };
  const books = { kinetic: zero, total: zero, fastest: zero, times: zero, dragLoss: zero, stop };
  led[0]!.end('abc', { books });
  await settled();
  expect(state().notices).toMatchObject([
    { kind: 'warning', place: 'work', text: saying(/^it ended at t = 1\.500 s: too fast$/) },
  ]);
  editor.set('toneMap', 'exposure', 1, 'exposure');
  await settled();
  expect(state().notices).toEqual([]);
});

/** A run that lost half of its energy. */
const fading: RunRecord = {
  ...{
    method: 'leapfrog',
    speedOfLight: 10,
    step: 0.1,
    hasKinematic: false,
    steps: Float64Array.of(0, 1, 2),
    corrected: 0,
  },
  times: Float64Array.of(0, 1, 2),
  total: Float64Array.of(10, 7, 5),
  kinetic: Float64Array.of(0, 10, 5),
  potential: Float64Array.of(10, 0, 0),
  dragLoss: new Float64Array(3),
  fastest: Float64Array.of(0, 1, 1),
  pace: 1,
  momentum: new Float64Array(9),
  angularMomentum: new Float64Array(9),
};

it('what went wrong with runs is told once: of one at its node, of several in one notice, also where some ended before', async () => {
  const alone = await open();
  led[0]!.end('abc', { books: fading });
  await settled();
  const { notices } = alone.state();
  expect(notices.map(({ place }) => place)).toEqual(['work']);
  expect(inEnglish(notices[0]!.text)).toMatch(/^from t = 1\.000 s on energy is missing/);

  led.length = 0;
  const more = { kind: 'add-node', node: 'more', type: 'subdivide', at: [0, 0], params: { levels: 2 } } as const;
  const both = {
    kind: 'batch',
    commands: [more, edge('retime', 'more', 'geometry'), edge('more', 'scene', 'geometry.2')],
  } as const;
  const { editor, state } = await open(applyCommand(document, both).document);
  expect(led).toHaveLength(2);
  led[0]!.end('abc', { books: { ...fading } });
  await settled();
  led[1]!.give('ab');
  await settled();
  expect(state()).toMatchObject({ interim: 'running', notices: [] });
  led[1]!.end('abc', { books: { ...fading } });
  await settled();
  expect(state().notices.map(({ text }) => inEnglish(text))).toEqual([
    'Simulations that ended early, or whose energy went wrong: 2 of 2. The Energy panel says of each what and why.',
  ]);
  editor.set('toneMap', 'exposure', 1, 'exposure');
  await settled();
  expect(state().notices).toEqual([]);
});
