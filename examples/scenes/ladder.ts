import { IDENTITY } from '../../src/math/quat.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { cylinder } from '../../src/scene/mesh/primitives.ts';
import type { Mesh, SampledMotion, Scene, SceneCamera } from '../../src/scene/types.ts';
import { daylight, paint, place, placePart, SceneBuilder } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera, lookFrom, sampled } from '../kit/flight.ts';
import { Canvas, tone } from '../kit/paint.ts';
import { bar, block, join, moved, polygon, quad } from '../kit/parts.ts';
import { broadTree } from '../kit/trees.ts';

const C = 3;
const BETA = 0.6;
/** Proper lengths of the ladder and of the barn between its doors [m]: 16 · 0.8 = 12.8 < 14 < 16. */
const LADDER = 16;
const BARN = 14;
/** Time at which the ladder's centre is at the barn's, with both doors shut [s]. */
const MEETING = 10;
/** Duration of the doors' motion before and after it, and how long they stay shut [s]. */
const MOVING = 0.27;
const SHUT = 0.04;
const [DOOR_WIDTH, DOOR_HEIGHT, HALF_DEPTH] = [1.4, 2.5, 2.6];
const [WALL, RIDGE] = [3.1, 5.3];
const CARRIED = 1.25;

export const scene: ExampleScene = { name: 'ladder', make };

function make(): Scene {
  const builder = new SceneBuilder();
  meadow(builder);
  barn(builder);
  doors(builder);
  const wood = builder.material('ladderWood', '#f0dcae', { roughness: 0.5 });
  const tip = builder.material('ladderTip', '#c2402e', { roughness: 0.5 });
  const velocity: Vec3 = [BETA * C, 0, 0];
  const pose = { position: [-BETA * C * MEETING, CARRIED, 0] as Vec3, orientation: IDENTITY };
  builder.object(
    '/World/Ladder',
    [paint(rungsAndRails(), wood), paint(tips(), tip)],
    { kind: 'uniform', pose, velocity },
    { authoredIn: 'rest' },
  );

  const [from, to] = [0, 20];
  const beside = camera({
    from,
    to,
    fovY: 46,
    position: (t) => [0.04 * (t - MEETING - 4), 3.1, 12.5],
    target: () => [0, 1.95, 0],
  });
  const hints = {
    speedOfLight: C,
    title: 'Ladder and barn',
    lookFor:
      'A ladder of 16 m flies through a barn of 14 m at 0.6 c. In the barn’s frame it is 12.8 m long, and for a moment both doors are shut with all of it inside. In the ladder’s frame (ride /World/Rider in the simultaneity view) the barn is 11.2 m long, and its doors never are shut together.',
    openAt: MEETING + 4.8,
  };
  return builder.finish('ladder', hints, [from, to], [beside, rider(from, to)], daylight([-0.45, 0.7, 0.65]));
}

/** A camera beside the ladder's centre with its velocity. */
function rider(from: number, to: number): SceneCamera {
  const eye = (t: number): Vec3 => [BETA * C * (t - MEETING), 3.1, 12.5];
  const orientation = lookFrom([0, 3.1, 12.5], [0, 1.95, 0]);
  const motion = sampled(from, to, 1, (t) => ({ position: eye(t), orientation }));
  return { path: '/World/Rider', motion, fovY: (50 * Math.PI) / 180 };
}

/** The ladder in its rest frame, along x and on edge: two rails and a rung every 40 cm. */
function rungsAndRails(): Mesh {
  const half = LADDER / 2;
  const rails = [-1, 1].map((side) => block(LADDER - 0.8, 0.11, 0.09, 1, [0, 0.36 * side - 0.055, 0]));
  const rung = cylinder(0.033, 0.64, { segments: 8, axis: 'Y' });
  const count = Math.floor((LADDER - 0.8) / 0.4);
  const rungs = Array.from({ length: count }, (_, i) => moved(rung, [-half + 0.6 + 0.4 * i, 0, 0]));
  return join([...rails, ...rungs]);
}

