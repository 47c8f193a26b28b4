import { dot, float, int, vec3, vec4 } from 'three/tsl';
import { rotate } from '../../../math/quat.ts';
import { lerp, scale, sub, type Vec3, ZERO } from '../../../math/vec3.ts';
import { properVelocity } from '../../../physics/lorentz/boost.ts';
import { contraction } from '../../../physics/worldLines/simultaneity.ts';
import { positionAt } from '../../../physics/worldLines/worldLine.ts';
import { pieceAt, samplePose } from '../../../scene/motion/poses.ts';
import type { Motion } from '../../../scene/types.ts';
import type { Int, Vec3 as Vector } from '../../../shaders/types.ts';
import type { DrawCall } from '../../gbuffer/drawCall.ts';
import type { Body } from '../../geometry/bodies.ts';
import type { VertexInput } from '../../geometry/vertexInput.ts';
import { FloatTable } from '../../gpu/floatTable.ts';
import type { CasterPlacement } from './casterMesh.ts';

/** From a vertex as it is uploaded to the world, from the body's centre [m]: the places of the unit vectors. */
export type LinearMap = readonly [Vec3, Vec3, Vec3];

/** What deforms or is accelerated as Born-rigid bodies are: not one turn and place are those of all of it. */
export const isSolvedPerVertex = <M extends Pick<Motion, 'kind'>>(
  motion: M,
): motion is Extract<M, { readonly kind: 'sampled-points' | 'hyperbolic' }> =>
  motion.kind === 'sampled-points' || motion.kind === 'hyperbolic';

/**
 * How a rigid body is turned and contracted at one moment of the world, a time t [s] of its own; c [m/s]. `worn`: its mesh is uploaded in its own axes.
 * undefined where it has not one turn for all of it: it deforms, or accelerates as a Born-rigid body does.
 */
export function linearMapOf({ object }: Body, instanced: boolean, t: number, c: number): LinearMap | undefined {
  const { motion, authoredIn } = object;
  const turn = (of: (axis: Vec3) => Vec3): LinearMap => [of([1, 0, 0]), of([0, 1, 0]), of([0, 0, 1])];
  if (isSolvedPerVertex(motion)) return undefined;
  if (motion.kind === 'sampled') {
    const { before, after, s } = pieceAt(motion.times, t);
    const [a, b] = [before, after].map((k) => samplePose(motion.poses, k).orientation);
    // As each vertex goes: straight from sample to sample.
    return turn((axis) => lerp(rotate(a, axis), rotate(b, axis), s));
  }
  const turned = (axis: Vec3): Vec3 => (instanced ? rotate(motion.pose.orientation, axis) : axis);
  if (motion.kind === 'static' || authoredIn === 'world') return turn(turned);
  const u = properVelocity(scale(motion.velocity, 1 / c));
  return turn((axis) => contraction(turned(axis), u));
}

/** Slot of what has none of its own, and is drawn where all that is round a lamp is. */
export const SURROUNDINGS = -2;
/** Texels of a body: rows of its turn with its place, and its slot with its velocity [c]. */
const POSE_TEXELS = 4;

/** Where rigid occluders are, from where a layer's places are measured, and the slot that each has; by the number of a body. */
export class PoseTable {
  private readonly table = new FloatTable(256);

  constructor(bodies: number) {
    this.table.reserve(bodies * POSE_TEXELS);
    this.clear();
  }

  /** None is drawn. */
  clear(): void {
    this.table.values.fill(-1);
  }

  set({ id }: Body, [x, y, z]: LinearMap, place: Vec3, slot: number, beta: Vec3 = ZERO): void {
    const rows = [0, 1, 2].flatMap((k) => [x[k], y[k], z[k], place[k]]);
    this.table.values.set([...rows, slot, ...beta], 4 * POSE_TEXELS * (id - 1));
  }

  /** Uploads where bodies are that rest, from `origin`. */
  setStatic(resting: readonly Body[], drawables: readonly DrawCall[], origin: Vec3): void {
    const worn = new Set(drawables.flatMap(({ batch }) => (batch.instancing ? batch.bodies : [])));
    for (const body of resting) {
      const turn = linearMapOf(body, worn.has(body), 0, 1);
      if (turn) this.set(body, turn, sub(positionAt(body.line, 0, 1), origin), 0);
    }
    this.upload();
  }

  upload(): void {
    this.table.upload();
  }

  /** Slots are layers from `first` on; where `round` is 1, only what is round a lamp is drawn, on that layer. */
  placement(first: Int, round?: Int): CasterPlacement {
    return ({ object, offset }) => {
      const begin = int(object).mul(int(POSE_TEXELS)).toVar();
      const texel = (k: number) => this.table.texel(begin.add(int(k)));
      const slot = int(texel(3).x).toVar();
      const point = vec4(offset, float(1));
      const own = slot.lessThan(int(0)).select(int(-1), slot.add(first));
      const shared = slot.equal(int(SURROUNDINGS)).select(first, int(-1));
      return {
        layer: round ? round.greaterThan(int(0)).select(shared, own) : own,
        x: () => vec3(dot(texel(0), point), dot(texel(1), point), dot(texel(2), point)),
      };
    };
  }

  /** The velocity of the body that a vertex is of [c]. */
  velocity({ object }: VertexInput): Vector {
    const last = int(object)
      .mul(int(POSE_TEXELS))
      .add(int(POSE_TEXELS - 1));
    return this.table.texel(last).yzw;
  }

  dispose(): void {
    this.table.dispose();
  }
}
