import { fromParts } from '../../src/math/mat4.ts';
import { fromAxisAngle, IDENTITY, multiply, type Quat, toMatrix } from '../../src/math/quat.ts';
import { random } from '../../src/math/random.ts';
import { ZERO } from '../../src/math/vec3.ts';
import { transformMesh } from '../../src/scene/meshOps.ts';
import { type Band, revolve } from '../../src/scene/primitives.ts';
import type { Mesh, Motion, Scene } from '../../src/scene/types.ts';
import { at, daylight, type Part, paint, SceneBuilder } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera } from '../kit/flight.ts';
import { Canvas } from '../kit/paint.ts';
import { block, join, quad, roundedBox } from '../kit/parts.ts';
import { tidy } from '../kit/tidy.ts';

/** Speed of light that the scene suggests [m/s]. */
const C = 5;
/** Both rows pass the middle of the table at this time [s]. */
const MEETING = 8;
const HALF_TABLE = 34;

export const scene: ExampleScene = { name: 'dice', make };

function make(): Scene {
  const builder = new SceneBuilder();
  table(builder);
  const dark = builder.material('pipDark', '#2b2622', { roughness: 0.5 });
  const light = builder.material('pipLight', '#f6eedd', { roughness: 0.5 });
  const die = (name: string, color: string, pip: number): Part => {
    const body = builder.material(name, color, { roughness: 0.28 });
    return [paint(tidy(roundedBox([1, 1, 1], 0.1, 2)), body), paint(tidy(pips()), pip)];
  };
  const red = die('red', '#a8312f', light);
  const ivory = die('ivory', '#e9dfc8', dark);
  const blue = die('blue', '#2f5f78', light);

  for (let k = 0; k < 7; k++)
    builder.object(`/World/Red${k}`, red, passing(2 * (k - 3), 0, 0.8 * C), { authoredIn: 'rest' });
  for (let k = 0; k < 5; k++)
    builder.object(`/World/Blue${k}`, blue, passing(2.5 * (k - 2), -3.2, -0.5 * C), { authoredIn: 'rest' });
  const next = random(6);
  for (let k = 0; k < 4; k++) {
    const turn = fromAxisAngle([0, 1, 0], (next() - 0.5) * 0.5);
    builder.object(`/World/Still${k}`, ivory, at([3.4 * (k - 1.5), 0.5, 3.4], multiply(turn, quarter(next))));
  }

  const [from, to] = [0, 16];
  const eye = (t: number): [number, number, number] => [0.11 * (t - MEETING), 4.3 + 0.03 * t, 11.5];
  const flight = camera({ from, to, fovY: 44, eye, target: (t) => [0.05 * (t - MEETING), 0.3, -0.6] });
  const hints = {
    speedOfLight: C,
    title: 'Dice',
    lookFor:
      'The red dice pass at 0.8 c. They do not look flattened but turned: of each you see its rear, the six, although it faces away from you (Terrell rotation, by arcsin 0.8 = 53°). The simultaneity view shows them 0.6 as long.',
    openAt: 9.2,
  };
  return builder.finish('dice', hints, [from, to], [flight], daylight([-0.35, 0.85, 0.5]));
}

/** Passes x at MEETING in the lane at z, along x. */
const passing = (x: number, z: number, velocity: number): Motion => ({
  kind: 'uniform',
  pose: { position: [x - velocity * MEETING, 0.5, z], orientation: IDENTITY },
  velocity: [velocity, 0, 0],
});

/** One of the four ways to lie on a side, for dice that someone threw. */
const quarter = (next: () => number): Quat => fromAxisAngle([0, 0, 1], (Math.PI / 2) * Math.floor(4 * next()));

/** Places of the pips on a face, in units of the way from the middle to the corner pips. */
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

