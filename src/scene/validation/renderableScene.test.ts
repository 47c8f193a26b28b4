import { expect, it } from 'vitest';
import { saying } from '../../../tests/support/inWords.ts';
import { makeObject, makeScene, restingAt } from '../defaults.ts';
import { box } from '../mesh/primitives.ts';
import { renderableScene } from './renderableScene.ts';

const mesh = box([1, 1, 1]);
const object = (path: string, change: object = {}) => makeObject({ path, mesh, ...change });

it('skips objects that cannot be rendered, and reports them', () => {
  const beyond = { ...mesh, indices: Uint32Array.of(0, 1, 99) };
  const backwards = {
    motion: { ...restingAt([0, 0, 0]), kind: 'sampled', times: Float64Array.of(1, 0), poses: new Float64Array(14) },
  };
  const { scene, diagnostics } = renderableScene(
    makeScene({
      name: 'a',
      objects: [object('/bad', { mesh: beyond }), object('/back', backwards), object('/good')],
    }),
  );
  expect(scene.objects.map(({ path }) => path)).toEqual(['/good']);
  expect(scene.diagnostics).toMatchObject([
    { severity: 'warning', code: 'mesh.index', place: '/bad', message: saying(/; it is left out$/) },
    { severity: 'warning', code: 'motion.times', place: '/back' },
  ]);
  expect(diagnostics).toEqual([]);
});

it('keeps the first of two objects with the same path', () => {
  const [first, second] = [object('/a'), object('/a', { mesh: box([2, 2, 2]) })];
  const { scene } = renderableScene(makeScene({ name: 'b', objects: [first, second, object('/b')] }));
  expect(scene.objects.map((one) => [one.path, one.mesh === mesh])).toEqual([
    ['/a', true],
    ['/b', true],
  ]);
});

it('objects that are too fast or have warnings stay; a valid scene is returned unchanged', () => {
  const velocity = [4e8, 0, 0] as const;
  const fast = object('/fast', { motion: { ...restingAt([0, 0, 0]), kind: 'uniform', velocity } });
  const flat = object('/flat', { mesh: { ...mesh, indices: Uint32Array.of(0, 0, 0, ...mesh.indices) } });
  const whole = makeScene({ name: 'c', objects: [fast, flat] });
  const { scene, diagnostics } = renderableScene(whole);
  expect(scene).toBe(whole);
  expect(diagnostics).toMatchObject([{ severity: 'warning', code: 'mesh.degenerate', place: '/flat' }]);
});
