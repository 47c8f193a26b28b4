import { expect, test } from 'vitest';
import { makeObject, makeScene } from '../../scene/defaults.ts';
import { plane } from '../../scene/mesh/primitives.ts';
import { lookAtOrientation } from '../../scene/view/camera.ts';
import { perspective } from '../../scene/view/lenses/perspectiveLens.ts';
import type { ViewPoint } from '../../scene/view/view.ts';
import { createTracedScene } from '../intersection/tracedScene.ts';
import { groundGrid } from './groundGrid.ts';

/** A plane of 40 m has a diagonal of 57 m: the grid's step is 1 m. Seen straight down from 5 m, 1 m is 10 pixels wide. */
const floor = createTracedScene(
  makeScene({ name: 'floor', objects: [makeObject({ path: '/F', mesh: plane(40, 40, 'Y') })] }),
  10,
);
const view: ViewPoint = {
  t: 0,
  position: [0.5, 5, 0.5],
  u: [0, 0, 0],
  orientation: lookAtOrientation([0, -1, 0], [0, 0, -1]),
  lens: perspective(Math.PI / 2),
};
const grid = groundGrid(floor, view, 100, 100);
const covered = (x: number, y: number, depth = Number.POSITIVE_INFINITY): number => grid(x, y, depth).cover;

test('lines are a metre apart, every tenth is stronger, and there are none in between', () => {
  // The middle of the picture is x = z = ½ m; the nearest lines are five pixels to either side of it, with others every ten pixels.
  for (const line of [25, 35, 55, 65]) expect(covered(line, 50), String(line)).toBeGreaterThan(0.4);
  for (const between of [30, 50, 60]) expect(covered(between, 50), String(between)).toBe(0);
  expect(covered(45, 50)).toBeGreaterThan(1.3 * covered(55, 50));
});

test('is hidden by nearer surfaces, and absent above the horizon', () => {
  expect(covered(45, 50, 4)).toBe(0);
  const level = groundGrid(floor, { ...view, orientation: [0, 0, 0, 1] }, 100, 100);
  expect(level(50, 20, Number.POSITIVE_INFINITY).cover).toBe(0);
});