/** Opposite faces add to seven; one, two and three go against the clock round their corner: +x, +y, +z. */
const FACES: readonly { readonly value: number; readonly turn: Quat }[] = [
  { value: 1, turn: fromAxisAngle([0, 1, 0], Math.PI / 2) },
  { value: 6, turn: fromAxisAngle([0, 1, 0], -Math.PI / 2) },
  { value: 2, turn: fromAxisAngle([1, 0, 0], -Math.PI / 2) },
  { value: 5, turn: fromAxisAngle([1, 0, 0], Math.PI / 2) },
  { value: 3, turn: IDENTITY },
  { value: 4, turn: fromAxisAngle([0, 1, 0], Math.PI) },
];

/** The 21 pips of a die of edge 1: inlaid buttons, a hair proud of the faces. */
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

/** A band whose normals lean outward by the given parts. */
const slope = (from: [number, number], to: [number, number], lean: number, leanTo: number): Band => ({
  from,
  to,
  fromNormal: [lean, Math.sqrt(1 - lean * lean)],
  toNormal: [leanTo, Math.sqrt(1 - leanTo * leanTo)],
  v: [0, 1],
});

/** Felt with a wooden rim, two lanes, and a rail with a brass stud for every metre. */
function table(builder: SceneBuilder): void {
  const felt = builder.material('felt', '#ffffff', { texture: feltTexture(), roughness: 1 });
  const wood = builder.material('wood', '#ffffff', { texture: planks(), roughness: 0.55 });
  const line = builder.material('line', '#c9b98a', { roughness: 0.9 });
  const brass = builder.material('brass', '#c99b4a', { roughness: 0.3, metallic: 0.7 });
  const long = HALF_TABLE;
  const [near, far] = [6, -7];
  const cloth = quad([-long, 0, near], [long, 0, near], [long, 0, far], [-long, 0, far], (2 * long) / 4, 13 / 4);
  const stripe = (z: number) =>
    quad([-long, 0.004, z + 0.03], [long, 0.004, z + 0.03], [long, 0.004, z - 0.03], [-long, 0.004, z - 0.03]);
  const studs = Array.from({ length: 2 * long - 1 }, (_, i) => {
    const size = (i - long + 1) % 5 === 0 ? 0.1 : 0.05;
    return block(size, 0.05, 0.16, 1, [i - long + 1, 0.35, far - 0.25]);
  });
  builder.object('/World/Table/Cloth', [paint(cloth, felt), paint(join([-4.4, -2, -1.2, 1.2].map(stripe)), line)]);
  builder.object('/World/Table/Rim', [
    paint(
      tidy(
        join([
          block(2 * long + 1, 0.65, 0.5, 0.5, [0, -0.3, far - 0.25]),
          block(2 * long + 1, 0.65, 0.5, 0.5, [0, -0.3, near + 0.25]),
          block(0.5, 0.65, near - far, 0.5, [long + 0.25, -0.3, (near + far) / 2]),
          block(0.5, 0.65, near - far, 0.5, [-long - 0.25, -0.3, (near + far) / 2]),
        ]),
      ),
      wood,
    ),
    paint(tidy(join(studs)), brass),
  ]);
  floor(builder);
}

function floor(builder: SceneBuilder): void {
  const boards = builder.material('boards', '#ffffff', { texture: planks('#8d7a66', 'boards'), roughness: 0.9 });
  const y = -2.6;
  builder.object('/World/Floor', [paint(quad([-90, y, 60], [90, y, 60], [90, y, -90], [-90, y, -90], 30, 25), boards)]);
}

const feltTexture = () => new Canvas(128, 128, '#2f5b46').grain(0.09, 1, 3).texture('felt');

function planks(color = '#7a4a2c', name = 'planks') {
  const next = random(12);
  const rows = Array.from({ length: 4 }, () => 0.82 + 0.3 * next());
  return new Canvas(128, 64, color)
    .shade((u, v) => {
      const row = Math.floor(v * 4);
      const seam = (v * 4) % 1 < 0.07 || Math.abs(((u + row * 0.37) % 1) - 0.5) < 0.006;
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
