import { fromParts } from '../../src/math/mat4.ts';
import { fromAxisAngle, IDENTITY, toMatrix } from '../../src/math/quat.ts';
import { transformMesh } from '../../src/scene/mesh/meshOps.ts';
import { cone, revolve, torus } from '../../src/scene/mesh/primitives.ts';
import type { Mesh, Scene } from '../../src/scene/types.ts';
import { at, daylight, type Part, paint, place, placePart, SceneBuilder } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera, sampled } from '../kit/flight.ts';
import { block, flatBand, join, quad, sized } from '../kit/parts.ts';
import { poplar } from '../kit/trees.ts';

const C = 10;
const BETA = 0.6;
/** World times of departure and return [s]; the turn is half-way, 6 light-seconds away. */
const [START, BACK] = [0, 20];
const TURN = (BACK - START) / 2;
const FAR = BETA * C * TURN;
/** Seconds of one turn of a dial, and between its numerals. */
const [ROUND, STEP] = [24, 2];
/** Of the axis along which one flies [m]. */
const HEIGHT = 5;
const [INNER, OUTER] = [3, 4.5];
/** Of the traveller's dial, which passes through those of the gates. */
const SMALL = 0.6;

export const scene: ExampleScene = { name: 'twins', make };

function make(): Scene {
  const builder = new SceneBuilder();
  lane(builder);
  // Dials glow, so that they can be read from the side that lies in shadow.
  const plate = builder.material('plate', '#f2efe6', { roughness: 0.6, emissive: '#8d897e' });
  const ink = builder.material('ink', '#22262c', { roughness: 0.7 });
  const steel = builder.material('steel', '#5c6670', { roughness: 0.4, metallic: 0.6 });
  const red = builder.material('mark', '#c8321e', { roughness: 0.5 });
  const gold = builder.material('gold', '#d99a1f', { roughness: 0.45 });
  const dial = (rim: number): Part => [paint(face(), plate), paint(numerals(), ink), paint(ring(), rim)];
  const scaled = (part: Part): Part => part.map((mesh) => sized(mesh, [1, SMALL, SMALL]));

  const turning = (reading: number) => fromAxisAngle([1, 0, 0], (2 * Math.PI * reading) / ROUND);
  const samples = [START - 8, BACK + 8] as const;
  builder.object(
    '/World/Home',
    dial(steel),
    sampled(...samples, 12, (t) => ({ position: [0, HEIGHT, 0], orientation: turning(t) })),
  );
  builder.object(
    '/World/Traveller',
    scaled(dial(gold)),
    sampled(...samples, 12, (t) => ({ position: [travelled(t), HEIGHT, 0], orientation: turning(ownTime(t)) })),
  );
  builder.object(
    '/World/TravellerMark',
    scaled([paint(mark(), red)]),
    sampled(...samples, 1, (t) => ({ position: [travelled(t), HEIGHT, 0], orientation: IDENTITY })),
  );
  builder.object('/World/HomeMark', [paint(mark(), red)], at([0, HEIGHT, 0]));
  for (const x of [0, FAR]) builder.object(`/World/Stand${x}`, placePart([paint(stand(), steel)], place([x, 0, 0])));
  builder.object('/World/TurningPoint', [paint(ring(), steel)], at([FAR, HEIGHT, 0]));

  const [from, to] = [START, BACK];
  const flight = camera({
    from,
    to,
    fovY: 50,
    position: () => [17, 6.2, 9.5],
    target: () => [4, 4.6, 0],
  });
  const hints = {
    speedOfLight: C,
    title: 'Twins',
    lookFor:
      'The golden dial flies at 0.6 c to the far ring, six light-seconds away, and back; at the red mark stands its time. It comes home with 16 s where the dial that stayed has 20 s. From home it is seen slow for 16 s, and fast for 4 s: the light of its turn has to come back first. The panel Clocks has what is seen, and what is simultaneous.',
    openAt: 2.7,
  };
  return builder.finish('twins', hints, [from, to], [flight], daylight([0.5, 0.75, 0.55]));
}

/** Out and back at one speed; at home before and after. */
const travelled = (t: number): number => Math.max(0, BETA * C * (TURN - Math.abs(t - START - TURN)));
/** What a clock on the way shows [s]. */
const ownTime = (t: number): number => {
  const under = Math.min(Math.max(t, START), BACK) - START;
  return t - under + under * Math.sqrt(1 - BETA ** 2);
};

/** The plate of a dial in the plane across x, with a hole to fly through. */
const face = (): Mesh =>
  revolve([flatBand([INNER, -0.04], [OUTER, -0.04], [0, -1]), flatBand([OUTER, 0.04], [INNER, 0.04], [0, 1])], 64, 'X');

