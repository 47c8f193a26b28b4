import { fromAxisAngle, multiply } from '../../src/math/quat.ts';
import { random } from '../../src/math/random.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { sphere } from '../../src/scene/primitives.ts';
import type { Scene } from '../../src/scene/types.ts';
import { at, compose, daylight, type Part, paint, place, placePart, SceneBuilder } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera, cruise, sampled } from '../kit/flight.ts';
import { type House, house, type Scheme } from '../kit/houses.ts';
import { bricks, Canvas, checker, roofTiles, tone } from '../kit/paint.ts';
import { block, column, join, moved, quad, roundedBox, turned } from '../kit/parts.ts';

/** Half the width of the road, and of the space between the houses [m]. */
const ROAD = 5;
const FRONT = 9;
const LENGTH = 120;

const schemes: readonly Scheme[] = [
  { wall: '#d9b382', trim: '#efe6d3', door: '#3d5a52', shutter: '#5d7a6b' },
  { wall: '#c9796a', trim: '#f0e4d2', door: '#4a3a33' },
  { wall: '#e3d8c0', trim: '#b9a98a', door: '#7c3b34', shutter: '#7f98a6' },
  { wall: '#9fb0b5', trim: '#edeae2', door: '#2e4057' },
  { wall: '#dcc56f', trim: '#f3ead2', door: '#5a3d2b', shutter: '#4d6b4f' },
  { wall: '#b98f9b', trim: '#efe3df', door: '#39424e' },
];

export const scene: ExampleScene = { name: 'street', make };

function make(): Scene {
  const builder = new SceneBuilder();
  ground(builder);
  for (const side of [-1, 1]) row(builder, side);
  avenue(builder);
  movers(builder);
  const [from, to] = [0, 14];
  const flight = camera({
    from,
    to,
    fovY: 60,
    eye: (t) => [1.1 * Math.sin(0.22 * t), 1.9, 46 - 84 * cruise(t / to, 0.34)],
    target: (t) => [0.8 * Math.sin(0.22 * t), 2.5, 46 - 84 * cruise(t / to, 0.34) - 20],
  });
  const hints = {
    speedOfLight: 10,
    title: 'Street',
    lookFor:
      'Fly down the street at 0.9 c. Everything crowds towards where you are going: you see house fronts that you have already passed. Doors, lamps and columns bend, while kerbs and eaves along your way stay straight. What is ahead turns blue and bright, what is behind red and dark.',
    openAt: 1.2,
  };
  return builder.finish('street', hints, [from, to], [flight], daylight([0.55, 0.75, 0.42]));
}

/** Checkered in fields of 5 m from house to house, with raised pavements. */
function ground(builder: SceneBuilder): void {
  const floor = builder.material('floor', '#ffffff', {
    texture: checker('#c9c2b4', '#6f7377', 'floor', 2, 64),
    roughness: 0.85,
  });
  const grass = builder.material('grass', '#7d9160', { roughness: 1 });
  const kerb = builder.material('kerb', '#b7b1a6', { roughness: 0.9 });
  const paving = builder.material('paving', '#ffffff', { texture: slabs(), roughness: 0.9 });
  const end = LENGTH / 2;
  builder.object('/World/Road', [
    paint(quad([-ROAD, 0, end], [ROAD, 0, end], [ROAD, 0, -end], [-ROAD, 0, -end], 1, LENGTH / 10), floor),
  ]);
  for (const side of [-1, 1]) {
    const width = FRONT - ROAD - 0.25;
    const walk = block(width, 0.15, LENGTH, 0.5, [side * (ROAD + 0.25 + width / 2), 0, 0]);
    const stone = block(0.25, 0.16, LENGTH, 1, [side * (ROAD + 0.125), 0, 0]);
    builder.object(`/World/Pavement${side < 0 ? 'Left' : 'Right'}`, [paint(walk, paving), paint(stone, kerb)]);
  }
  const lawn = (x0: number, x1: number) =>
    quad([x0, -0.03, end], [x1, -0.03, end], [x1, -0.03, -end], [x0, -0.03, -end]);
  builder.object(
    '/World/Grass',
    [lawn(-60, -FRONT), lawn(FRONT, 60)].map((m) => paint(m, grass)),
  );
}

