import { IDENTITY, multiply as times, transform } from '../../../math/mat3.ts';
import { conjugate, multiply, rotationAngle, toMatrix } from '../../../math/quat.ts';
import { add, length, sub, type Vec3 } from '../../../math/vec3.ts';
import { type BoundingSphere, objectBoundingSphere } from '../../bounds/bounds.ts';
import type { StretchedPoints } from '../../mesh/stretch.ts';
import type { SampledMotion } from '../../types.ts';
import { samplePose } from '../poses.ts';
import { type FastestVertex, REST } from './motionKind.ts';

/** The fastest vertex of a rigid body between samples. */
export function fastestOfPoses(object: StretchedPoints, motion: SampledMotion, atLeast: number): FastestVertex {
  const sphere = objectBoundingSphere(object);
  let best: FastestVertex = { ...REST, speed: atLeast };
  for (let k = 0; k + 1 < motion.times.length; k++) {
    const piece = rigidPiece(motion, k);
    if (piece.bound(sphere) > best.speed) best = fastestOfPiece(piece, object, best);
  }
  return best.from === REST.from ? REST : best;
}

interface RigidPiece {
  readonly from: number;
  readonly to: number;
  /** The displacement of x during the piece is moved + turned · x. */
  readonly moved: Vec3;
  readonly turned: readonly number[];
  /** No point of the sphere is faster [m/s]. */
  bound(sphere: BoundingSphere): number;
}

function rigidPiece({ times, poses }: SampledMotion, k: number): RigidPiece {
  const [a, b] = [samplePose(poses, k), samplePose(poses, k + 1)];
  const [ra, rb] = [toMatrix(a.orientation), toMatrix(b.orientation)];
  const moved = sub(b.position, a.position);
  const turned = rb.map((x, i) => x - ra[i]);
  // The chord of a turn by θ at distance r from the axis.
  const chord = 2 * Math.sin(rotationAngle(multiply(conjugate(a.orientation), b.orientation)) / 2);
  const [from, to] = [times[k], times[k + 1]];
  const bound = ({ center, radius }: BoundingSphere) =>
    ((length(add(moved, transform(turned, center))) + chord * radius) / (to - from)) * (1 + 1e-12);
  return { from, to, moved, turned, bound };
}

function fastestOfPiece(
  { from, to, moved, turned }: RigidPiece,
  { mesh: { positions }, stretch = IDENTITY }: StretchedPoints,
  best: FastestVertex,
): FastestVertex {
  const m = times(turned, stretch);
  let longest = best.speed * (to - from);
  let vertex = -1;
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = [positions[i], positions[i + 1], positions[i + 2]];
    const dx = moved[0] + m[0] * x + m[1] * y + m[2] * z;
    const dy = moved[1] + m[3] * x + m[4] * y + m[5] * z;
    const dz = moved[2] + m[6] * x + m[7] * y + m[8] * z;
    const d = Math.sqrt(dx * dx + dy * dy + dz * dz);
    if (d > longest) [longest, vertex] = [d, i / 3];
  }
  return vertex < 0 ? best : { speed: longest / (to - from), vertex, from, to };
}
