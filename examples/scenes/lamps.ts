import { IDENTITY } from '../../src/math/quat.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { sphere } from '../../src/scene/mesh/primitives.ts';
import type { Light, Scene } from '../../src/scene/types.ts';
import { LIGHT_PRESETS } from '../../src/spectrum/sources/lightPresets.ts';
import { paint, SceneBuilder, spectralLight } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera, sampledAt, shuttle, smoothRamp, TURN_SHARE } from '../kit/flight.ts';
import { block, insideOut, turned } from '../kit/parts.ts';

const C = 10;
const [FROM, TO] = [0, 24];
/** Length [m] and duration [s] of a path from end to end; 0.32 c in the middle. */
const [WAY, PERIOD] = [12, 4.26];
/** Half the width of the wall, and the height of a lane [m]. */
const [HALF, LANE] = [14, 2.2];
const TOP = 3 * LANE;
/** Distance of the lamps from the wall [m]. */
const OUT = 0.75;

/** Radius of a globe [m]. */
const RADIUS = 0.24;

/** From top to bottom; `start`: initial phase of the shuttle, `luminance`: brightness. */
const LAMPS = [
  { name: 'Sodium', preset: 'sodium', start: 0.25, luminance: 2.4 },
  { name: 'Mercury', preset: 'mercury', start: 1.25, luminance: 2.4 },
  { name: 'Hydrogen', preset: 'hydrogen', start: 0.25, luminance: 1 },
] as const;

/** Pairs of colours that differ in daylight but only in brightness in light of a single line. */
const PATCHES = ['#c9463a', '#e0b83c', '#4f9a54', '#3f6fb5', '#8f4f9e', '#f2f0ea'];

export const scene: ExampleScene = { name: 'lamps', make };

function make(): Scene {
  const builder = new SceneBuilder();
  wall(builder);
  const bulbs = LAMPS.map((lamp, i) => carriage(builder, lamp, TOP - (i + 0.5) * LANE));
  const way = (t: number): number => smoothRamp(t / TO, 0.3);
  const flight = camera({
    from: FROM,
    to: TO,
    fovY: 46,
    position: (t) => [-3 + 6 * way(t), TOP / 2 + 0.2, 9.6],
    target: (t) => [-0.8 + 1.6 * way(t), TOP / 2 - 0.05, 0],
  });
  const hints = {
    speedOfLight: C,
    title: 'Lamps',
    lookFor:
      'Lamps of single spectral lines shuttle before a grey wall at 0.32 c: sodium, mercury, hydrogen. Each paints the wall with its own light shifted: the yellow of sodium is blue where it is coming, then green, yellow abreast, red behind, and then nothing, for its only line has left what eyes see. At the ends they stand still for a moment and show their true colours.',
    openAt: 1.6,
  };
  const lights: Light[] = [...bulbs, { kind: 'dome', path: '/World/Sky', color: [0.006, 0.007, 0.01] }];
  return builder.finish('lamps', hints, [FROM, TO], [flight], lights);
}

/** A grey wall with coloured boards, and rails in front of it. */
function wall(builder: SceneBuilder): void {
  const gray = builder.material('grey', '#c4c4c4', { roughness: 1 });
  const rail = builder.material('rail', '#5a5f66', { roughness: 0.35, metallic: 0.8 });
  builder.object('/World/Wall', [paint(block(2 * HALF, TOP + 8, 0.2, 1, [0, -4, -0.1]), gray)]);
  for (let k = 0; k < 3; k++)
    builder.object(`/World/Rail${k}`, [paint(block(2 * HALF, 0.07, 0.12, 1, [0, k * LANE + 0.1, OUT]), rail)]);
  const boards = PATCHES.map((color, i) => builder.material(`patch${i}`, color, { roughness: 1 }));
  for (let k = 0; k < 3; k++)
    boards.forEach((board, i) => {
      const x = (i - (boards.length - 1) / 2) * 2.7;
      builder.object(`/World/Patch${k}${i}`, [paint(block(0.62, 0.62, 0.05, 1, [x, k * LANE + 1.1, 0.03]), board)]);
    });
}

type Lamp = (typeof LAMPS)[number];

/** A lit globe of smoked glass on a sliding foot, with its light. */
function carriage(builder: SceneBuilder, { name, preset, start, luminance }: Lamp, y: number): Light {
  const glass = builder.material(`glass${name}`, '#4a4a4a', { roughness: 1 });
  const brass = builder.material(`foot${name}`, '#777b80', { roughness: 0.5, metallic: 0.5 });
  const place = (t: number): Vec3 => [WAY * (shuttle(start + t / PERIOD) - 0.5), y, OUT];
  const motion = sampledAt(moments(start), (t) => ({ position: place(t), orientation: IDENTITY }));
  const foot = turned(
    [
      [0.2, -LANE / 2 + 0.17],
      [0.2, -LANE / 2 + 0.24],
      [0.06, -LANE / 2 + 0.3],
      [0.05, -0.2],
    ],
    20,
  );
  const globe = insideOut(sphere(RADIUS, { segments: 28, rings: 14, axis: 'Y' }));
  builder.object(`/World/${name}`, [paint(globe, glass), paint(foot, brass)], motion);
  const shining = spectralLight(LIGHT_PRESETS.get(preset)!.spectrum, luminance);
  const lifetime = { birth: -Infinity, death: Infinity };
  return { kind: 'sphere', path: `/World/${name}Light`, motion, lifetime, radius: 0, ...shining };
}

/** Sample times: dense where a lamp turns around, since its colour shows every step of its speed; sparse at constant speed. */
function moments(start: number): number[] {
  const dense = Array.from({ length: 31 * 240 }, (_, i) => FROM - 6 + i / 240);
  const toTurn = (t: number): number => Math.abs(start + t / PERIOD - Math.round(start + t / PERIOD));
  return dense.filter((t, i) => i === 0 || i === dense.length - 1 || toTurn(t) <= TURN_SHARE + 1 / (240 * PERIOD));
}
