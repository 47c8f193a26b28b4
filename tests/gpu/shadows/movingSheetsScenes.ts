import { fromAxisAngle } from '../../../src/math/quat.ts';
import { normalize, scale, sub, type Vec3, ZERO } from '../../../src/math/vec3.ts';
import type { RasterRenderer } from '../../../src/render/api.ts';
import { FOREVER, makeMaterial, makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import { deformedNormals, smoothingGroups } from '../../../src/scene/mesh/normals.ts';
import { grid } from '../../../src/scene/mesh/primitives.ts';
import { parabolaVelocities } from '../../../src/scene/motion/cubicPoints.ts';
import type { Light, Mesh, Motion, SceneObject } from '../../../src/scene/types.ts';
import { lookAtOrientation } from '../../../src/scene/view/camera.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS } from '../../../src/scene/view/view.ts';

const [WIDTH, HEIGHT] = [128, 96];
/** Slow enough that light takes half a second past a sheet: they flap and turn by half a radian meanwhile. */
const SLOW_LIGHT = 8;
/** Height of the observer above the sheets, who therefore sees them as they were at about −HEIGHT_ABOVE/c. */
const HEIGHT_ABOVE = 24;
const TIMES = Float64Array.from({ length: 61 }, (_, k) => -6 + 0.1 * k);

const LIGHTS: Readonly<Record<string, Light>> = {
  sun: { kind: 'distant', path: '/Sun', direction: normalize([0.2, -1, -0.1]), color: [3, 3, 3], angle: 0.01 },
  lamp: {
    kind: 'sphere',
    path: '/Lamp',
    motion: restingAt([3, 40, 2]),
    lifetime: FOREVER,
    radius: 0.2,
    color: [3e4, 3e4, 3e4],
  },
};

/** A sheet whose right half hangs down from a hinge and flaps, 2 × 1 quads or more: no part of it is between the light and another. */
function flapping(mesh: Mesh, place: Vec3, cubic: boolean): Motion {
  const points = Array.from(TIMES, (t) => {
    const angle = -0.45 + 0.4 * Math.sin(2.2 * t);
    return mesh.positions.map((_, i) => {
      const [x, z] = [mesh.positions[i - (i % 3)], mesh.positions[i - (i % 3) + 2]];
      const turned: Vec3 = x < 0 ? [x, 0, z] : [x * Math.cos(angle), x * Math.sin(angle), z];
      return turned[i % 3];
    });
  });
  const groups = smoothingGroups(mesh);
  const normals = points.map((p) => deformedNormals(p, mesh.indices, groups));
  const samples = { kind: 'sampled-points', times: TIMES, origin: place, points, normals } as const;
  return cubic ? { ...samples, velocities: parabolaVelocities(TIMES, points) } : samples;
}

function turning(place: Vec3): Motion {
  const poses = Array.from(TIMES, (t) => [...place, ...fromAxisAngle([0, 0, 1], 0.7 * Math.sin(2.2 * t))]);
  return { kind: 'sampled', times: TIMES, poses: Float64Array.from(poses.flat()) };
}

const TILT = fromAxisAngle([0, 0, 1], 0.4);
const SEEN_AT = -HEIGHT_ABOVE / SLOW_LIGHT;

function gliding(place: Vec3): Motion {
  const velocity: Vec3 = [3.5, 1, 2];
  return {
    kind: 'uniform',
    pose: { position: sub(place, scale(velocity, SEEN_AT)), orientation: TILT },
    velocity,
  };
}

const accelerating = (place: Vec3): Motion => ({
  kind: 'hyperbolic',
  pose: { position: place, orientation: TILT },
  properAcceleration: [6, 4, 2],
  t0: SEEN_AT,
});

const MOTIONS: Readonly<Record<string, (mesh: Mesh, place: Vec3) => Motion>> = {
  flapping: (mesh, place) => flapping(mesh, place, false),
  'flapping along cubics': (mesh, place) => flapping(mesh, place, true),
  turning: (_, place) => turning(place),
  gliding: (_, place) => gliding(place),
  accelerating: (_, place) => accelerating(place),
};

const COARSE = grid(4, 2, 2, 1, 'Y');
const FINE = grid(4, 2, 24, 12, 'Y');

/** A coarse and a fine sheet of each motion, side by side: none is between the light and another. */
const SHEETS: readonly SceneObject[] = Object.entries(MOTIONS).flatMap(([name, motionOf], column) =>
  [COARSE, FINE].map((mesh, row) => {
    const place: Vec3 = [5.5 * (column - 2), 0, 5 * (row - 0.5)];
    return makeObject({ path: `/${row === 0 ? 'coarse' : 'fine'}: ${name}`, mesh, motion: motionOf(mesh, place) });
  }),
);

export interface SheetLight {
  readonly light: string;
  /** [m/s] */
  readonly speedOfLight: number;
}

export const SHEET_LIGHTS: readonly SheetLight[] = [
  { light: 'sun', speedOfLight: SLOW_LIGHT },
  { light: 'sun', speedOfLight: 299_792_458 },
  { light: 'lamp', speedOfLight: SLOW_LIGHT },
];

/** Of a sheet: its name, how many pixels are lit without shadows, and the mean fraction of their light that shadows take. */
export type SheetShade = readonly [name: string, pixels: number, shade: number];

export async function renderSheets(
  renderer: RasterRenderer,
  { light, speedOfLight }: SheetLight,
): Promise<SheetShade[]> {
  const lights: readonly Light[] = [LIGHTS[light], { kind: 'dome', path: '/Dark', color: ZERO }];
  const materials = [makeMaterial({ name: 'grey', baseColor: [0.6, 0.6, 0.6], roughness: 1 })];
  await renderer.setScene(makeScene({ name: 'sheets', objects: SHEETS, materials, lights }));
  renderer.setSize(WIDTH, HEIGHT);
  const position: Vec3 = [0, HEIGHT_ABOVE, 0.01];
  const orientation = lookAtOrientation(scale(position, -1), [0, 1, 0]);
  const settings = { ...DEFAULT_SETTINGS, speedOfLight, colors: 'approximate' } as const;
  const t = speedOfLight === SLOW_LIGHT ? 0 : SEEN_AT;
  const view = { t, position, u: ZERO, orientation, lens: perspective(0.75) };
  renderer.render([view], { ...settings, shadows: false });
  const open = await renderer.readAov('beauty');
  const object = await renderer.readAov('object');
  renderer.render([view], settings);
  const shaded = await renderer.readAov('beauty');
  return SHEETS.map(({ path }, k) => {
    const own = Array.from(object.keys()).filter((i) => object[i] === k + 1 && open[3 * i + 1] > 1e-4);
    const taken = own.map((i) => 1 - shaded[3 * i + 1] / open[3 * i + 1]);
    return [path.slice(1), own.length, taken.reduce((a, b) => a + b, 0) / own.length];
  });
}