/** Its painted ends. */
const tips = (): Mesh =>
  join(
    [-1, 1].flatMap((end) =>
      [-1, 1].map((side) => block(0.4, 0.12, 0.1, 1, [end * (LADDER / 2 - 0.2), 0.36 * side - 0.06, 0])),
    ),
  );

/** Two door leaves at either end slide together and apart, simultaneously in the barn's frame. */
function doors(builder: SceneBuilder): void {
  const leafWood = builder.material('doors', '#ffffff', {
    texture: planks('#ece2c8', 'door_planks', 4),
    roughness: 0.8,
  });
  const iron = builder.material('iron', '#2f3030', { roughness: 0.5, metallic: 0.6 });
  const width = DOOR_WIDTH / 2;
  const leaf = moved(block(0.09, DOOR_HEIGHT, width, 0.45), [0, 0, 0]);
  const braces = join([0.3, 1.25, 2.2].map((y) => block(0.13, 0.12, width - 0.06, 1, [0, y - 0.06, 0])));
  for (const end of [-1, 1])
    for (const side of [-1, 1]) {
      const name = `${end < 0 ? 'Entry' : 'Exit'}${side < 0 ? 'Left' : 'Right'}`;
      builder.object(`/World/Doors/${name}`, [paint(leaf, leafWood), paint(braces, iron)], sliding(end, side));
    }
}

function sliding(end: number, side: number): SampledMotion {
  const x = end * (BARN / 2 - 0.07);
  const pose = (open: boolean) => [x, 0.04, side * (DOOR_WIDTH / 4 + (open ? DOOR_WIDTH / 2 : 0)), ...IDENTITY];
  const times = [-MOVING - SHUT, -SHUT, SHUT, SHUT + MOVING].map((t) => MEETING + t);
  return {
    kind: 'sampled',
    times: Float64Array.from(times),
    poses: Float64Array.from([true, false, false, true].flatMap(pose)),
  };
}

/** A timber frame under a shingle roof, boarded at the back and open in front. */
function barn(builder: SceneBuilder): void {
  const timber = builder.material('timber', '#ffffff', { texture: planks('#7a5a3c', 'timber', 2), roughness: 0.9 });
  const boards = builder.material('boards', '#ffffff', { texture: planks('#a9563d', 'boards', 8), roughness: 0.95 });
  const trim = builder.material('trim', '#ece4d2', { roughness: 0.8 });
  const roof = builder.material('roof', '#ffffff', { texture: shingles(), roughness: 0.95 });
  const floor = builder.material('threshing', '#ffffff', {
    texture: planks('#b99d74', 'floor_planks', 6),
    roughness: 0.95,
  });
  builder.object('/World/Barn/Floor', [paint(block(BARN + 0.3, 0.1, 2 * HALF_DEPTH + 0.3, 0.5, [0, -0.06, 0]), floor)]);
  builder.object('/World/Barn/Back', [paint(block(BARN, WALL, 0.1, 0.5, [0, 0, -HALF_DEPTH]), boards)]);
  for (const end of [-1, 1]) gable(builder, end, boards, trim);
  builder.object('/World/Barn/Frame', [paint(join(frame()), timber)]);
  const [eave, over] = [HALF_DEPTH + 0.45, BARN / 2 + 0.4];
  // Shingles at the back only; the front has rafters and battens, so that the inside is visible.
  const low = WALL - (0.45 * (RIDGE - WALL)) / HALF_DEPTH;
  const rear = polygon(
    [
      [over, low, -eave],
      [-over, low, -eave],
      [-over, RIDGE, 0],
      [over, RIDGE, 0],
    ],
    0.4,
  );
  const battens = [0.04, 0.36, 0.68].map((s) =>
    block(2 * over, 0.06, 0.1, 0.5, [0, low + (RIDGE - low) * s - 0.03, eave * (1 - s)]),
  );
  const ridge = block(2 * over, 0.12, 0.3, 0.5, [0, RIDGE - 0.02, 0]);
  builder.object('/World/Barn/Roof', [
    paint({ ...rear, doubleSided: true }, roof),
    paint(ridge, trim),
    paint(join(battens), timber),
  ]);
  hay(builder);
}

