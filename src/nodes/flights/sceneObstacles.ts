import { boostOf } from '../../flight/boost.ts';
import type { Obstacles } from '../../flight/collision/obstacles.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { meshBvh } from '../../reference/acceleration/triangleBvh.ts';
import { createTracedScene, nearestHit } from '../../reference/intersection/tracedScene.ts';
import { quadricOf } from '../../scene/mesh/quadric.ts';
import type { Scene, SceneObject } from '../../scene/types.ts';

/** Whether an object is a wall. Those that deform are none: the outlines of all their samples would take seconds to build. */
export const isSolid = ({ motion }: SceneObject): boolean => motion.kind !== 'sampled-points';

/**
 * Builds what `sceneObstacles` needs of meshes that keep their shape, and that stays with them. `pause` is waited for after each
 * mesh, for the host to do something else.
 */
export async function prepareObstacles({ objects }: Scene, pause: () => Promise<void>): Promise<void> {
  for (const object of objects) {
    if (!isSolid(object) || object.motion.kind === 'sampled' || quadricOf(object)) continue;
    meshBvh(object.mesh);
    await pause();
  }
}

/**
 * The surfaces of a scene as obstacles of a flight, from either side, by the intersections of the reference renderer: a line of
 * events meets a body where it is at that world time, not where it is seen. c [m/s].
 */
export function sceneObstacles(scene: Scene, c: number): Obstacles {
  const traced = createTracedScene({ ...scene, objects: scene.objects.filter(isSolid) }, c);
  return {
    first({ start, dt, dx }, end) {
      const hit = nearestHit(traced, { t: start.t, x: start.x, dt: c * dt, dx }, { end });
      if (!hit) return undefined;
      const { time, position, velocity, normal } = hit;
      return { event: { t: time, x: position }, velocity: boostOf(properVelocity(velocity)), normal };
    },
  };
}
