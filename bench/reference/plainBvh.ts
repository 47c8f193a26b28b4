import { BufferAttribute, BufferGeometry, DoubleSide, Ray, Vector3 } from 'three';
import { MeshBVH, SAH } from 'three-mesh-bvh';
import type { Vec3 } from '../../src/math/vec3.ts';
import { poseAt } from '../../src/scene/motion/motion.ts';
import { applyPose } from '../../src/scene/motion/poses.ts';
import type { Scene } from '../../src/scene/types.ts';

/** Distance to the nearest surface [m] along a unit direction; undefined if there is none. */
export type StaticCaster = (from: Vec3, direction: Vec3) => number | undefined;

/** All objects of a static scene as one mesh in a three-mesh-bvh, built by the same heuristic as ours. */
export function plainBvh(scene: Scene, c: number): StaticCaster {
  const bvh = new MeshBVH(merged(scene, c), { strategy: SAH });
  const ray = new Ray(new Vector3(), new Vector3());
  return (from, direction) => {
    ray.origin.set(...from);
    ray.direction.set(...direction);
    return bvh.raycastFirst(ray, DoubleSide)?.distance;
  };
}

function merged(scene: Scene, c: number): BufferGeometry {
  const positions: number[] = [];
  const indices: number[] = [];
  for (const { mesh, motion } of scene.objects) {
    const base = positions.length / 3;
    const pose = poseAt(motion, 0, c);
    for (let i = 0; i < mesh.positions.length; i += 3) {
      positions.push(...applyPose(pose, [mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]]));
    }
    for (const index of mesh.indices) indices.push(base + index);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(positions), 3));
  geometry.setIndex(new BufferAttribute(Uint32Array.from(indices), 1));
  return geometry;
}