/** A gable wall with its doorway left open, trimmed in white. */
function gable(builder: SceneBuilder, end: number, boards: number, trim: number): void {
  const x = end * (BARN / 2);
  const [w, h, d] = [DOOR_WIDTH / 2, DOOR_HEIGHT + 0.06, HALF_DEPTH];
  const outline: [number, number][] = [
    [-d, 0],
    [-w, 0],
    [-w, h],
    [w, h],
    [w, 0],
    [d, 0],
    [d, WALL],
    [0, RIDGE],
    [-d, WALL],
  ];
  const face = (dx: number, outward: boolean) => {
    const ring = outline.map(([z, y]): Vec3 => [x + dx, y, z]);
    return polygon(outward === end > 0 ? [...ring].reverse() : ring, 0.5);
  };
  const wall = { ...join([face(0.04, true), face(-0.04, false)]), doubleSided: true };
  const out = x + end * 0.06;
  const lath = (z0: number, y0: number, z1: number, y1: number) => bar([out, y0, z0], [out, y1, z1], 0.13);
  const laths = [
    lath(-w, 0, -w, h),
    lath(w, 0, w, h),
    lath(-w - 0.06, h, w + 0.06, h),
    lath(-d, WALL, 0, RIDGE),
    lath(d, WALL, 0, RIDGE),
  ];
  builder.object(`/World/Barn/${end < 0 ? 'Entry' : 'Exit'}Gable`, [paint(wall, boards), paint(join(laths), trim)]);
}

/** Posts, plates, tie beams, braces and rafters. */
function frame(): Mesh[] {
  const bays = 4;
  const parts: Mesh[] = [];
  for (let k = 0; k <= bays; k++) {
    const x = -BARN / 2 + 0.12 + ((BARN - 0.24) * k) / bays;
    for (const side of [-1, 1]) {
      const z = side * (HALF_DEPTH - 0.1);
      parts.push(bar([x, WALL - 0.12, side * HALF_DEPTH], [x, RIDGE - 0.14, 0], 0.13));
      // Only corner posts in front, so that nothing hides the ladder.
      if (side > 0 && k > 0 && k < bays) continue;
      parts.push(block(0.2, WALL, 0.2, 0.5, [x, 0, z]));
      parts.push(bar([x, WALL - 0.75, z], [x, WALL - 0.06, z - side * 0.75], 0.11));
    }
    parts.push(block(0.18, 0.2, 2 * HALF_DEPTH, 0.5, [x, WALL - 0.1, 0]));
  }
  for (const side of [-1, 1]) parts.push(block(BARN, 0.2, 0.2, 0.5, [0, WALL - 0.1, side * (HALF_DEPTH - 0.1)]));
  return parts;
}

function hay(builder: SceneBuilder): void {
  const straw = builder.material('straw', '#ffffff', { texture: strawTexture(), roughness: 1 });
  const bale = block(1, 0.5, 0.55, 1);
  const bales = [
    [-4.6, 0, -2.1],
    [-3.5, 0, -2.15],
    [-4.1, 0.5, -2.1],
    [3.6, 0, -2.1],
    [4.7, 0, -2.15],
    [4.1, 0.5, -2.12],
    [2.5, 0, -2.1],
  ].map(([x, y, z]) => moved(bale, [x, y + 0.04, z]));
  builder.object('/World/Barn/Hay', [paint(join(bales), straw)]);
}

