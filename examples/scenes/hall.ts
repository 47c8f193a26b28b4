import { fromAxisAngle, multiply } from '../../src/math/quat.ts';
import { sphere } from '../../src/scene/mesh/primitives.ts';
import type { Light, Scene, Texture } from '../../src/scene/types.ts';
import { type Part, paint, place, placePart, SceneBuilder, sky } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera, sampled, smoothRamp } from '../kit/flight.ts';
import { Canvas, checker, linear } from '../kit/paint.ts';
import { block, column, moved, quad, roundedBox, turned } from '../kit/parts.ts';

/** Half width, height and half length of the hall [m]. */
const [W, H, L] = [7, 9, 32];
/** Half width of the opening along the ceiling, through which all light enters [m]. */
const SKYLIGHT = 3;

export const scene: ExampleScene = { name: 'hall', make };

function make(): Scene {
  const builder = new SceneBuilder();
  shell(builder);
  colonnade(builder);
  centrepiece(builder);
  const [from, to] = [0, 9];
  const way = (t: number) => 27 - 44 * smoothRamp(t / to, 0.34);
  const flight = camera({
    from,
    to,
    fovY: 68,
    position: (t) => [1.8 - 0.4 * Math.cos(0.3 * t), 2.3, way(t)],
    target: (t) => [0.4, 3, way(t) - 18],
  });
  const hints = {
    speedOfLight: 10,
    title: 'Hall',
    lookFor:
      'Every tile is two metres square. Stand still and the lines are straight; give yourself a velocity (Tab, then W) and walls bow outwards, the far wall recedes, and tiles behind your shoulder come into view.',
    openAt: 0,
  };
  const [r, g, b] = linear('#fff0da');
  const lights: Light[] = [
    { kind: 'distant', path: '/World/Sun', direction: [-0.35, -0.82, -0.45], color: [r * 1.9, g * 1.9, b * 1.9] },
    sky('#b4c8e6', '#e8ecee', '#a09c92'),
  ];
  return builder.finish('hall', hints, [from, to], [flight], lights);
}

/** Tiles of 2 m with a thin joint. */
function tiles(light: string, dark: string, joint: string, name: string): Texture {
  const canvas = new Canvas(128, 128, joint);
  for (const [i, j] of [
    [0, 0],
    [1, 1],
    [1, 0],
    [0, 1],
  ])
    canvas.rect(i * 64 + 1, j * 64 + 1, i * 64 + 63, j * 64 + 63, i === j ? light : dark);
  return canvas.grain(0.02, 4).texture(name);
}

function shell(builder: SceneBuilder): void {
  const floor = builder.material('floor', '#ffffff', {
    texture: tiles('#e8e2d4', '#4a5560', '#8f8a80', 'floor'),
    roughness: 0.35,
  });
  const wall = builder.material('wall', '#ffffff', {
    texture: tiles('#e9dcc3', '#b9684f', '#cbb89a', 'wall'),
    roughness: 0.8,
  });
  const end = builder.material('end', '#ffffff', {
    texture: tiles('#e9dcc3', '#3e7c82', '#cbb89a', 'end'),
    roughness: 0.8,
  });
  const ceiling = builder.material('ceiling', '#ffffff', {
    texture: tiles('#f2ede1', '#d9cfb9', '#b5aa94', 'ceiling'),
    roughness: 0.9,
  });
  const trim = builder.material('trim', '#d8cdb8', { roughness: 0.7 });
  const [w, l] = [(2 * W) / 4, (2 * L) / 4];
  builder.object('/World/Floor', [paint(quad([-W, 0, L], [W, 0, L], [W, 0, -L], [-W, 0, -L], w, l), floor)]);
  const halves = [
    [-W, -SKYLIGHT],
    [SKYLIGHT, W],
  ].map(([a, b]) => paint(quad([a, H, -L], [b, H, -L], [b, H, L], [a, H, L], (b - a) / 4, l), ceiling));
  builder.object('/World/Ceiling', [...halves, ...beams(trim)]);
  const sides = [
    quad([-W, 0, L], [-W, 0, -L], [-W, H, -L], [-W, H, L], l, H / 4),
    quad([W, 0, -L], [W, 0, L], [W, H, L], [W, H, -L], l, H / 4),
  ];
  builder.object(
    '/World/Walls',
    sides.map((m) => paint(m, wall)),
  );
  const ends = [
    quad([-W, 0, -L], [W, 0, -L], [W, H, -L], [-W, H, -L], w, H / 4),
    quad([W, 0, L], [-W, 0, L], [-W, H, L], [W, H, L], w, H / 4),
  ];
  builder.object(
    '/World/Ends',
    ends.map((m) => paint(m, end)),
  );
  const skirting = [-1, 1].map((side) => paint(block(0.12, 0.35, 2 * L, 1, [side * (W - 0.06), 0, 0]), trim));
  const cornice = [-1, 1].map((side) => paint(block(0.5, 0.35, 2 * L, 1, [side * (W - 0.25), H - 0.35, 0]), trim));
  builder.object('/World/Trim', [...skirting, ...cornice]);
}

const beams = (material: number): Part =>
  Array.from({ length: 9 }, (_, k) => paint(block(2 * W, 0.4, 0.35, 1, [0, H - 0.4, -28 + 7 * k]), material));

function colonnade(builder: SceneBuilder): void {
  const stone = builder.material('stone', '#ded7c8', { roughness: 0.5 });
  const part: Part = [paint(column(H - 0.4, 0.42), stone)];
  for (const side of [-1, 1])
    for (let k = 0; k < 9; k++)
      builder.object(
        `/World/Column${side < 0 ? 'Left' : 'Right'}${k}`,
        placePart(part, place([side * 5.6, 0, -28 + 7 * k])),
      );
}

/** The checkered cube, turning above its plinth, and two balls. */
function centrepiece(builder: SceneBuilder): void {
  const cube = builder.material('cube', '#ffffff', {
    texture: checker('#f4efe4', '#27313a', 'cube', 4, 32),
    roughness: 0.4,
  });
  const ball = builder.material('ball', '#ffffff', {
    texture: checker('#f0c66b', '#2e5d63', 'ball', 8, 16),
    roughness: 0.35,
  });
  const stone = builder.material('plinth', '#c9c1b2', { roughness: 0.6 });
  const plinth = turned(
    [
      [1.5, 0],
      [1.5, 0.22],
      [1.2, 0.34],
      [1.1, 0.9],
      [1.35, 1.02],
      [1.35, 1.16],
    ],
    40,
  );
  builder.object('/World/Plinth', placePart([paint(plinth, stone)], place([0, 0, -14])));
  const tilt = multiply(fromAxisAngle([1, 0, 0], 0.615), fromAxisAngle([0, 0, 1], Math.PI / 4));
  builder.object(
    '/World/Cube',
    [paint(roundedBox([1.8, 1.8, 1.8], 0.05), cube)],
    sampled(0, 9, 30, (t) => ({
      position: [0, 3.1, -14],
      orientation: multiply(fromAxisAngle([0, 1, 0], 1.6 * t), tilt),
    })),
  );
  for (const side of [-1, 1]) {
    const globe = moved(sphere(0.8, { segments: 40, rings: 20, axis: 'Y' }), [side * 3.4, 0.8, 6]);
    builder.object(`/World/Ball${side < 0 ? 'Left' : 'Right'}`, [paint(globe, ball)]);
  }
}
