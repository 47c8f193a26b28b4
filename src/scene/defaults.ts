import { IDENTITY } from '../math/quat.ts';
import { type Vec3, ZERO } from '../math/vec3.ts';
import type { Lifetime, Material, Mesh, Motion, Pose, Scene, SceneObject, StaticMotion } from './types.ts';

export const FOREVER: Lifetime = { birth: Number.NEGATIVE_INFINITY, death: Number.POSITIVE_INFINITY };
export const IDENTITY_POSE: Pose = { position: ZERO, orientation: IDENTITY };

/** At rest at `position` [m], without rotation. */
export const restingAt = (position: Vec3): StaticMotion => ({
  kind: 'static',
  pose: { position, orientation: IDENTITY },
});

/** A matt, light grey, opaque material by default; the base colour is linear. */
export const makeMaterial = (given: Partial<Material> & Pick<Material, 'name'>): Material => ({
  baseColor: [0.5, 0.5, 0.5],
  emissive: ZERO,
  roughness: 0.6,
  metallic: 0,
  opacity: 1,
  opacityThreshold: 0,
  ...given,
});

/** By default an object at rest at the origin, authored in the world frame, that always exists. */
export const makeObject = (
  given: Partial<SceneObject> & { readonly path: string; readonly mesh: Mesh },
): SceneObject => ({
  motion: restingAt(ZERO) satisfies Motion,
  lifetime: FOREVER,
  authoredIn: 'world',
  ...given,
});

/** By default an empty scene in metres with Y up. Material 0 always exists. */
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
