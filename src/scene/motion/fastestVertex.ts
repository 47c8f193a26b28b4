import { transform } from '../../math/mat3.ts';
import { conjugate, multiply, rotationAngle, toMatrix } from '../../math/quat.ts';
import { add, length, sub, type Vec3 } from '../../math/vec3.ts';
import { withBend } from '../../physics/worldLines/cubicPiece.ts';
import { velocityAt } from '../../physics/worldLines/worldLine.ts';
import { type BoundingSphere, meshBoundingSphere } from '../bounds/bounds.ts';
import { longestDisplacement } from '../streaming/pointStatistics.ts';
import { isStreamed } from '../streaming/samplePoints.ts';
import type { SampledMotion, SampledPointsMotion, SceneObject } from '../types.ts';
import {
  bendFactor,
  type CubicPointsMotion,
  isCubic,
  maxControlSpeed,
  maxPieceSpeed,
  pointPiece,
  pointSpeedBound,
} from './cubicPoints.ts';
import { samplePose, vertexWorldLine } from './motion.ts';
import { restToWorld } from './resample.ts';

/** A greatest speed, and where and when. */
export interface FastestVertex {
  /** [m/s] */
  readonly speed: number;
  readonly vertex: number;
  /** World times between which it goes so fast [s]. */
  readonly from: number;
  readonly to: number;
}

const REST: FastestVertex = { speed: 0, vertex: 0, from: Number.NEGATIVE_INFINITY, to: Number.POSITIVE_INFINITY };

/**
 * The fastest vertex of an object, exactly: every vertex of every piece counts, not only the frame's origin. Hyperbolic
 * motion, which has no greatest speed, is judged at the ends of `range` [s]. c [m/s]. Pieces that cannot go faster than
 * `atLeast` [m/s] are not looked at in detail, and where none does the answer is at rest.
 */
export function fastestVertex(
  object: SceneObject,
  c: number,
  range: readonly [number, number] = [0, 0],
  atLeast = 0,
): FastestVertex {
  const { motion } = object;
  switch (motion.kind) {
    case 'static':
      return REST;
    case 'uniform':
      return { ...REST, speed: length(motion.velocity) };
    case 'hyperbolic':
      return fastestAtEnds(object, c, range);
    case 'sampled':
      return object.authoredIn === 'rest'
        ? fastestContracted(object, motion, c, atLeast)
        : fastestRigid(object, motion, atLeast);
    case 'sampled-points':
      return isCubic(motion) ? fastestCubic(motion, c, atLeast) : fastestPolyline(motion, atLeast);
  }
}

function fastestAtEnds(object: SceneObject, c: number, range: readonly [number, number]): FastestVertex {
  let best = REST;
  for (let i = 0; i < object.mesh.positions.length / 3; i++) {
    const line = vertexWorldLine(object, i, c);
    for (const t of range) {
      const speed = length(velocityAt(line, t, c));
      if (speed > best.speed) best = { speed, vertex: i, from: t, to: t };
    }
  }
  return best;
}

/** Where the frame itself reaches c there is nothing to contract by, and its speed is the answer. */
function fastestContracted(object: SceneObject, motion: SampledMotion, c: number, atLeast: number): FastestVertex {
  const frame = fastestRigid({ ...object, mesh: { ...object.mesh, positions: new Float32Array(3) } }, motion, 0);
  if (!(frame.speed < c)) return frame;
  return fastestVertex(restToWorld(object, c), c, [0, 0], atLeast);
}

function fastestRigid({ mesh }: SceneObject, motion: SampledMotion, atLeast: number): FastestVertex {
  const { positions } = mesh;
  const sphere = meshBoundingSphere(mesh);
  let best: FastestVertex = { ...REST, speed: atLeast };
  for (let k = 0; k + 1 < motion.times.length; k++) {
    const piece = rigidPiece(motion, k);
    if (piece.bound(sphere) > best.speed) best = fastestOfPiece(piece, positions, best);
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
  { from, to, moved, turned: m }: RigidPiece,
  positions: Float32Array,
  best: FastestVertex,
): FastestVertex {
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

function fastestPolyline({ times, points }: SampledPointsMotion, atLeast: number): FastestVertex {
  let best: FastestVertex = { ...REST, speed: atLeast };
  for (let k = 0; k + 1 < times.length; k++) {
    const { way, vertex } = isStreamed(points)
      ? { way: points.statistics.displacements[k], vertex: points.statistics.fastest[k] }
      : longestDisplacement(points[k], points[k + 1]);
    const speed = way / (times[k + 1] - times[k]);
    if (speed > best.speed) best = { speed, vertex, from: times[k], to: times[k + 1] };
  }
  return best.from === REST.from ? REST : best;
}

/** Of the motion as it is shown: where its bend would be faster than light, with less of it. */
function fastestCubic(motion: CubicPointsMotion, c: number, atLeast: number): FastestVertex {
  const { times } = motion;
  let best: FastestVertex = { ...REST, speed: atLeast };
  for (let k = 0; k + 1 < times.length; k++) {
    if (maxControlSpeed(motion, k) <= best.speed) continue;
    const bend = bendFactor(motion, k, c);
    for (let i = 0; 3 * i < motion.points[k].length; i++) {
      if (pointSpeedBound(motion, k, i) <= best.speed) continue;
      const speed = maxPieceSpeed(withBend(pointPiece(motion, k, i), bend), best.speed);
      if (speed > best.speed) best = { speed, vertex: i, from: times[k], to: times[k + 1] };
    }
  }
  return best.from === REST.from ? REST : best;
}
