import { random } from '../../src/math/random.ts';
import type { Mesh, Scene } from '../../src/scene/types.ts';
import { at, daylight, type Part, paint, SceneBuilder } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera, smoothRamp } from '../kit/flight.ts';
import { block, join, quad } from '../kit/parts.ts';

/** Boxes along the side of a field, the distance of their centres [m], and the fields. */
const [BOXES, PITCH] = [6, 6];
const FIELD = BOXES * PITCH;
const [COLUMNS, ROWS] = [5, 10];

export const scene: ExampleScene = { name: 'boxes', make };

/** As the simple box-shaped test scene of the immersive paper in its size: 19,800 triangles, without textures. */
function make(): Scene {
  const builder = new SceneBuilder();
  const colors = ['#c7694f', '#e2b85e', '#6f9c76', '#4f7f9c', '#d9d2c3'].map((color, i) =>
    builder.material(`paint${i}`, color, { roughness: 0.75 }),
  );
  // Four fields, one seed each: equal meshes are stored once.
  const fields = [1, 2, 3, 4].map((seed) => field(colors, seed));
  for (let row = 0; row < ROWS; row++)
    for (let column = 0; column < COLUMNS; column++)
      builder.object(
        `/World/Field${row}_${column}`,
        fields[(3 * row + column) % 4],
        // Half a pitch aside: the middle one is free to fly through.
        at([(column - COLUMNS / 2 + 0.5) * FIELD + PITCH / 2, 0, -row * FIELD]),
      );
  const ground = builder.material('ground', '#8d8f86', { roughness: 0.95 });
  const [x, near, far] = [(COLUMNS * FIELD) / 2 + 20, 60, -ROWS * FIELD];
  builder.object('/World/Ground', [
    paint(quad([-x, -0.02, near], [x, -0.02, near], [x, -0.02, far], [-x, -0.02, far]), ground),
  ]);
  const [from, to] = [0, 20];
  const way = (t: number) => 28 - 118 * smoothRamp(t / to, 0.34);
  const flight = camera({
    from,
    to,
    fovY: 65,
    position: (t) => [0, 3.4, way(t)],
    target: (t) => [0, 3.2, way(t) - 20],
  });
  const hints = {
    speedOfLight: 10,
    title: 'Boxes',
    lookFor:
      'Nothing but boxes with straight edges and flat faces, so that every bend is the light’s. From 0.9 c on the sides that face away from you come into view, and the rows ahead close to a small bright disc.',
    openAt: 7,
  };
  return builder.finish('boxes', hints, [from, to], [flight], daylight([0.6, 0.7, 0.35]));
}

/** 6 × 6 boxes of different heights, with streets between them. */
function field(materials: readonly number[], seed: number): Part {
  const next = random(seed);
  const meshes = materials.map((): Mesh[] => []);
  for (let i = 0; i < BOXES; i++)
    for (let j = 0; j < BOXES; j++) {
      const height = 1 + 4.5 * next() ** 2;
      const width = 2 + 1.6 * next();
      const [x, z] = [i, j].map((k) => (k - (BOXES - 1) / 2) * PITCH);
      meshes[Math.floor(materials.length * next())].push(block(width, height, width, 1, [x, 0, z]));
    }
  return meshes.flatMap((boxes, k) => (boxes.length > 0 ? [paint(join(boxes), materials[k])] : []));
}