function slabs() {
  const canvas = new Canvas(128, 128, '#a9a398');
  const next = random(5);
  for (let j = 0; j < 4; j++)
    for (let i = 0; i < 4; i++)
      canvas.rect(i * 32 + 1, j * 32 + 1, i * 32 + 31, j * 32 + 31, tone('#b5afa3', 0.92 + 0.14 * next()));
  return canvas.grain(0.03, 2).texture('slabs');
}

function row(builder: SceneBuilder, side: number): void {
  const roof = builder.material('roof', '#ffffff', {
    texture: roofTiles(side < 0 ? '#9c5b45' : '#6d6a70', `roof_${side < 0 ? 'left' : 'right'}`),
    roughness: 0.9,
  });
  const materials = {
    roof,
    stone: builder.material('stone', '#c5beb1', { roughness: 0.9 }),
    chimney: builder.material('chimney', '#ffffff', {
      texture: bricks('#93594a', '#b8aca0', 'bricks'),
      roughness: 0.95,
    }),
  };
  const next = random(side < 0 ? 21 : 34);
  let z = LENGTH / 2 - 4;
  for (let i = 0; z > -LENGTH / 2 + 6; i++) {
    const style: House = {
      width: 7 + Math.round(next() * 3),
      floors: 2 + Math.round(next()),
      bays: 3,
      scheme: schemes[(i * 2 + (side < 0 ? 0 : 3) + (i >> 2)) % schemes.length],
    };
    const name = `House${side < 0 ? 'Left' : 'Right'}${i}`;
    const part = house(builder, name, style, materials, 100 * (side + 2) + i);
    const m = place([side * FRONT, 0, z - style.width / 2], side < 0 ? Math.PI / 2 : -Math.PI / 2);
    builder.object(`/World/${name}`, placePart(part, m));
    z -= style.width + (i % 3 === 2 ? 3.2 : 0.06);
  }
}

/** Columns, lamps and trees along both pavements. */
function avenue(builder: SceneBuilder): void {
  const marble = builder.material('marble', '#e9e4d8', { roughness: 0.55 });
  const iron = builder.material('iron', '#2d3234', { roughness: 0.5, metallic: 0.6 });
  const lamp = builder.material('lamp', '#fff4d6', { emissive: '#ffdf9e' });
  const bark = builder.material('bark', '#6b5442', { roughness: 1 });
  const leaf = builder.material('leaf', '#5f8a45', { roughness: 0.95 });
  const columnPart: Part = [
    paint(column(4.6, 0.36), marble),
    paint(moved(sphere(0.34, { segments: 20, axis: 'Y' }), [0, 4.95, 0]), marble),
  ];
  const lampPart = lampPost(iron, lamp);
  for (const side of [-1, 1])
    for (let k = 0; k < 6; k++) {
      const z = 45 - 18 * k;
      const label = `${side < 0 ? 'Left' : 'Right'}${k}`;
      builder.object(`/World/Column${label}`, placePart(columnPart, place([side * 5.9, 0.15, z])));
      builder.object(
        `/World/Lamp${label}`,
        placePart(lampPart, place([side * 5.7, 0.15, z - 9], side < 0 ? 0 : Math.PI)),
      );
      builder.object(
        `/World/Tree${label}`,
        placePart(tree(bark, leaf, k + 7 * (side + 1)), place([side * 6.9, 0.15, z - 4.5])),
      );
    }
}

function lampPost(iron: number, lamp: number): Part {
  const post = turned(
    [
      [0.16, 0],
      [0.16, 0.25],
      [0.1, 0.35],
      [0.07, 0.6],
      [0.05, 3.1],
      [0.09, 3.15],
      [0.09, 3.2],
      [0.16, 3.3],
    ],
    10,
  );
  const hood = turned(
    [
      [0.26, 3.8],
      [0.27, 3.84],
      [0.04, 4.02],
      [0, 4.12],
    ],
    10,
  );
  const glass = turned(
    [
      [0.15, 3.3],
      [0.24, 3.8],
    ],
    10,
  );
  return [paint(post, iron), paint(hood, iron), paint(glass, lamp)];
}

