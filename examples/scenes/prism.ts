import { IDENTITY } from '../../src/math/quat.ts';
import { add, type Vec3 } from '../../src/math/vec3.ts';
import { sphere } from '../../src/scene/mesh/primitives.ts';
import type { Light, RigidMotion, Scene } from '../../src/scene/types.ts';
import { MATERIAL_PRESETS } from '../../src/spectrum/reflectance/materialPresets.ts';
import { at, type Part, paint, SceneBuilder, spectralLight } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera, lookFrom, sampled, shuttle, smoothRamp } from '../kit/flight.ts';
import { bar, block, moved } from '../kit/parts.ts';

const C = 2;
const [FROM, TO] = [0, 34];
/** Length [m] and duration [s] of a path from end to end; 0.34 c in the middle. */
const [WAY, PERIOD] = [4.4, 7.353];
/** Nearest position of a chart [m]. */
const NEAR = 0.1;

/** The 24 colours of the ColorChecker chart in sRGB, row by row (McCamy, Marcus and Davidson 1976; sRGB as rounded by X-Rite). */
const CHART = [
  ['#735244', '#c29682', '#627a9d', '#576c43', '#8580b1', '#67bdaa'],
  ['#d67e2c', '#505ba6', '#c15a63', '#5e3c6c', '#9dbc40', '#e0a32e'],
  ['#383d96', '#469449', '#af363c', '#e7c71f', '#bb5695', '#0885a1'],
  ['#f3f3f2', '#c8c8c8', '#a0a0a0', '#7a7a79', '#555555', '#343434'],
];
/** Distance of the outer charts from the middle one [m]. */
const SIDE = 2.55;
/** Side of a field, and gap between fields [m]. */
const [FIELD, GAP] = [0.3, 0.05];
const COLUMNS = CHART[0].length;

export const scene: ExampleScene = { name: 'prism', make };

function make(): Scene {
  const builder = new SceneBuilder();
  studio(builder);
  const part = chart(builder);
  const rest: RigidMotion = at([0, 0, NEAR - WAY / 2]);
  const charts: [string, RigidMotion][] = [
    ['Left', coming(-SIDE, -4)],
    ['Still', rest],
    ['Right', coming(SIDE, 5)],
  ];
  for (const [name, motion] of charts) builder.object(`/World/${name}`, part, motion);
  const flight = camera({
    from: FROM,
    to: TO,
    fovY: 36,
    position: (t) => [0, 1.75 + 0.2 * smoothRamp(t / TO), 6 - 0.5 * smoothRamp(t / TO)],
    target: () => [0, 0.95, -2],
  });
  const hints = {
    speedOfLight: C,
    title: 'Prism',
    lookFor:
      'Three equal colour charts, each with its lamp: the left one comes towards you at 0.34 c, the right one goes away, the middle one rests; then they change about. What comes is bluer and brighter: its red and orange fields turn blue. What goes is redder and darker: its blue field turns red, its red one a dark teal. Below them are leaf, skin, asphalt, snow, gold and copper: the green leaf that comes is red, for its bright infrared is in sight.',
    openAt: 7.6,
  };
  return builder.finish(
    'prism',
    hints,
    [FROM, TO],
    [flight],
    [...charts.map(([name, motion]) => lamp(name, motion)), SKY],
  );
}

/** Fields on a black board, with spheres of six substances below. */
function chart(builder: SceneBuilder): Part {
  const [width, height] = [COLUMNS, CHART.length].map((n) => n * (FIELD + GAP) + GAP);
  const board = builder.material('board', '#17181a', { roughness: 0.6 });
  const fields = CHART.flatMap((row, j) =>
    row.map((color, i) => {
      const material = builder.material(`field${j}${i}`, color, { roughness: 1 });
      const y = 0.75 + height - (j + 1) * (FIELD + GAP);
      return paint(block(FIELD, FIELD, 0.03, 1, [across(i), y, 0.02]), material);
    }),
  );
  const balls = [...MATERIAL_PRESETS.keys()].map((name, i) =>
    paint(moved(sphere(0.155, { segments: 24, rings: 12, axis: 'Y' }), [across(i), 0.47, 0.1]), builder.preset(name)),
  );
  const stand: Part = [
    paint(block(width, height, 0.04, 1, [0, 0.75, -0.02]), board),
    paint(block(width, 0.06, 0.4, 1, [0, 0.26, 0.1]), board),
    paint(block(0.1, 0.8, 0.06, 1, [0, 0, -0.06]), board),
    paint(bar([0, 0.1, 0], [0, 0.1, ARM[2] + 0.1], 0.06), board),
  ];
  return [...stand, ...fields, ...balls];
}

const across = (i: number): number => (i - (COLUMNS - 1) / 2) * (FIELD + GAP);

function studio(builder: SceneBuilder): void {
  const floor = builder.material('studio', '#6d6d6d', { roughness: 0.9 });
  const rail = builder.material('rail', '#9a9fa6', { roughness: 0.35, metallic: 0.8 });
  builder.object('/World/Floor', [paint(block(24, 0.2, 30, 1, [0, -0.2, -5]), floor)]);
  const from = NEAR - WAY - 1.2;
  for (const [k, x] of [-SIDE, SIDE].entries())
    builder.object(`/World/Rail${k}`, [paint(block(0.16, 0.03, WAY + 2.4, 1, [x, 0, from + WAY / 2 + 1.2]), rail)]);
}

/** Motion of a chart towards the observer and back; `start`: initial phase of the shuttle. */
const coming = (x: number, start: number): RigidMotion =>
  sampled(FROM - 16, TO + 1, 48, (t) => ({
    position: [x, 0, NEAR - WAY * (1 - shuttle(start + t / PERIOD))],
    orientation: IDENTITY,
  }));

/** Each chart has its own lamp that moves along, so that its light is shifted only once. */
function lamp(name: string, motion: RigidMotion): Light {
  const lifetime = { birth: -Infinity, death: Infinity };
  const daylight = spectralLight({ kind: 'thermal', temperature: 5800 }, 11);
  return {
    kind: 'sphere',
    path: `/World/${name}Lamp`,
    motion: carried(motion),
    lifetime,
    radius: 0,
    shaping: CONE,
    ...daylight,
  };
}

const CONE = { inner: 0.42, outer: 0.75, focus: 0 };
/** Position of a lamp relative to its chart [m]; it points down at it. */
const ARM: Vec3 = [0, 2.3, 2.1];
const DOWN = lookFrom(ARM, [0, 1.05, 0]);

function carried(motion: RigidMotion): RigidMotion {
  if (motion.kind === 'static') return at(add(motion.pose.position, ARM), DOWN);
  if (motion.kind !== 'sampled') throw new Error('charts rest or are sampled');
  const poses = motion.poses.map((x, i) => (i % 7 < 3 ? x + ARM[i % 7] : DOWN[(i % 7) - 3]));
  return { ...motion, poses };
}

const SKY: Light = {
  kind: 'dome',
  path: '/World/Sky',
  ...spectralLight({ kind: 'thermal', temperature: 6504 }, 0.022),
};
