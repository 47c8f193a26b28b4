import { fromParts } from '../../src/math/mat4.ts';
import { fromAxisAngle, IDENTITY, multiply, type Quat, toMatrix } from '../../src/math/quat.ts';
import { random } from '../../src/math/random.ts';
import { ZERO } from '../../src/math/vec3.ts';
import { transformMesh } from '../../src/scene/mesh/meshOps.ts';
import { revolve, type SurfaceBand } from '../../src/scene/mesh/primitives.ts';
import type { Mesh, Motion, Scene } from '../../src/scene/types.ts';
import { at, daylight, type Part, paint, SceneBuilder } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera } from '../kit/flight.ts';
import { Canvas } from '../kit/paint.ts';
import { block, join, moved, quad, roundedBox } from '../kit/parts.ts';

/** Speed of light that the scene suggests [m/s]. */
const C = 5;
/** Time at which both rows pass the centre of the table [s]. */
const MEETING = 8;
const HALF_TABLE = 34;

export const scene: ExampleScene = { name: 'dice', make };

function make(): Scene {
  const builder = new SceneBuilder();
  table(builder);
  const wine = builder.material('pipWine', '#7d1f26', { roughness: 0.5, emissive: '#b03a26' });
  const light = builder.material('pipLight', '#f6eedd', { roughness: 0.5 });
  const die = (name: string, color: string, pip: number, glow = '#000000'): Part => {
    const body = builder.material(name, color, { roughness: 0.28, emissive: glow });
    return [paint(roundedBox([1, 1, 1], 0.1, 2), body), paint(pips(), pip)];
  };
  const red = die('red', '#a02f2c', light);
  // They and their pips glow slightly: hardly any light of the room reaches the rear of receding dice.
  const ivory = die('ivory', '#f0e7d2', wine, '#665c48');
  const blue = die('blue', '#2f5f78', light);

  for (let k = 0; k < 7; k++)
    builder.object(`/World/Ivory${k}`, ivory, passing(2 * (k - 3), 0, 0.8 * C), { authoredIn: 'rest' });
  for (let k = 0; k < 5; k++)
    builder.object(`/World/Blue${k}`, blue, passing(2.6 * (k - 2), -2.8, 0.5 * C), { authoredIn: 'rest' });
  const next = random(6);
  for (let k = 0; k < 5; k++) {
    const turn = fromAxisAngle([0, 1, 0], (next() - 0.5) * 0.9);
    builder.object(`/World/Still${k}`, red, at([2.9 * (k - 2.4), 0.5, 2.6], multiply(turn, quarter(next))));
  }

  const [from, to] = [0, 16];
  const eye = (t: number): [number, number, number] => [4.6 + 0.08 * (t - MEETING), 3.1, 8.4];
  const flight = camera({ from, to, fovY: 40, position: eye, target: (t) => [0.3 + 0.08 * (t - MEETING), 0.35, -0.2] });
  const hints = {
    speedOfLight: C,
    title: 'Dice',
    lookFor:
      'The ivory dice come towards you at 0.8 c, and yet you see their rear, the six: they do not look flattened but turned (Terrell rotation, by arcsin 0.8 = 53° where they are abreast of you). The blue ones go at 0.5 c, the red ones rest. The simultaneity view shows the ivory ones 0.6 as long.',
    openAt: 9.3,
  };
  return builder.finish('dice', hints, [from, to], [flight], daylight([0.25, 0.85, 0.6]));
}

/** Motion along x in the lane at z that passes x at MEETING. */
const passing = (x: number, z: number, velocity: number): Motion => ({
  kind: 'uniform',
  pose: { position: [x - velocity * MEETING, 0.5, z], orientation: IDENTITY },
  velocity: [velocity, 0, 0],
});

/** One of the four orientations on a side, for dice that look thrown. */
const quarter = (next: () => number): Quat => fromAxisAngle([0, 0, 1], (Math.PI / 2) * Math.floor(4 * next()));

/** Positions of the pips on a face, in units of the distance from the centre to the corner pips. */
const CORNERS: readonly (readonly [number, number])[] = [
  [-1, -1],
  [1, 1],
  [-1, 1],
  [1, -1],
  [-1, 0],
  [1, 0],
];
const faceOf = (value: number): (readonly [number, number])[] => [
  ...(value % 2 === 1 ? [[0, 0] as const] : []),
  ...CORNERS.slice(0, value - (value % 2)),
];