/** Grass, the ladder's track with a stone every metre, and a fence. */
function meadow(builder: SceneBuilder): void {
  const grass = builder.material('grass', '#ffffff', {
    texture: new Canvas(128, 128, '#86994f').grain(0.1, 2, 4).texture('grass'),
    like: 'leaf',
    roughness: 1,
  });
  const dirt = builder.material('dirt', '#ffffff', {
    texture: new Canvas(128, 128, '#b79f7c').grain(0.08, 2, 9).texture('dirt'),
    roughness: 1,
  });
  const stone = builder.material('marker', '#e9e4d8', { roughness: 0.85 });
  const fenceWood = builder.material('fence', '#cfc5b2', { roughness: 0.9 });
  const long = 45;
  const strip = (x0: number, x1: number, z0: number, z1: number, y: number, tile: number) =>
    quad([x0, y, z0], [x1, y, z0], [x1, y, z1], [x0, y, z1], (x1 - x0) / tile, (z0 - z1) / tile);
  builder.object('/World/Grass', [paint(strip(-60, 60, 25, -45, -0.06, 4), grass)]);
  builder.object('/World/Track', [paint(strip(-long, long, 1.1, -1.1, -0.03, 2), dirt)]);
  const markers = Array.from({ length: 2 * long + 1 }, (_, i) => i - long)
    .filter((x) => Math.abs(x) > BARN / 2)
    .map((x) => block(x % 5 === 0 ? 0.22 : 0.12, x % 5 === 0 ? 0.28 : 0.14, 0.14, 1, [x, -0.05, 1.35]));
  builder.object('/World/Markers', [paint(join(markers), stone)]);
  const z = -9;
  const rails = [0.45, 0.95].map((y) => block(2 * long, 0.1, 0.05, 0.5, [0, y, z]));
  const posts = Array.from({ length: 31 }, (_, i) => block(0.13, 1.25, 0.13, 1, [3 * (i - 15), -0.05, z - 0.08]));
  const bark = builder.material('bark', '#6a5340', { roughness: 1 });
  const leaf = builder.material('leaf', '#5b8141', { roughness: 0.95, like: 'leaf' });
  for (let k = 0; k < 11; k++) {
    const tree = broadTree(5.5 + 2.5 * ((k * 0.618) % 1), bark, leaf, k + 3);
    builder.object(
      `/World/Tree${k}`,
      placePart(tree, place([8.5 * (k - 6) + 3 * ((k * 0.38) % 1), -0.06, -15 - 7 * ((k * 0.71) % 1)], k)),
    );
  }
  builder.object('/World/Fence', [paint(join([...rails, ...posts]), fenceWood)]);
}

/** Upright boards, each of its own tone. */
function planks(color: string, name: string, count: number) {
  const tones = Array.from({ length: count }, (_, i) => 0.84 + 0.26 * ((i * 0.618) % 1));
  return new Canvas(32 * count, 128, color)
    .shade((u, v) => {
      const i = Math.floor(u * count);
      const gap = (u * count) % 1 < 0.06;
      const grain = 1 + 0.05 * Math.sin(2 * Math.PI * (u * count * 5 + 0.3 * Math.sin(2 * Math.PI * (v * 2 + i / 3))));
      return tone(color, Math.min(1, (gap ? 0.5 : tones[i]) * grain));
    })
    .texture(name);
}

function shingles() {
  const color = '#6e6259';
  return new Canvas(128, 128, color)
    .shade((u, v) => {
      const row = Math.floor(v * 8);
      const x = u * 8 + (row % 2) / 2;
      const gap = x % 1 < 0.06 || (v * 8) % 1 < 0.1;
      return tone(color, gap ? 0.55 : 0.8 + 0.2 * ((Math.floor(x) * 0.37 + row * 0.61) % 1));
    })
    .texture('shingles');
}

function strawTexture() {
  return new Canvas(96, 48, '#d8b968')
    .shade((u, v) =>
      tone(
        '#d8b968',
        0.86 +
          0.1 * Math.sin(90 * v + 3 * Math.sin(20 * u)) +
          (Math.abs(u - 0.25) < 0.02 || Math.abs(u - 0.75) < 0.02 ? -0.3 : 0),
      ),
    )
    .grain(0.1, 1, 5)
    .texture('straw');
}
