import { fromAxisAngle, multiply } from '../../src/math/quat.ts';
import { sphere } from '../../src/scene/mesh/primitives.ts';
import type { Scene } from '../../src/scene/types.ts';
import { at, paint, SceneBuilder, sky, sun } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera, sampled, smoothRamp } from '../kit/flight.ts';
import { checker } from '../kit/paint.ts';
import { block, quad } from '../kit/parts.ts';

/** Side of the floor's squares [m]. */
const SQUARE = 5;
/** Half width and half length of the floor [m]. */
const [HALF, LONG] = [100, 150];

export const scene: ExampleScene = { name: 'cubes', make };

/** The main test scene of the Houdini project that this program follows: a floor of 5 m squares, cubes that move, a ball that turns; all of it checkered. */
function make(): Scene {
  const builder = new SceneBuilder();
  const checkered = (name: string, light: string, dark: string, fields: number, roughness = 0.6): number =>
    builder.material(name, '#ffffff', { texture: checker(light, dark, name, fields, 128 / fields), roughness });
  const floor = checkered('floor', '#e6e4dd', '#53606e', 2, 0.7);
  const [u, v] = [HALF / SQUARE, LONG / SQUARE];
  builder.object('/World/Floor', [
    paint(quad([-HALF, 0, LONG], [HALF, 0, LONG], [HALF, 0, -LONG], [-HALF, 0, -LONG], u, v), floor),
  ]);
  cubes(builder, checkered);
  const ball = builder.material('ball', '#ffffff', {
    texture: checker('#f6efdf', '#c0503c', 'ball', 16, 16),
    roughness: 0.4,
  });
  // Its equator at 0.62 c.
  builder.object(
    '/World/Ball',
    [paint(sphere(3.2, { segments: 64, rings: 32, axis: 'Y' }), ball)],
    sampled(0, 16, 24, (t) => ({
      position: [0.5, 4, 4],
      orientation: multiply(fromAxisAngle([0, 0, 1], -0.25), fromAxisAngle([0, 1, 0], 1.94 * t)),
    })),
  );
  const [from, to] = [0, 16];
  const way = (t: number) => 40 - 92 * smoothRamp(t / to, 0.34);
  const flight = camera({
    from,
    to,
    fovY: 62,
    position: (t) => [-6.5, 5.2, way(t)],
    target: (t) => [-1.5, 2.6, way(t) - 40],
  });
  const hints = {
    speedOfLight: 10,
    title: 'Cubes and a ball',
    lookFor:
      'A floor of 5 m squares, cubes at up to 0.9 c and a ball whose equator turns at 0.62 c. A cube that comes is stretched and blue, one that flees short, red and dark, and one that passes shows its rear. On the ball the squares of the coming side are wide, those of the fleeing side narrow. Fly, and the whole floor bends; the grid (G) stays straight.',
    openAt: 1.2,
  };
  return builder.finish(
    'cubes',
    hints,
    [from, to],
    [flight],
    [sun([-0.5, 0.8, 0.45], '#fff0da', 2.6), sky('#7fa8dc', '#dbe6ee', '#8f948f')],
  );
}

/** Cubes that come, flee and cross, and two at rest. */
function cubes(builder: SceneBuilder, checkered: (name: string, a: string, b: string, fields: number) => number): void {
  const blue = checkered('blue', '#f1ead9', '#2f6f9f', 4);
  const green = checkered('green', '#f1ead9', '#3f7f56', 4);
  const gold = checkered('gold', '#f6edd4', '#c08a2c', 4);
  const cube = (material: number) => [paint(block(3, 3, 3, 1 / 3), material)];
  const lanes: readonly (readonly [name: string, x: number, z: number, speed: number, material: number])[] = [
    ['Coming', -15, 19, 6, blue],
    ['ComingFast', 9, 19, 9, blue],
    ['Fleeing', -19, 8, -4.5, gold],
    ['FleeingFast', 14, -4, -8, gold],
  ];
  for (const [name, x, z, speed, material] of lanes)
    builder.object(`/World/Cube${name}`, cube(material), {
      kind: 'uniform',
      pose: { position: [x, 0, z], orientation: [0, 0, 0, 1] },
      velocity: [0, 0, speed],
    });
  builder.object('/World/CubeCrossing', cube(green), {
    kind: 'uniform',
    pose: { position: [13, 0, 4], orientation: [0, 0, 0, 1] },
    velocity: [7, 0, 0],
  });
  for (const [side, z] of [
    [-1, 16],
    [1, -14],
  ])
    builder.object(`/World/Cube${side < 0 ? 'Left' : 'Right'}`, cube(green), at([8.5 * side, 0, z]));
}
