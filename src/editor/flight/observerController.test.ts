import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { rotate } from '../../math/quat.ts';
import { type LoadedScene, workerServices } from '../../nodes/services.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../../scene/defaults.ts';
import { box } from '../../scene/mesh/primitives.ts';
import type { SceneCamera } from '../../scene/types.ts';
import { createEditor, type Editor, projectOfScene } from '../state/editor.ts';
import { ObserverController } from './observerController.ts';

const still = (path: string, x: number): SceneCamera => ({
  path,
  fovY: 1,
  motion: { kind: 'static', pose: { position: [x, 0, 0], orientation: [0, 0, 0, 1] } },
});
const moving: SceneCamera = {
  path: '/ride',
  fovY: 1,
  motion: {
    kind: 'sampled',
    times: Float64Array.of(0, 10),
    poses: Float64Array.of(0, 0, 0, 0, 0, 0, 1, 60, 0, 0, 0, 0, 0, 1),
  },
};
const loaded: LoadedScene = {
  scene: makeScene({
    name: 'a',
    objects: [makeObject({ path: '/Box', mesh: box([6, 2, 6]), motion: restingAt([0, 0, 0]) })],
    materials: [makeMaterial({ name: 'grey' })],
    endTime: 10,
    cameras: [still('/a', 1), still('/b', 5), moving],
    hints: { speedOfLight: 10, openAt: 2 },
  }),
};

let editor: Editor;
let observerController: ObserverController;
const settled = () => new Promise((done) => setTimeout(done));
/** Applies the document's current state. */
async function follow(until?: number): Promise<void> {
  await settled();
  const { picture, pictureSource } = editor.store.getState();
  observerController.setPicture(picture!, pictureSource, until);
}

beforeEach(async () => {
  vi.stubGlobal('navigator', {});
  editor = createEditor({
    services: { ...workerServices, readScene: async () => loaded },
    project: projectOfScene('a.usda'),
    playing: true,
  });
  observerController = new ObserverController(editor);
  await follow();
});
afterEach(() => vi.unstubAllGlobals());

it('starts in the first camera at the scene’s opening time', () => {
  expect(observerController.observer).toMatchObject({ t: 2, position: [1, 0, 0], u: [0, 0, 0] });
});

it('keeps its position through edits, and moves to another chosen camera', async () => {
  observerController.seek(3);
  editor.set('toneMap', 'exposure', 1, 'exposure');
  await follow();
  expect(observerController.observer).toMatchObject({ t: 3, position: [1, 0, 0] });
  editor.set('camera', 'camera', '/b', 'camera');
  await follow();
  expect(observerController.observer).toMatchObject({ t: 3, position: [5, 0, 0] });
});

it('waits at the end of an unfinished simulation, and continues when there is more; at the final end it loops', async () => {
  editor.update({ loop: false });
  await follow(6);
  observerController.seek(5.9);
  observerController.advance(0.25);
  expect(observerController.observer.t).toBe(6);
  const { properTime } = observerController.observer;
  observerController.advance(0.25);
  expect(observerController.observer).toMatchObject({ t: 6, properTime });
  expect(editor.store.getState().playing).toBe(true);
  editor.update({ loop: true });
  await follow();
  observerController.seek(10);
  observerController.advance(0.25);
  expect(observerController.observer.t).toBeCloseTo(0.25, 12);
});

it('follows a camera with its velocity and its dilated time, until a key takes over', async () => {
  editor.set('camera', 'camera', '/ride', 'camera');
  editor.set('camera', 'ride', true, 'ride');
  const { t } = observerController.observer;
  // The ride begins when its path and its clock are loaded.
  await expect
    .poll(async () => {
      await follow();
      observerController.advance(0);
      return observerController.observer.u[0];
    })
    .not.toBe(0);
  expect(observerController.observer.t).toBe(t);
  observerController.advance(1);
  expect(observerController.observer.position[0]).toBeCloseTo(18, 9);
  expect(observerController.observer.u[0]).toBeCloseTo(0.75, 9);
  expect(observerController.observer.properTime).toBeCloseTo(0.8, 9);
  observerController.inputs.press('KeyW');
  observerController.advance(0.1);
  await settled();
  expect(editor.store.getState().picture?.ride).toBe(false);
});

it('time loops at the end, or stops there', () => {
  observerController.seek(9.9);
  observerController.advance(0.25);
  expect(observerController.observer.t).toBeCloseTo(0.15, 9);
  editor.update({ loop: false });
  observerController.seek(9.9);
  observerController.advance(0.25);
  expect(observerController.observer.t).toBe(10);
  expect(editor.store.getState().playing).toBe(false);
  observerController.togglePlaying();
  expect(observerController.observer.t).toBe(0);
});

it('held: the keys move the camera, and neither the observer nor, unless it plays, time; then it goes on', async () => {
  const { toggleHold } = await import('./hold/hold.ts');
  const before = observerController.observer;
  const eye = observerController.viewPoint()!;
  toggleHold(editor, observerController);
  expect(observerController.viewPoint()).toEqual({ ...eye, vantage: [0, 0, 0] });
  const watcher = vi.fn();
  observerController.watcher = watcher;
  observerController.inputs.press('KeyW');
  observerController.advance(0.5);
  const there = observerController.viewPoint()!;
  const { vantage, orientation } = there;
  expect(watcher.mock.lastCall![0].walked).toEqual({
    before: { vantage: [0, 0, 0], orientation: eye.orientation },
    after: { vantage, orientation },
  });
  expect(observerController.observer).toEqual(before);
  expect(there).toMatchObject({ t: before.t, position: before.position, u: before.u });
  expect(Math.hypot(...there.vantage!)).toBeGreaterThan(1);
  editor.update({ playing: true });
  observerController.advance(0.5);
  expect(observerController.observer).toEqual({ ...before, t: before.t + 0.5 });
  observerController.inputs.releaseAll();
  toggleHold(editor, observerController);
  expect(observerController.viewPoint()!.vantage).toBeUndefined();
  observerController.advance(0.01);
  expect(watcher.mock.lastCall![0].walked).toBeUndefined();
  expect(editor.store.getState()).toMatchObject({ held: false, playing: true });
  toggleHold(editor, observerController);
  observerController.restart();
  expect(observerController.held).toBeUndefined();
});

it('notices that it has left the scene, and turns back', async () => {
  expect(observerController.isOutside).toBe(false);
  const { observer } = observerController;
  observerController = new ObserverController(editor, {
    observer: { ...observer, position: [0, 5, 60], u: [0, 0, 2] },
    lock: 'free',
    cruise: true,
  });
  await follow();
  expect(observerController.isOutside).toBe(true);
  observerController.turnBack();
  const { u, orientation, position } = observerController.observer;
  expect(position).toEqual([0, 5, 60]);
  expect(u).toEqual([0, 0, 0]);
  const [x, y, z] = rotate(orientation, [0, 0, -1]);
  expect([x, y, z].map((k) => Math.round(1e9 * k) / 1e9 + 0)).toEqual([0, 0, -1]);
  observerController.restart();
  expect(observerController.isOutside).toBe(false);
});
