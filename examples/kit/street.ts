import { random } from '../../src/math/random.ts';
import { sphere } from '../../src/scene/mesh/primitives.ts';
import { type Part, paint, place, placePart, type SceneBuilder } from './builder.ts';
import { type House, house, type Scheme } from './houses.ts';
import { bricks, Canvas, roofTiles, tone } from './paint.ts';
import { block, column, join, moved, quad, turned } from './parts.ts';

/** Half the width of the road, and half the distance between the houses [m]. */
const ROAD = 5;
const FRONT = 9;
const LENGTH = 120;
/** Distance from a house to its repetition [m]: a little longer than the rows, so that a lane crosses there. */
const PERIOD = 117;

const schemes: readonly Scheme[] = [
  { wall: '#d9b382', trim: '#efe6d3', door: '#3d5a52', shutter: '#5d7a6b' },
  { wall: '#c9796a', trim: '#f0e4d2', door: '#4a3a33' },
  { wall: '#e3d8c0', trim: '#b9a98a', door: '#7c3b34', shutter: '#7f98a6' },
  { wall: '#9fb0b5', trim: '#edeae2', door: '#2e4057' },
  { wall: '#dcc56f', trim: '#f3ead2', door: '#5a3d2b', shutter: '#4d6b4f' },
  { wall: '#b98f9b', trim: '#efe3df', door: '#39424e' },
];

/** What differs between streets: the time of day, and how long they are. */
export interface StreetLook {
  /** Materials of the road, whose uv unit is 10 m, and of the glass of the street lamps. */
  readonly road: number;
  readonly lamp: number;
  /** Material of lit windows; absent: none is lit. */
  readonly glow?: number;
  /** How often the street is repeated towards −z, with the same meshes; default 0. */
  readonly repeats?: number;
}

/** A street of town houses along z with columns, lamps and trees on its pavements. */
export function street(builder: SceneBuilder, { road, lamp, glow, repeats = 0 }: StreetLook): void {
  ground(builder, road, repeats);
  for (const side of [-1, 1]) row(builder, side, glow, repeats);
  avenue(builder, lamp, repeats);
}

/** The road, raised pavements, and grass behind the houses. */
function ground(builder: SceneBuilder, floor: number, repeats: number): void {
  const grass = builder.material('grass', '#7d9160', { roughness: 1, like: 'leaf' });
  const kerb = builder.material('kerb', '#b7b1a6', { roughness: 0.9 });
  const paving = builder.material('paving', '#ffffff', { texture: slabs(), roughness: 0.9 });
  const begin = LENGTH / 2;
  const length = LENGTH + repeats * PERIOD;
  const end = begin - length;
  builder.object('/World/Road', [
    paint(quad([-ROAD, 0, begin], [ROAD, 0, begin], [ROAD, 0, end], [-ROAD, 0, end], 1, length / 10), floor),
  ]);
  for (const side of [-1, 1]) {
    const width = FRONT - ROAD - 0.25;
    const walk = block(width, 0.15, length, 0.5, [side * (ROAD + 0.25 + width / 2), 0, (begin + end) / 2]);
    const stone = block(0.25, 0.16, length, 1, [side * (ROAD + 0.125), 0, (begin + end) / 2]);
    builder.object(`/World/Pavement${side < 0 ? 'Left' : 'Right'}`, [paint(walk, paving), paint(stone, kerb)]);
  }
  const lawn = (x0: number, x1: number) =>
    quad([x0, -0.03, begin], [x1, -0.03, begin], [x1, -0.03, end], [x0, -0.03, end]);
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

function row(builder: SceneBuilder, side: number, glow: number | undefined, repeats: number): void {
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
    const part = house(
      builder,
      name,
      style,
      { ...materials, ...(glow !== undefined && { glow }) },
      100 * (side + 2) + i,
    );
    const m = place([side * FRONT, 0, z - style.width / 2], side < 0 ? Math.PI / 2 : -Math.PI / 2);
    repeated(builder, `/World/${name}`, placePart(part, m), repeats);
    z -= style.width + (i % 3 === 2 ? 3.2 : 0.06);
  }
}

/** An object, and the same again every `PERIOD` along the street. */
function repeated(builder: SceneBuilder, path: string, part: Part, repeats: number): void {
  builder.object(path, part);
  for (let k = 1; k <= repeats; k++) builder.copy(`${path}_${k}`, [0, 0, -PERIOD]);
}

/** Columns, lamps and trees along both pavements. */
function avenue(builder: SceneBuilder, lamp: number, repeats: number): void {
  const marble = builder.material('marble', '#e9e4d8', { roughness: 0.55 });
  const iron = builder.material('iron', '#2d3234', { roughness: 0.5, metallic: 0.6 });
  const bark = builder.material('bark', '#6b5442', { roughness: 1 });
  const leaf = builder.material('leaf', '#5f8a45', { roughness: 0.95, like: 'leaf' });
  const columnPart: Part = [
    paint(column(4.6, 0.36), marble),
    paint(moved(sphere(0.34, { segments: 20, axis: 'Y' }), [0, 4.95, 0]), marble),
  ];
  const lampPart = lampPost(iron, lamp);
  for (const side of [-1, 1])
    for (let k = 0; k < 6; k++) {
      const z = 45 - 18 * k;
      const label = `${side < 0 ? 'Left' : 'Right'}${k}`;
      const put = (name: string, part: Part) => repeated(builder, `/World/${name}${label}`, part, repeats);
      put('Column', placePart(columnPart, place([side * 5.9, 0.15, z])));
      put('Lamp', placePart(lampPart, place([side * 5.7, 0.15, z - 9], side < 0 ? 0 : Math.PI)));
      put('Tree', placePart(tree(bark, leaf, k + 7 * (side + 1)), place([side * 6.9, 0.15, z - 4.5])));
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