/** Opposite faces add to seven; one, two and three are counterclockwise around their corner: +x, +y, +z. */
const FACES: readonly { readonly value: number; readonly turn: Quat }[] = [
  { value: 1, turn: fromAxisAngle([0, 1, 0], Math.PI / 2) },
  { value: 6, turn: fromAxisAngle([0, 1, 0], -Math.PI / 2) },
  { value: 2, turn: fromAxisAngle([1, 0, 0], -Math.PI / 2) },
  { value: 5, turn: fromAxisAngle([1, 0, 0], Math.PI / 2) },
  { value: 3, turn: IDENTITY },
  { value: 4, turn: fromAxisAngle([0, 1, 0], Math.PI) },
];

/** The 21 pips of a die of edge 1, slightly above the faces. */
function pips(): Mesh {
  const button = revolve(
    [slope([0.092, 0], [0.07, 0.008], 0.35, 0.25), slope([0.07, 0.008], [0, 0.011], 0.25, 0)],
    12,
    'Z',
  );
  return join(
    FACES.flatMap(({ value, turn }) =>
      faceOf(value).map(([x, y]) => {
        const raised = transformMesh(button, fromParts(toMatrix(IDENTITY), [0.25 * x, 0.25 * y, 0.499]));
        return transformMesh(raised, fromParts(toMatrix(turn), ZERO));
      }),
    ),
  );
}

/** A band whose normals lean outward by the given fractions. */
const slope = (from: [number, number], to: [number, number], lean: number, leanTo: number): SurfaceBand => ({
  from,
  to,
  fromNormal: [lean, Math.sqrt(1 - lean * lean)],
  toNormal: [leanTo, Math.sqrt(1 - leanTo * leanTo)],
  v: [0, 1],
});

/** Felt with a wooden rim and a padded cushion behind, lanes, and a rail with a brass stud for every metre. */
function table(builder: SceneBuilder): void {
  const felt = builder.material('felt', '#ffffff', { texture: feltTexture(), roughness: 1 });
  const wood = builder.material('wood', '#ffffff', { texture: planks(), roughness: 0.5 });
  const line = builder.material('line', '#d9c894', { roughness: 0.9 });
  const brass = builder.material('brass', '#d0a24e', { roughness: 0.3, metallic: 0.7 });
  const leather = builder.material('leather', '#5c2a2a', { roughness: 0.45 });
  const long = HALF_TABLE;
  const [near, far] = [4.6, -5];
  const cloth = quad(
    [-long, 0, near],
    [long, 0, near],
    [long, 0, far],
    [-long, 0, far],
    (2 * long) / 4,
    (near - far) / 4,
  );
  const stripe = (z: number) =>
    quad([-long, 0.004, z + 0.04], [long, 0.004, z + 0.04], [long, 0.004, z - 0.04], [-long, 0.004, z - 0.04]);
  builder.object('/World/Table/Cloth', [paint(cloth, felt), paint(join([-4, -1.4, 1.4].map(stripe)), line)]);
  const studs = Array.from({ length: 2 * long - 1 }, (_, i) => {
    const fifth = (i - long + 1) % 5 === 0;
    return moved(stud(fifth ? 0.1 : 0.06), [i - long + 1, 0.99, far - 0.1]);
  });
  const padding = Array.from({ length: long / 2 }, (_, i) =>
    moved(roundedBox([3.96, 0.5, 0.3], 0.12, 2), [4 * i - long + 2, 1.3, far - 0.3]),
  );
  builder.object('/World/Table/Cushion', [
    paint(block(2 * long, 1.15, 0.3, 0.25, [0, 0, far - 0.3]), wood),
    paint(join(padding), leather),
    paint(join(studs), brass),
  ]);
  builder.object('/World/Table/Rim', [
    paint(
      join([
        block(2 * long + 1, 0.5, 0.7, 0.25, [0, -0.3, near + 0.35]),
        block(0.5, 0.5, near - far + 1, 0.25, [long + 0.25, -0.3, (near + far) / 2]),
        block(0.5, 0.5, near - far + 1, 0.25, [-long - 0.25, -0.3, (near + far) / 2]),
      ]),
      wood,
    ),
  ]);
  room(builder);
}

