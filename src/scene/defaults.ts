import { IDENTITY } from '../math/quat.ts';
import { type Vec3, ZERO } from '../math/vec3.ts';
import type { Lifetime, Material, Mesh, Motion, Pose, Scene, SceneObject, StaticMotion } from './types.ts';

/**
 * The lifetime of what always exists.
 * @example
 * FOREVER; // { birth: -Infinity, death: Infinity }
 */
export const FOREVER: Lifetime = { birth: Number.NEGATIVE_INFINITY, death: Number.POSITIVE_INFINITY };
/**
 * At the origin, without rotation.
 * @example
 * IDENTITY_POSE; // { position: [0, 0, 0], orientation: [0, 0, 0, 1] }
 */
export const IDENTITY_POSE: Pose = { position: ZERO, orientation: IDENTITY };

/**
 * At rest at `position` [m], without rotation.
 * @example
 * restingAt([1, 2, 3]).pose.position; // [1, 2, 3] m
 */
export const restingAt = (position: Vec3): StaticMotion => ({
  kind: 'static',
  pose: { position, orientation: IDENTITY },
});

/**
 * A matt, light grey, opaque material by default; the base colour is linear.
 * @example
 * makeMaterial({ name: 'gold', baseColor: [0.94, 0.73, 0.33], metallic: 1 }).roughness; // 0.6
 */
export const makeMaterial = (given: Partial<Material> & Pick<Material, 'name'>): Material => ({
  baseColor: [0.5, 0.5, 0.5],
  emissive: ZERO,
  roughness: 0.6,
  metallic: 0,
  opacity: 1,
  opacityThreshold: 0,
  ...given,
});

/**
 * By default an object at rest at the origin, authored in the world frame, that always exists.
 * @example
 * // A die that flies past at 0.8 c, c = 10 m/s, and is a cube in its own frame.
 * const die = makeObject({
 *   path: '/Die',
 *   mesh: box([1, 1, 1]),
 *   motion: { kind: 'uniform', pose: IDENTITY_POSE, velocity: [8, 0, 0] },
 *   authoredIn: 'rest',
 * });
 * die.lifetime.birth; // -Infinity
 */
export const makeObject = (
  given: Partial<SceneObject> & { readonly path: string; readonly mesh: Mesh },
): SceneObject => ({
  motion: restingAt(ZERO) satisfies Motion,
  lifetime: FOREVER,
  authoredIn: 'world',
  ...given,
});

/**
 * By default an empty scene in metres with Y up. Material 0 always exists.
 * @example
 * const scene = makeScene({ name: 'a ball', objects: [makeObject({ path: '/Ball', mesh: sphere(1) })] });
 * scene.upAxis; // 'Y'
 * scene.materials.length; // 1
 */
export function makeScene(given: Partial<Scene> & Pick<Scene, 'name'>): Scene {
  const scene: Scene = {
    upAxis: 'Y',
    metersPerUnit: 1,
    timeCodesPerSecond: 24,
    startTime: 0,
    endTime: 0,
    objects: [],
    materials: [],
    lights: [],
    cameras: [],
    hints: {},
    diagnostics: [],
    ...given,
  };
  return scene.materials.length > 0 ? scene : { ...scene, materials: [makeMaterial({ name: 'default' })] };
}
