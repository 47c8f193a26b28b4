import { clamp, cross, int, max, mix, vec4 } from 'three/tsl';
import type { Float, Int, SampleTable, Vec3, Vec4 } from '../../shaders/types.ts';
import { bisect } from '../../shaders/worldLines/bisect.ts';
import type { EndVelocities } from '../../shaders/worldLines/cubicPiece.ts';
import { pieceVelocity } from '../../shaders/worldLines/pieceVelocity.ts';
import type { FloatTable } from '../gpu/floatTable.ts';
import { type PointStore, unpackNormal } from './pointSamples/pointStore.ts';
import type { VertexInput } from './vertexInput.ts';

/** One vertex's samples, as objectTables.ts and pointStore.ts wrote them. */
export interface VertexSamples {
  readonly at: SampleTable;
  readonly count: Int;
  /** World-frame normal at a sample. */
  readonly normal: (index: Int) => Vec3;
  /** Velocities at the ends of a piece, if the vertex moves along cubics. */
  readonly velocities?: EndVelocities;
  /** Time of a sample after the anchor [m of light]. */
  readonly time: (index: Int) => Float;
}

/** A rigid body: two texels per sample, (place of the centre, time) and the orientation. */
export function poseSamples(table: FloatTable, first: Int, count: Int, offset: Vec3, normal: Vec3): VertexSamples {
  const texel = (index: Int): Int => first.add(index.mul(int(2)));
  const rotated = (index: Int, x: Vec3): Vec3 => rotateVector(table.texel(texel(index).add(int(1))).toVar(), x);
  return {
    count,
    at: (index) => {
      const pose = table.texel(texel(index)).toVar();
      return vec4(pose.xyz.add(rotated(index, offset)), pose.w);
    },
    normal: (index) => rotated(index, normal),
    time: (index) => table.texel(texel(index)).w,
  };
}

/** A deforming mesh: per sample a texel (sample, bend, 0, time), and its points; `motion` = (origin relative to the anchor, texels per sample). */
export function pointSamples(
  table: FloatTable,
  { table: points, velocities }: Pick<PointStore, 'table' | 'velocities'>,
  ofVertices: VertexInput['ofVertices'],
  { first, count, perC }: { readonly first: Int; readonly count: Int; readonly perC: Float },
  motion: Vec4,
): VertexSamples {
  const sampleTexel = (index: Int): Vec4 => table.texel(first.add(index)).toVar();
  const row = (sample: Float): Int => int(sample).mul(int(motion.w)).toVar();
  const at: SampleTable = (index) => {
    const { x: sample, w: time } = sampleTexel(index);
    const from = row(sample);
    return vec4(ofVertices((vertex) => points.texel(from.add(vertex)).xyz).add(motion.xyz), time);
  };
  return {
    count,
    at,
    ...(velocities && { velocities: endVelocities(at, velocities, sampleTexel, row, ofVertices, perC) }),
    normal: (index) => {
      const from = row(sampleTexel(index).x);
      return ofVertices((vertex) => unpackNormal(points.texel(from.add(vertex)).w));
    },
    time: (index) => sampleTexel(index).w,
  };
}

/** The velocities of the file, drawn towards the chord's by the bend factor of the piece (docs/physics.md §4.8). */
const endVelocities =
  (
    at: SampleTable,
    table: FloatTable,
    sampleTexel: (index: Int) => Vec4,
    row: (sample: Float) => Int,
    ofVertices: VertexInput['ofVertices'],
    perC: Float,
  ): EndVelocities =>
  (index) => {
    const next = index.add(int(1)).toVar();
    const chord = pieceVelocity(at(index).toVar(), at(next).toVar()).xyz.toVar();
    const bend = sampleTexel(index).y.toVar();
    const bentVelocity = (i: Int): Vec3 => {
      const from = row(sampleTexel(i).x);
      return mix(chord, ofVertices((vertex) => table.texel(from.add(vertex)).xyz).mul(perC), bend).toVar();
    };
    return { begin: bentVelocity(index), end: bentVelocity(next) };
  };

/** The piece that contains the time `s`, and the fraction of it that has passed. */
export function pieceAt(samples: Pick<VertexSamples, 'count' | 'time'>, s: Float): { index: Int; fraction: Float } {
  const index = bisect(samples.count, (i) => samples.time(i).lessThanEqual(s));
  const begin = samples.time(index).toVar();
  const length = max(samples.time(index.add(int(1))).sub(begin), 1e-30);
  return { index, fraction: clamp(s.sub(begin).div(length), 0, 1) };
}

/** q x q⁻¹ */
export const rotateVector = (q: Vec4, x: Vec3): Vec3 => x.add(cross(q.xyz, cross(q.xyz, x).add(x.mul(q.w))).mul(2));