/** A brass button, facing the players. */
const stud = (radius: number): Mesh =>
  revolve(
    [
      slope([radius, 0], [0.7 * radius, 0.5 * radius], 0.8, 0.4),
      slope([0.7 * radius, 0.5 * radius], [0, 0.7 * radius], 0.4, 0),
    ],
    10,
    'Z',
  );

/** Behind the table: a panelled wall with a dado, frames and a cornice. */
function room(builder: SceneBuilder): void {
  const paper = builder.material('wallpaper', '#ffffff', { texture: wallpaper(), roughness: 0.95 });
  const panel = builder.material('panel', '#6d4a34', { roughness: 0.6 });
  const frame = builder.material('frame', '#8a6244', { roughness: 0.5 });
  const boards = builder.material('boards', '#ffffff', { texture: planks('#8d7a66', 'boards'), roughness: 0.9 });
  const [y, z, long] = [-2.6, -13, 60];
  builder.object('/World/Room/Floor', [
    paint(quad([-long, y, 40], [long, y, 40], [long, y, z], [-long, y, z], 20, 9), boards),
  ]);
  builder.object('/World/Room/Paper', [
    paint(quad([-long, y, z], [long, y, z], [long, 14, z], [-long, 14, z], 60, 8.3), paper),
  ]);
  const fields = Array.from({ length: 17 }, (_, i) => 4.8 * (i - 8));
  const frames = fields.flatMap((x) => [
    block(3.9, 0.12, 0.1, 1, [x, 0.2, z + 0.2]),
    block(3.9, 0.12, 0.1, 1, [x, 2.7, z + 0.2]),
    block(0.12, 2.5, 0.1, 1, [x - 1.9, 0.26, z + 0.2]),
    block(0.12, 2.5, 0.1, 1, [x + 1.9, 0.26, z + 0.2]),
  ]);
  const pilasters = fields.map((x) => block(0.5, 11.2, 0.3, 1, [x + 2.4, 3.4, z]));
  const ledges = [
    block(2 * long, 0.22, 0.5, 1, [0, 3.2, z + 0.15]),
    block(2 * long, 0.5, 0.24, 1, [0, y, z + 0.2]),
    block(2 * long, 0.9, 0.7, 1, [0, 12.4, z + 0.2]),
  ];
  builder.object('/World/Room/Panels', [
    paint(block(2 * long, 5.8, 0.2, 1, [0, y, z + 0.05]), panel),
    paint(join([...frames, ...pilasters, ...ledges]), frame),
  ]);
}

/** Stripes with a small diamond in each. */
const wallpaper = () =>
  new Canvas(64, 64, '#43605d')
    .shade((u, v) => {
      const diamond = Math.abs(u - 0.5) + Math.abs(v - 0.5);
      if (diamond < 0.14 && diamond > 0.07) return '#b79d62';
      return u < 0.08 || u > 0.92 ? '#3a5552' : '#43605d';
    })
    .texture('wallpaper');

const feltTexture = () => new Canvas(128, 128, '#2f5b46').grain(0.09, 1, 3).texture('felt');

function planks(color = '#7a4a2c', name = 'planks') {
  const next = random(12);
  const rows = Array.from({ length: 4 }, () => 0.82 + 0.3 * next());
  return new Canvas(128, 64, color)
    .shade((u, v) => {
      const row = Math.floor(v * 4);
      const seam = (v * 4) % 1 < 0.07;
      const grain = 1 + 0.06 * Math.sin(2 * Math.PI * (v * 23 + 0.6 * Math.sin(2 * Math.PI * (u + row / 3))));
      return shadeOf(color, (seam ? 0.55 : rows[row]) * grain);
    })
    .texture(name);
}

const shadeOf = (hex: string, k: number): string =>
  `#${[1, 3, 5]
    .map((i) =>
      Math.max(0, Math.min(255, Math.round(Number.parseInt(hex.slice(i, i + 2), 16) * k)))
        .toString(16)
        .padStart(2, '0'),
    )
    .join('')}`;
