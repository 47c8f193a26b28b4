import { IDENTITY, invert, type Mat3, multiply, transform, transpose } from '../../math/mat3.ts';
import { linearPart } from '../../math/mat4.ts';
import { type Quat, toMatrix } from '../../math/quat.ts';
import { sub, type Vec3 } from '../../math/vec3.ts';
import { quadricOf } from '../../scene/mesh/quadric.ts';
import type { QuadricShape, SceneObject } from '../../scene/types.ts';

/**
 * The round solid of a body in its batch's coordinates: a point p of a triangle is at y = `toSolid` p + `place` in the solid's axes. There its surface is at
 * a distance from the part of the z axis within ± `reach` (nothing of it for a sphere, all of it for a cylinder or a cone) that is linear within each triangle.
 */
export interface BatchSolid {
  /** Row-major, as its inverse. */
  readonly toSolid: Mat3;
  readonly fromSolid: Mat3;
  readonly place: Vec3;
  readonly reach: number;
}

/** Stands for infinity in f32, too. */
const WHOLE_AXIS = 1e30;

function reachOf(shape: QuadricShape): number {
  switch (shape.kind) {
    case 'sphere':
      return 0;
    case 'capsule':
      return shape.height / 2;
    case 'cylinder':
    case 'cone':
      return WHOLE_AXIS;
  }
}

/** `center`: the mesh's point that the batch's offsets are relative to; `orientation`: by which they are rotated, if at all. */
export function batchSolidOf(object: SceneObject, center: Vec3, orientation: Quat | undefined): BatchSolid | undefined {
  const quadric = quadricOf(object);
  const linear = quadric && linearPart(quadric.toMesh);
  const inverse = linear && invert(linear);
  if (!quadric || !inverse) return undefined;
  const turn = orientation ? toMatrix(orientation) : IDENTITY;
  const { shape, toMesh } = quadric;
  return {
    toSolid: multiply(inverse, transpose(turn)),
    fromSolid: multiply(turn, linear),
    place: transform(inverse, sub(center, [toMesh[3], toMesh[7], toMesh[11]])),
    reach: reachOf(shape),
  };
}

/** Points of a triangle of a batch; on the surface of its body's round solid, if that is one. */
export class TrianglePoints {
  /** The last point [m]. */
  x = 0;
  y = 0;
  z = 0;
  private readonly positions: Float32Array;
  private readonly solid: BatchSolid | undefined;
  private readonly corners = new Float64Array(9);
  /** Of the corners in the solid's axes: their distances from the axis. */
  private readonly distances = new Float64Array(3);
  /** From the axis to the last point of `fromAxis`, in the solid's axes. */
  private readonly out = new Float64Array(3);

  constructor(positions: Float32Array, solid: BatchSolid | undefined) {
    this.positions = positions;
    this.solid = solid;
  }

  get isRound(): boolean {
    return this.solid !== undefined;
  }

  /** Selects a triangle by the indices of its vertices. */
  select(a: number, b: number, c: number): void {
    const { corners, positions } = this;
    for (let k = 0; k < 3; k++) {
      corners[k] = positions[3 * a + k];
      corners[3 + k] = positions[3 * b + k];
      corners[6 + k] = positions[3 * c + k];
    }
    if (!this.solid) return;
    for (let i = 0; i < 3; i++)
      this.distances[i] = this.fromAxis(this.solid, corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]);
  }

  /** Sets x, y and z to the point with these weights of the second and third corner. The shaders' twin is in triangleTable.ts. */
  set(w1: number, w2: number): void {
    const p = this.corners;
    const w0 = 1 - w1 - w2;
    this.x = w0 * p[0] + w1 * p[3] + w2 * p[6];
    this.y = w0 * p[1] + w1 * p[4] + w2 * p[7];
    this.z = w0 * p[2] + w1 * p[5] + w2 * p[8];
    if (!this.solid) return;
    const { distances, out } = this;
    const distance = this.fromAxis(this.solid, this.x, this.y, this.z);
    const wanted = w0 * distances[0] + w1 * distances[1] + w2 * distances[2];
    const factor = distance > 0 ? (wanted - distance) / distance : 0;
    const m = this.solid.fromSolid;
    this.x += factor * (m[0] * out[0] + m[1] * out[1] + m[2] * out[2]);
    this.y += factor * (m[3] * out[0] + m[4] * out[1] + m[5] * out[2]);
    this.z += factor * (m[6] * out[0] + m[7] * out[1] + m[8] * out[2]);
  }

  /** How far the surface is at most from the selected triangle's edges and its middle [m]. */
  bulge(): number {
    let square = 0;
    const p = this.corners;
    for (const [w1, w2] of PROBES) {
      this.set(w1, w2);
      const w0 = 1 - w1 - w2;
      const dx = this.x - (w0 * p[0] + w1 * p[3] + w2 * p[6]);
      const dy = this.y - (w0 * p[1] + w1 * p[4] + w2 * p[7]);
      const dz = this.z - (w0 * p[2] + w1 * p[5] + w2 * p[8]);
      square = Math.max(square, dx * dx + dy * dy + dz * dz);
    }
    return Math.sqrt(square);
  }

  /** Writes the vector from the axis to a point, in the solid's axes, to `out`, and returns its length. */
  private fromAxis({ toSolid: m, place, reach }: BatchSolid, x: number, y: number, z: number): number {
    const { out } = this;
    out[0] = m[0] * x + m[1] * y + m[2] * z + place[0];
    out[1] = m[3] * x + m[4] * y + m[5] * z + place[1];
    const along = m[6] * x + m[7] * y + m[8] * z + place[2];
    out[2] = along - Math.min(reach, Math.max(-reach, along));
    return Math.sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
  }
}

/** Weights of the second and third corner in the middles of the edges and of the triangle. */
const PROBES = [
  [0.5, 0],
  [0.5, 0.5],
  [0, 0.5],
  [1 / 3, 1 / 3],
] as const;
