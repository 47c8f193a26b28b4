import * as mat4 from '../../math/mat4.ts';
import { distance, type Vec3 } from '../../math/vec3.ts';
import { transformMesh } from '../../scene/meshOps.ts';
import { deformedNormals, smoothingGroups } from '../../scene/normals.ts';
import type { Mesh, SampledMotion, SampledPointsMotion, StaticMotion } from '../../scene/types.ts';
import { report, type StageContext } from './context.ts';
import { type Frame, scaledFrame } from './frame.ts';
import { boxCorners, refineTimes } from './sampling.ts';
import { unionOfTimes } from './xformOps.ts';

/** A mesh in its prim's own axes and stage units, and how its points change with time in there. */
export interface Shape {
  /** At the stage's start. */
  readonly mesh: Mesh;
  readonly deformation?: Deformation;
}
export interface Deformation {
  readonly times: Float64Array;
  /** 3 per vertex of the mesh. */
  positionsAt(time: number): Float32Array;
  /** Absent where normals have to be computed. */
  normalsAt?(time: number): Float32Array;
}

export interface Placed {
  readonly mesh: Mesh;
  readonly motion: StaticMotion | SampledMotion | SampledPointsMotion;
}

/** Stretches that differ by less than this part are one: what an exporter's f32 rounding leaves. */
const RIGID = 1e-5;

/**
 * The motion of a mesh. What does not change with time is static, its scale and shear in the mesh. What moves without
 * changing shape gets sampled poses; all else sampled points.
 */
export function placeShape(context: StageContext, path: string, shape: Shape, frame: Frame): Placed {
  const world = scaledFrame(frame, context.unit);
  if (shape.deformation) return deforming(context, path, shape, world);
  if (world.times.length === 0) return fixed(shape.mesh, world.matrixAt(context.startCode));
  const times = refined(context, path, world, boxCorners(shape.mesh.positions));
  const parts = Array.from(times, (t) => mat4.decomposeRigid(world.matrixAt(t)));
  const { stretch } = parts[0];
  const size = Math.max(...stretch.map(Math.abs));
  const rigid = parts.every((p) => p.stretch.every((x, i) => Math.abs(x - stretch[i]) <= RIGID * size));
  if (!rigid) return sampledPoints(context, shape, world, times);
  return {
    mesh: stretched(shape.mesh, stretch),
    motion: sampledPoses(
      context,
      times,
      parts.map((p) => p.pose),
    ),
  };
}

/** The same without motion, at one time. */
export function placeStill(context: StageContext, shape: Shape, frame: Frame, time: number): Placed {
  const positions = shape.deformation?.positionsAt(time);
  const mesh = positions ? withPositions(shape.mesh, positions) : shape.mesh;
  return fixed(mesh, scaledFrame(frame, context.unit).matrixAt(time));
}

function fixed(mesh: Mesh, matrix: mat4.Mat4): Placed {
  const { pose, stretch } = mat4.decomposeRigid(matrix);
  return { mesh: stretched(mesh, stretch), motion: { kind: 'static', pose } };
}

function stretched(mesh: Mesh, stretch: readonly number[]): Mesh {
  const identity = stretch.every((x, i) => Math.abs(x - (i % 4 === 0 ? 1 : 0)) < 1e-12);
  return identity ? mesh : transformMesh(mesh, mat4.fromParts(stretch, [0, 0, 0]));
}

function refined(context: StageContext, path: string, world: Frame, corners: readonly Vec3[]): Float64Array {
  const size = Math.max(...corners.map((c) => Math.hypot(...mat4.transformVector(world.matrixAt(world.times[0]), c))));
  const tolerance = context.chordTolerance * size;
  const { times, error } = refineTimes(world.times, world.matrixAt, corners, tolerance);
  if (error > tolerance) {
    const message = `it jumps or turns too fast between samples to be followed: paths are off by up to ${error.toPrecision(2)} m; write more samples`;
    report(context, 'warning', 'usd.resampling', path, message);
  }
  return times;
}

/** Poses as one motion, static where they are all the same. The signs of neighbouring quaternions agree. */
export function sampledPoses(
  context: Pick<StageContext, 'codesPerSecond'>,
  times: Float64Array,
  poses: readonly mat4.RigidPose[],
): StaticMotion | SampledMotion {
  const out = new Float64Array(times.length * 7);
  poses.forEach(({ position, orientation }, i) => {
    out.set(position, 7 * i);
    let cosine = 0;
    for (let k = 0; k < 4; k++) cosine += orientation[k] * (i > 0 ? out[7 * i - 4 + k] : orientation[k]);
    out.set(cosine < 0 ? orientation.map((x) => -x) : orientation, 7 * i + 3);
  });
  const moves = out.some((x, i) => x !== out[i % 7]);
  if (!moves || times.length < 2) return { kind: 'static', pose: poses[0] };
  return { kind: 'sampled', times: times.map((t) => t / context.codesPerSecond), poses: out };
}

function deforming(context: StageContext, path: string, shape: Shape, world: Frame): Placed {
  const { times } = shape.deformation!;
  if (world.times.length === 0) return sampledPoints(context, shape, world, times);
  const corners = boxCorners(shape.mesh.positions);
  const both = { times: unionOfTimes([times, world.times]), matrixAt: world.matrixAt };
  return sampledPoints(context, shape, world, refined(context, path, both, corners));
}

/** Every vertex at every time. */
function sampledPoints(context: StageContext, shape: Shape, world: Frame, times: Float64Array): Placed {
  const local = (time: number): Mesh => {
    const { mesh, deformation } = shape;
    if (!deformation) return mesh;
    const positions = deformation.positionsAt(time);
    const normals = deformation.normalsAt?.(time);
    return normals ? { ...mesh, positions, normals } : withPositions(mesh, positions);
  };
  const samples = Array.from(times, local);
  const origin = originOf(samples, times, world);
  const fromOrigin: mat4.Mat4 = [1, 0, 0, -origin[0], 0, 1, 0, -origin[1], 0, 0, 1, -origin[2], 0, 0, 0, 1];
  const placed = samples.map((mesh, i) => transformMesh(mesh, mat4.multiply(fromOrigin, world.matrixAt(times[i]))));
  const motion: SampledPointsMotion = {
    kind: 'sampled-points',
    times: times.map((t) => t / context.codesPerSecond),
    origin,
    points: placed.map((m) => m.positions),
    normals: placed.map((m) => m.normals),
  };
  return { mesh: placed[0], motion };
}

function withPositions(mesh: Mesh, positions: Float32Array): Mesh {
  return { ...mesh, positions, normals: deformedNormals(positions, mesh.indices, smoothingGroups(mesh)) };
}

/** The prim's own origin where it is near (so that its points stay as written), else the middle of all points. */
function originOf(samples: readonly Mesh[], times: Float64Array, world: Frame): Vec3 {
  const corners = samples.flatMap((mesh, i) => {
    const m = world.matrixAt(times[i]);
    return boxCorners(mesh.positions).flatMap((c) => mat4.transformPoint(m, c));
  });
  const box = boxCorners(corners);
  const [low, high] = [box[0], box[box.length - 1]];
  const middle: Vec3 = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2];
  const own = mat4.transformPoint(world.matrixAt(times[0]), [0, 0, 0]);
  return distance(own, middle) <= distance(low, high) ? own : middle;
}