const ring = (): Mesh =>
  join([OUTER, INNER].map((radius) => torus(radius, 0.09, { segments: 64, rings: 8, axis: 'X' })));

/** Above a dial, pointing at the numeral that counts. */
const mark = (): Mesh => {
  const down = fromParts(toMatrix(fromAxisAngle([1, 0, 0], Math.PI / 2)), [0, OUTER + 0.75, 0]);
  return transformMesh(cone(0.4, 1.1, { segments: 24, axis: 'Z' }), down);
};

const stand = (): Mesh => join([-1, 1].map((side) => block(0.5, HEIGHT, 0.35, 1, [0, 0, side * (OUTER + 0.3)])));

/** Of seven-segment digits: a at the top, b to f clockwise, g in the middle. */
const DIGITS = ['abcdef', 'bc', 'abged', 'abgcd', 'fgbc', 'afgcd', 'afgecd', 'abc', 'abcdefg', 'abfgcd'];
const [DIGIT_WIDTH, DIGIT_HEIGHT, STROKE] = [0.46, 0.9, 0.13];

/** A segment, upright and to the right of the middle: place and size. */
function segment(name: string): readonly [right: number, up: number, width: number, height: number] {
  const [side, half] = [DIGIT_WIDTH / 2, DIGIT_HEIGHT / 2];
  const across = DIGIT_WIDTH + STROKE;
  if ('agd'.includes(name)) return [0, { a: half, g: 0, d: -half }[name]!, across, STROKE];
  return ['bc'.includes(name) ? side : -side, 'bf'.includes(name) ? half / 2 : -half / 2, STROKE, half + STROKE];
}

/** Numerals on both sides of a dial that turns about x; read from either side, the one at the top counts. */
function numerals(): Mesh {
  const parts: Mesh[] = [];
  for (let n = 0; n < ROUND; n += STEP) {
    const turn = fromParts(toMatrix(fromAxisAngle([1, 0, 0], (-2 * Math.PI * n) / ROUND)), [0, 0, 0]);
    for (const side of [-1, 1]) parts.push(transformMesh(numeral(String(n), side), turn));
  }
  return join(parts);
}

/** A numeral at the top of a dial, on the side towards `side` · x. */
function numeral(text: string, side: number): Mesh {
  const pitch = DIGIT_WIDTH + 2.2 * STROKE;
  const blocks = [...text].flatMap((digit, i) => {
    const middle = pitch * (i - (text.length - 1) / 2);
    return [...DIGITS[Number(digit)]!].map((name) => {
      const [right, up, width, height] = segment(name);
      const y = (INNER + OUTER) / 2 + up - height / 2;
      // Who looks against x has z on his left.
      return block(0.06, height, width, 1, [0.05 * side, y, -side * (middle + right)]);
    });
  });
  return join(blocks);
}

/** A lane with a stripe every light-second, posts and poplars. */
function lane(builder: SceneBuilder): void {
  const grass = builder.material('grass', '#7f9a5b', { roughness: 1, like: 'leaf' });
  const paving = ['#cdbf9f', '#a9926c'].map((color, i) => builder.material(`paving${i}`, color, { roughness: 0.9 }));
  const post = builder.material('post', '#e9e4d6', { roughness: 0.7 });
  const ground = quad([-60, -0.03, 40], [130, -0.03, 40], [130, -0.03, -60], [-60, -0.03, -60]);
  builder.object('/World/Grass', [paint(ground, grass)]);
  for (const [i, material] of paving.entries())
    builder.object(`/World/Paving${i}`, [
      paint(
        join(Array.from({ length: 7 }, (_, k) => block(C, 0.03, 5, 0.5, [C * (2 * k + i - 2), -0.02, 0]))),
        material,
      ),
    ]);
  const row = Array.from({ length: 11 }, (_, k) =>
    [-1, 1].map((side) => block(0.22, 1.1, 0.22, 1, [C * (k - 2), 0, 3.2 * side])),
  );
  builder.object('/World/Posts', [paint(join(row.flat()), post)]);
  const bark = builder.material('bark', '#6a5340', { roughness: 1 });
  const leaf = builder.material('leaf', '#55803f', { roughness: 0.95, like: 'leaf' });
  for (let k = 0; k < 9; k++)
    builder.object(
      `/World/Poplar${k}`,
      placePart(poplar(8 + ((k * 5) % 7) / 3, bark, leaf, k), place([14 * (k - 2) + 3, -0.03, -13 - ((k * 3) % 4)], k)),
    );
}
