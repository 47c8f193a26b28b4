import { determinant } from '../../../../math/mat3.ts';
import { fromParts, linearPart, type Mat4, scaledUniformly, transpose } from '../../../../math/mat4.ts';
import { add } from '../../../../math/vec3.ts';
import { boundingSphere } from '../../../../scene/bounds/bounds.ts';
import { flippedWinding } from '../../../../scene/mesh/meshOps.ts';
import { pointSamples } from '../../../../scene/motion/motion.ts';
import { type BlendedPoints, jointMatrices, matrixAt } from '../../../../scene/streaming/blendedPoints.ts';
import { isBlended } from '../../../../scene/streaming/samplePoints.ts';
import type { Motion, SceneObject } from '../../../../scene/types.ts';
import { distanceOf, keptKeys } from '../../../write/jointTracks.ts';
import { KEY_TOLERANCE } from '../../../write/skeletons.ts';
import { sampled } from '../../layer/specs.ts';
import { tuple } from '../../layer/values.ts';
import { orderOf, type WriteContext } from '../motions.ts';
import type { MeshForm } from '../prims.ts';

type CarriedMotion = Extract<Motion, { readonly kind: 'sampled-points' }> & { readonly points: BlendedPoints };

/** The motion of a mesh that follows one joint as a whole, which may scale and shear it; undefined for all others. */
export function carriedMotion({ motion }: SceneObject): CarriedMotion | undefined {
  const samples = pointSamples(motion);
  if (!samples || !isBlended(samples.points)) return undefined;
  const { points } = samples;
  const isAlone = points.poses.tree.names.length === 1 && points.joints.length === 1;
  return isAlone && points.shapes.length === 0 ? { ...samples, points } : undefined;
}

/** As its rest shape and a matrix over time: USD interpolates matrices element by element, so that all points go straight. */
export function carriedForm(object: SceneObject, placement: WriteContext): MeshForm | undefined {
  const motion = carriedMotion(object);
  if (!motion) return undefined;
  const { times, origin, points } = motion;
  const { mesh } = object;
  const matrices = Array.from(times, (_, k): Mat4 => {
    const m = matrixAt(jointMatrices(points, k), 0);
    return fromParts(linearPart(m), add(origin, [m[3], m[7], m[11]]));
  });
  const { center, radius } = boundingSphere(points.rest.positions);
  const reach = radius + Math.hypot(...center);
  const tolerance = KEY_TOLERANCE * radius * Math.hypot(...linearPart(matrices[0]));
  const keys = keptKeys(times.length, (from, to) => {
    for (let k = from + 1; k < to; k++) {
      const s = (times[k] - times[from]) / (times[to] - times[from]);
      const mixed = matrices[from].map((x, i) => x + s * (matrices[to][i] - x));
      if (!(distanceOf(mixed, matrices[k], reach) <= tolerance)) return false;
    }
    return true;
  });
  const codes = Float64Array.from(keys, (k) => times[k] * placement.codesPerSecond);
  const written = (k: number) => {
    return tuple('matrix4d', transpose(scaledUniformly(matrices[k], 1 / placement.metersPerUnit)));
  };
  return {
    rest: points.rest,
    indices: determinant(linearPart(matrices[0])) < 0 ? flippedWinding(mesh.indices) : mesh.indices,
    transform: [
      sampled('matrix4d', 'xformOp:transform', codes, (i) => written(keys[i])),
      orderOf(placement, 'xformOp:transform'),
    ],
  };
}
