import { radians } from '../../../../math/angle.ts';
import * as mat4 from '../../../../math/mat4.ts';
import { conjugate, fromAxisAngle, IDENTITY, multiply, type Quat, slerp, toMatrix } from '../../../../math/quat.ts';
import { add, addScaled, length, sub, type Vec3 } from '../../../../math/vec3.ts';
import { attributeOf } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import { unionOfTimes } from '../transforms/xformOps.ts';
import { ArrayTrack } from './arrayTrack.ts';

/** An instance's transform relative to its instancer: scale, then rotation, then translation. */
export interface InstanceTransform {
  readonly position: Vec3;
  readonly orientation: Quat;
  readonly scale: Vec3;
}

/** x_instancer = M x_prototype */
export function matrixOf({ position, orientation, scale }: InstanceTransform): mat4.Mat4 {
  return mat4.fromParts(
    toMatrix(orientation).map((x, i) => x * scale[i % 3]),
    position,
  );
}

/**
 * The arrays of a PointInstancer as transforms. If velocities or angular velocities have the same samples as the values
 * that they change, the last sample is extrapolated; otherwise samples are interpolated. As
 * UsdGeomPointInstancer::ComputeInstanceTransformsAtTime, but with unit quaternions.
 */
export class InstanceTransforms {
  /** Time codes of the samples of all arrays that change. */
  readonly times: Float64Array;
  private readonly positions: ArrayTrack;
  private readonly orientations: ArrayTrack;
  private readonly scales: ArrayTrack;
  private readonly velocities: ArrayTrack;
  private readonly angularVelocities: ArrayTrack;
  private readonly accelerations: ArrayTrack;
  private readonly codesPerSecond: number;

  constructor(prim: PrimSpec, codesPerSecond: number) {
    const track = (name: string, width: number) => new ArrayTrack(attributeOf(prim, name), width);
    const precise = attributeOf(prim, 'orientationsf');
    const isPrecise = precise?.value !== undefined || precise?.timeSamples !== undefined;
    this.codesPerSecond = codesPerSecond;
    this.positions = track('positions', 3);
    this.orientations = track(isPrecise ? 'orientationsf' : 'orientations', 4);
    this.scales = track('scales', 3);
    this.velocities = track('velocities', 3);
    this.angularVelocities = track('angularVelocities', 3);
    this.accelerations = track('accelerations', 3);
    const placed = [this.positions, this.orientations, this.scales].map(({ times }) => times);
    this.times = unionOfTimes(placed.filter((times) => times.length > 1));
  }

  /** Arrays that do not have `count` elements at a time, with their counts; only positions must exist, others may be empty. */
  sizeMismatches(count: number, time: number): [name: string, count: number][] {
    const { positions, orientations, scales } = this;
    const named = Object.entries({ positions, orientations, scales });
    return named.flatMap(([name, track]) => {
      const has = track.countAt(time) || (name === 'positions' ? 0 : count);
      return has === count ? [] : [[name, has]];
    });
  }

  /** Rotation and scale are constant, and positions linear between samples. */
  get isStraight(): boolean {
    const { orientations, scales, angularVelocities, accelerations } = this;
    const turns = orientations.times.length > 1 || scales.times.length > 1;
    return !turns && angularVelocities.times.length === 0 && accelerations.times.length === 0;
  }

  /** Whether samples are extrapolated by velocities at a time, for `count` instances. */
  isExtrapolated(count: number, time: number): boolean {
    return this.moves(count, time) || this.rotates(count, time);
  }

  /** The velocity of an instance in the instancer's axes [units/s] if it is constant at all times; undefined otherwise. */
  constantVelocity(i: number, count: number): Vec3 | undefined {
    const { positions, orientations, scales } = this;
    const [only] = positions.times;
    const changes = [positions, orientations, scales].some(({ times }) => times.length > 1);
    if (changes || only === undefined || !this.moves(count, only) || this.rotates(count, only)) return undefined;
    return this.accelerates(count, only) ? undefined : vec3(this.velocities.held(i, only));
  }

  /** The transform of instance i of `count` at `time`, by the samples held at `base`. */
  at(i: number, count: number, time: number, base = time): InstanceTransform {
    const { positions, orientations, scales } = this;
    const turnable = orientations.countAt(base) === count;
    const scalable = scales.countAt(base) === count;
    if (this.isExtrapolated(count, base))
      return {
        position: this.extrapolatedPosition(i, count, time, base),
        orientation: turnable ? this.extrapolatedOrientation(i, count, time, base) : IDENTITY,
        scale: scalable ? vec3(scales.held(i, base)) : ONE,
      };
    return {
      position: vec3(positions.blended(i, time)),
      orientation: turnable ? orientations.slerped(i, time) : IDENTITY,
      scale: scalable ? vec3(scales.blended(i, time)) : ONE,
    };
  }

  private extrapolatedPosition(i: number, count: number, time: number, base: number): Vec3 {
    const position = vec3(this.positions.held(i, base));
    if (!this.moves(count, base)) return position;
    const dt = (time - this.positions.around(base)[0]) / this.codesPerSecond;
    const moved = addScaled(position, vec3(this.velocities.held(i, base)), dt);
    if (!this.accelerates(count, base)) return moved;
    return addScaled(moved, vec3(this.accelerations.held(i, base)), (dt * dt) / 2);
  }

  /** Angular velocities are in degrees per second, about the instancer's axes. */
  private extrapolatedOrientation(i: number, count: number, time: number, base: number): Quat {
    const orientation = this.orientations.heldQuaternion(i, base);
    if (!this.rotates(count, base)) return orientation;
    const rate = vec3(this.angularVelocities.held(i, base));
    if (length(rate) === 0) return orientation;
    const dt = (time - this.orientations.around(base)[0]) / this.codesPerSecond;
    return multiply(fromAxisAngle(rate, radians(dt * length(rate))), orientation);
  }

  private moves(count: number, time: number): boolean {
    return areAligned(this.positions, this.velocities, count, time);
  }

  private rotates(count: number, time: number): boolean {
    return areAligned(this.orientations, this.angularVelocities, count, time);
  }

  private accelerates(count: number, time: number): boolean {
    return areAligned(this.velocities, this.accelerations, count, time);
  }
}

/** Whether both have the same samples around a time, with `count` elements. */
function areAligned(values: ArrayTrack, rates: ArrayTrack, count: number, time: number): boolean {
  if (values.times.length === 0 || rates.times.length === 0) return false;
  if (values.countAt(time) !== count || rates.countAt(time) !== count) return false;
  const [[a, b], [c, d]] = [values.around(time), rates.around(time)];
  return a === c && b === d;
}

const ONE: Vec3 = [1, 1, 1];
const vec3 = ([x, y, z]: readonly number[]): Vec3 => [x, y, z];

/** Corrects a transform by the fraction s of the difference from `wrong` to `right`. */
export function corrected(
  placing: InstanceTransform,
  wrong: InstanceTransform,
  right: InstanceTransform,
  s: number,
): InstanceTransform {
  const turn = multiply(right.orientation, conjugate(wrong.orientation));
  return {
    position: addScaled(placing.position, sub(right.position, wrong.position), s),
    orientation: multiply(slerp(IDENTITY, turn, s), placing.orientation),
    scale: add(placing.scale, [0, 1, 2].map((k) => s * (right.scale[k] - wrong.scale[k])) as unknown as Vec3),
  };
}
