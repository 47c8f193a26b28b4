import { fromAxisAngle, multiply } from '../../src/math/quat.ts';
import { type Vec3, ZERO } from '../../src/math/vec3.ts';
import { properVelocity } from '../../src/physics/lorentz/boost.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../../src/scene/defaults.ts';
import { box, plane, sphere } from '../../src/scene/mesh/primitives.ts';
import type { Mesh, Scene, SceneObject } from '../../src/scene/types.ts';
import { lookAtOrientation } from '../../src/scene/view/camera.ts';
import { perspective } from '../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../src/scene/view/view.ts';

/** A short, deterministic camera path, to measure flicker and error of pictures in motion. */
export interface CameraPath {
  readonly name: string;
  readonly scene: Scene;
  readonly settings: RenderSettings;
  /** The observer of picture `index`. */
  readonly view: (index: number) => ViewPoint;
}

/** Interval between pictures [s]. */
export const FRAME_TIME = 1 / 30;

const LIGHT = makeMaterial({ name: 'light', baseColor: [0.8, 0.78, 0.7] });
const DARK = makeMaterial({ name: 'dark', baseColor: [0.05, 0.06, 0.08] });
const withMaterial = (mesh: Mesh, material: number): Mesh => ({
  ...mesh,
  groups: mesh.groups.map((group) => ({ ...group, material })),
});
const standing = (path: string, mesh: Mesh, at: Vec3): SceneObject => makeObject({ path, mesh, motion: restingAt(at) });

/** Slats on a floor and thin posts, into the distance, where they become thinner than pixels. */
function slats(): SceneObject[] {
  const floor = standing('/floor', withMaterial(plane(40, 80, 'Y'), 0), [0, 0, -40]);
  const slat = withMaterial(box([12, 0.02, 0.25]), 1);
  const post = withMaterial(box([0.06, 2, 0.06]), 1);
  return [
    floor,
    ...Array.from({ length: 100 }, (_, i) => standing(`/slat${i}`, slat, [0, 0.01, -2 - 0.5 * i])),
    ...Array.from({ length: 40 }, (_, i) => standing(`/post${i}`, post, [i % 2 ? 3 : -3, 1, -3 - 1.1 * i])),
  ];
}

const eye = (u: Vec3, position: Vec3): ViewPoint => ({
  t: 0,
  position,
  u,
  orientation: lookAtOrientation([0, -0.15, -1], [0, 1, 0]),
  lens: perspective(1),
});
const SETTINGS: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: 10 };

/** A slowly turning camera, by a third of a pixel per picture of 100 rows. */
export function turning(beta: number): CameraPath {
  const view = eye(properVelocity([0, 0, -beta]), [0, 1.6, 0]);
  const at = (index: number): ViewPoint => ({
    ...view,
    orientation: multiply(fromAxisAngle([0, 1, 0], -0.0033 * index), view.orientation),
  });
  const scene = makeScene({ name: 'floor', objects: slats(), materials: [LIGHT, DARK] });
  return { name: `floor, turning, ${beta} c`, scene, settings: SETTINGS, view: at };
}

/** Balls passing at 0.6 c in front of objects at rest. */
export function passing(): CameraPath {
  const ball = withMaterial(sphere(0.5), 0);
  const v: Vec3 = [6, 0, 0];
  const balls = [-2.4, 0, 2.4].map((x, i) =>
    makeObject({
      path: `/ball${i}`,
      mesh: ball,
      motion: { kind: 'uniform', pose: { position: [x - 3, 1 + 0.4 * i, -5], orientation: [0, 0, 0, 1] }, velocity: v },
    }),
  );
  const wall = Array.from({ length: 40 }, (_, i) =>
    standing(`/lath${i}`, withMaterial(box([0.12, 6, 0.1]), 1), [-8 + 0.4 * i, 1, -9]),
  );
  const view = eye(ZERO, [0, 1.6, 0]);
  const at = (index: number): ViewPoint => ({ ...view, t: FRAME_TIME * index });
  const scene = makeScene({
    name: 'passing',
    objects: [...slats().slice(0, 1), ...wall, ...balls],
    materials: [LIGHT, DARK],
  });
  return { name: 'balls passing, 0.6 c', scene, settings: SETTINGS, view: at };
}

/** Errors of a sequence against the true pictures, in 8-bit steps. */
export interface TemporalError {
  /** Mean |picture − truth| over channels, pixels and pictures. */
  readonly error: number;
  /** Mean |change between successive pictures − that of the truth|. */
  readonly flicker: number;
  /** The 99.9th percentile of |picture − truth|. */
  readonly worst: number;
}

export function temporalError(film: readonly Uint8Array[], truth: readonly Uint8Array[]): TemporalError {
  const errors: number[] = [];
  let [error, flicker, changes] = [0, 0, 0];
  film.forEach((picture, k) => {
    for (let i = 0; i < picture.length; i++) {
      if (i % 4 === 3) continue;
      const signedError = picture[i]! - truth[k]![i]!;
      errors.push(Math.abs(signedError));
      error += Math.abs(signedError);
      if (k === 0) continue;
      flicker += Math.abs(signedError - (film[k - 1]![i]! - truth[k - 1]![i]!));
      changes++;
    }
  });
  errors.sort((a, b) => a - b);
  return {
    error: error / errors.length,
    flicker: flicker / changes,
    worst: errors[Math.floor(0.999 * errors.length)]!,
  };
}
