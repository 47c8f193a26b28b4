import { rotate } from '../../math/quat.ts';
import { lerp, type Vec3 } from '../../math/vec3.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import { deformedPoints } from '../../scene/motion/deformedPoints.ts';
import { pieceAt, samplePose } from '../../scene/motion/poses.ts';
import { normalsAt as normalsAtSample } from '../../scene/streaming/samplePoints.ts';
import type { SceneObject } from '../../scene/types.ts';

// Vertices of an object as it is at a world time t.

/** Vertex → place on the world's slice t (or, of what is authored at rest, in its rest frame), from an origin that they share. */
export function vertexPositionsAt({ mesh, motion }: SceneObject, t: number, c: number): (vertex: number) => Vec3 {
  const own = (i: number): Vec3 => pointAt(mesh.positions, i);
  switch (motion.kind) {
    case 'sampled': {
      const { before, after, s } = pieceAt(motion.times, t);
      const [a, b] = [samplePose(motion.poses, before).orientation, samplePose(motion.poses, after).orientation];
      return (i) => lerp(rotate(a, own(i)), rotate(b, own(i)), s);
    }
    case 'sampled-points':
      return deformedPoints(motion, t, c);
    default:
      return (i) => rotate(motion.pose.orientation, own(i));
  }
}

/** Vertex → normal as the object has it at world time t, on the world's axes, not unit. */
export function vertexNormalsAt({ mesh, motion }: SceneObject, t: number): (vertex: number) => Vec3 {
  const own = (i: number): Vec3 => pointAt(mesh.normals, i);
  switch (motion.kind) {
    case 'sampled': {
      const { before, after, s } = pieceAt(motion.times, t);
      const [a, b] = [samplePose(motion.poses, before).orientation, samplePose(motion.poses, after).orientation];
      return (i) => lerp(rotate(a, own(i)), rotate(b, own(i)), s);
    }
    case 'sampled-points': {
      const { before, after, s } = pieceAt(motion.times, t);
      const [a, b] = [normalsAtSample(motion, before), normalsAtSample(motion, after)];
      if (!a || !b) return own;
      return (i) => lerp(pointAt(a, i), pointAt(b, i), s);
    }
    default:
      return (i) => rotate(motion.pose.orientation, own(i));
  }
}
