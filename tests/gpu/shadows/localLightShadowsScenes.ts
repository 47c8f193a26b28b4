import { fromAxisAngle, IDENTITY } from '../../../src/math/quat.ts';
import { add, addScaled, sub, type Vec3, ZERO } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { apparentPosition } from '../../../src/physics/optics/apparentPosition.ts';
import type { TracedScene } from '../../../src/reference/intersection/tracedScene.ts';
import type { RasterRenderer } from '../../../src/render/api.ts';
import { restingAt } from '../../../src/scene/defaults.ts';
import { box, plane, sphere } from '../../../src/scene/mesh/primitives.ts';
import type { LocalLight, Motion, RigidMotion, UniformMotion } from '../../../src/scene/types.ts';
import { lookAtOrientation } from '../../../src/scene/view/camera.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import type { RenderSettings, ViewPoint } from '../../../src/scene/view/view.ts';
import { area, GREY, lambert, lamp, lit } from '../../support/lightKit.ts';

export const SIZE = 96;

/** Objects on a floor, lit by local lights only. */
export interface LocalLightScene {
  readonly name: string;
  readonly scene: TracedScene;
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
}

const MATT = { ...lambert(0.7), ior: 1.5, roughness: 1 };
const FLOOR = { mesh: plane(30, 30, 'Y'), material: MATT, motion: restingAt(ZERO) };
const DOWN = fromAxisAngle([1, 0, 0], -Math.PI / 2);
const TURN = fromAxisAngle([0, 1, 0], 0.5);
const BALL = sphere(0.5, { segments: 64, rings: 32 });
const BOX = box([0.9, 0.8, 0.6]);

/** Uniform motion that is at a position when light from there, or from nearby, is seen. */
const passing = (place: Vec3, velocity: Vec3, delay: number, orientation = IDENTITY): UniformMotion => ({
  kind: 'uniform',
  pose: { position: addScaled(place, velocity, delay), orientation },
  velocity,
});

const EYE: Vec3 = [0.6, 4.2, 3.6];
const AT: Vec3 = [0.2, 0.2, 0];

function lampScene(
  name: string,
  things: readonly { readonly mesh: typeof BALL; readonly motion: Motion }[],
  lights: readonly LocalLight[],
  { beta = ZERO, ...change }: Partial<RenderSettings> & { readonly beta?: Vec3 } = {},
): LocalLightScene {
  const u = properVelocity(beta);
  const shown = apparentPosition(sub(AT, EYE), u);
  const orientation = lookAtOrientation(shown, [0, 1, 0]);
  const view = { t: 0, position: EYE, u, orientation, lens: perspective(0.9) };
  const scene = lit([FLOOR, ...things.map((thing) => ({ ...thing, material: MATT }))], lights);
  return { name, scene, view, settings: { ...GREY, grid: false, ...change } };
}

const ball = { mesh: BALL, motion: restingAt([0, 0.9, 0]) };
const crate = {
  mesh: BOX,
  motion: { kind: 'static', pose: { position: [0.6, 0.4, 0.5], orientation: TURN } },
} as const;
/** Light travel time from the floor's centre to the observer. */
const SEEN = Math.hypot(...sub(EYE, [0, 0.9, 0]));
const HIGH: Vec3 = [-0.7, 2.6, -0.4];
const over = (height: number): { readonly motion: RigidMotion } => ({
  motion: { kind: 'static', pose: { position: add(HIGH, [0, height - 2.6, 0]), orientation: DOWN } },
});
const spot = { shaping: { inner: 0.35, outer: 0.45, focus: 0 }, motion: over(3).motion };

export const LOCAL_LIGHT_SCENES: readonly LocalLightScene[] = [
  lampScene('a point', [ball, crate], [lamp(HIGH)]),
  lampScene('a point seen at 0.8 c', [ball, crate], [lamp(HIGH)], { beta: [0.3, -0.5, -0.55] }),
  lampScene('a spot', [ball, crate], [lamp([0, 0, 0], spot)]),
  lampScene('a ball', [ball, crate], [lamp(HIGH, { radius: 0.2 })]),
  lampScene('a rectangle', [ball, crate], [area('rect', HIGH, { width: 0.6, height: 0.3, ...over(2.6) })]),
  lampScene('a tube', [ball, crate], [area('cylinder', HIGH, { radius: 0.04, length: 0.8, ...over(2.6) })]),
  lampScene(
    'a ball that flies under it at 0.6 c',
    [{ mesh: BALL, motion: passing([0, 0.9, 0], [0.6, 0, 0], SEEN) }, crate],
    [lamp(HIGH)],
  ),
  lampScene(
    'a box of the world that flies at 0.8 c',
    [{ mesh: BOX, motion: passing([0, 0.9, 0], [0.7, 0, -0.387], SEEN, TURN) }],
    [lamp(HIGH)],
  ),
  lampScene(
    'a point that flies past at 0.6 c',
    [ball, crate],
    [lamp(ZERO, { motion: passing(HIGH, [0.6, 0, 0], SEEN + 1.5) })],
  ),
  lampScene(
    'a lamp and a ball that fly together at 0.6 c',
    [{ mesh: BALL, motion: passing([0, 0.9, 0], [0.6, 0, 0], SEEN) }],
    [lamp(ZERO, { motion: passing(HIGH, [0.6, 0, 0], SEEN) })],
  ),
  lampScene(
    'at one instant of the world',
    [{ mesh: BALL, motion: passing([0, 0.9, 0], [0.6, 0, 0], 0) }, crate],
    [lamp(HIGH)],
    { lightDelay: false },
  ),
  lampScene('a cone that turns as it goes', [ball, crate], [lamp(ZERO, { motion: turning(), shaping: spot.shaping })]),
  lampScene(
    'six points, and one ball that flies',
    [{ mesh: BALL, motion: passing([0, 0.9, 0], [0.6, 0, 0], SEEN) }, crate],
    [0, 1, 2, 3, 4, 5].map((k) => lamp([2.2 * Math.cos(k), 2.2 + 0.2 * k, 2.2 * Math.sin(k)])),
  ),
];

/** Moving slowly above the floor, looking down. */
function turning(): RigidMotion {
  const times = Float64Array.from({ length: 30 }, (_, k) => -16 + k);
  const poses = Array.from(times, (t) => [
    ...[-0.7 + 0.3 * Math.sin(0.3 * t), 3 + 0.2 * Math.cos(0.3 * t), -0.3],
    ...fromAxisAngle([1, 0, 0], -Math.PI / 2 + 0.15 * Math.sin(0.4 * t)),
  ]);
  return { kind: 'sampled', times, poses: Float64Array.from(poses.flat()) };
}

/** Light of each pixel, with or without shadows. */
export async function renderLight(
  renderer: RasterRenderer,
  { scene, view, settings }: LocalLightScene,
  shadows = true,
): Promise<number[]> {
  await renderer.setScene(scene.scene);
  renderer.render([view], { ...settings, shadows });
  const light = await renderer.readAov('beauty');
  return Array.from({ length: light.length / 3 }, (_, i) => light[3 * i + 1]);
}

/** A ball moving above the floor, below a point light at rest, and its position at t = 0. */
export function sphereOver(velocity: Vec3) {
  const ball = addScaled([0, 0.9, 0], velocity, SEEN);
  const motion: Motion = { kind: 'uniform', pose: { position: ball, orientation: IDENTITY }, velocity };
  const scene = lampScene('a ball', [{ mesh: BALL, motion }], [lamp(HIGH)]);
  return { scene, lamp: HIGH, ball, radius: 0.5 };
}