function tree(bark: number, leaf: number, seed: number): Part {
  const next = random(seed);
  const trunk = turned(
    [
      [0.17, 0],
      [0.11, 0.9],
      [0.08, 2.4],
    ],
    8,
  );
  const crown = Array.from({ length: 5 }, (_, i) => {
    const a = i * 2.4 + next();
    const r = i === 0 ? 0 : 0.55;
    return moved(sphere(0.75 + 0.3 * next(), { segments: 14, rings: 8, axis: 'Y' }), [
      r * Math.cos(a),
      2.9 + 0.6 * next() + (i === 0 ? 0.5 : 0),
      r * Math.sin(a),
    ]);
  });
  return [paint(trunk, bark), paint(join(crown), leaf)];
}

/** Three cubes under way, and a ball that turns on a plinth. */
function movers(builder: SceneBuilder): void {
  const stone = builder.material('plinth', '#d8d2c4', { roughness: 0.7 });
  const colors: readonly [string, string][] = [
    ['#d1603d', '#f3e9d8'],
    ['#2f7f86', '#f3e9d8'],
    ['#e0a93b', '#463f3a'],
  ];
  const cubes = colors.map(([dark, light], i) =>
    builder.material(`cube${i}`, '#ffffff', { texture: checker(light, dark, `cube${i}`, 4, 32), roughness: 0.45 }),
  );
  const cube = (i: number, size = 1.7): Part => [paint(roundedBox([size, size, size], 0.06), cubes[i])];

  builder.object(
    '/World/CubeAcross',
    cube(0),
    sampled(0, 14, 30, (t) => ({
      position: [3.1 * Math.sin(2.2 * t), 1.15, 22],
      orientation: fromAxisAngle([0, 1, 0], 0.5),
    })),
  );
  builder.object('/World/CubeAhead', cube(1), {
    kind: 'uniform',
    pose: { position: [-2.6, 1.15, 40], orientation: fromAxisAngle([0, 1, 0], 0.2) },
    velocity: [0, 0, -3.5],
  });
  builder.object('/World/CubeOncoming', cube(2), {
    kind: 'uniform',
    pose: { position: [2.7, 1.15, -78], orientation: fromAxisAngle([0, 1, 0], -0.3) },
    velocity: [0, 0, 5],
  });

  const ball = builder.material('globe', '#ffffff', { texture: globe(), roughness: 0.35 });
  const middle: Vec3 = [0, 3.1, -32];
  builder.object(
    '/World/Plinth',
    placePart(
      [
        paint(
          turned(
            [
              [1.5, 0],
              [1.5, 0.3],
              [1.1, 0.45],
              [1.0, 1.2],
              [1.25, 1.35],
              [1.25, 1.5],
            ],
            32,
          ),
          stone,
        ),
      ],
      compose(place([0, 0, -32])),
    ),
    at([0, 0, 0]),
  );
  const tilt = fromAxisAngle([0, 0, 1], -0.3);
  builder.object(
    '/World/Globe',
    [paint(sphere(1.5, { segments: 56, rings: 28, axis: 'Y' }), ball)],
    sampled(0, 14, 30, (t) => ({ position: middle, orientation: multiply(tilt, fromAxisAngle([0, 1, 0], 4.5 * t)) })),
  );
}

function globe() {
  return new Canvas(256, 128, '#ffffff')
    .shade((u, v) => {
      const field = (Math.floor(u * 12) + Math.floor(v * 6)) % 2 === 0;
      const line = Math.abs(((u * 12) % 1) - 0.5) > 0.46 || Math.abs(((v * 6) % 1) - 0.5) > 0.46;
      return line ? '#26323a' : field ? '#e8e0cf' : '#b8493a';
    })
    .texture('globe');
}
