import { cross, dot, int, Loop, max, select, sqrt, vec3, vec4 } from 'three/tsl';
import type { Float, Int, Vec3, Vec4 } from '../../shaders/types.ts';
import type { FloatTable } from '../gpu/floatTable.ts';
import { BLENDED_TEXELS, type BlendStore, JOINT_TEXELS, SHAPE_TEXELS } from './pointSamples/blendStore.ts';
import { unpackNormal } from './pointSamples/pointStore.ts';
import type { VertexInput } from './vertexInput.ts';
import type { VertexSamples } from './vertexSamples.ts';

/** The part of a store that shaders read; the same for all meshes with the same kinds of data, so that they share their shaders. */
export interface BlendSource extends Pick<BlendStore, 'table' | 'hasShapes'> {
  /** Number of vertices. */
  readonly vertices: Int;
  /** First texel of the blend shapes. */
  readonly firstShape: Int;
}

/** A sample in the table: its first texel, and its number of blend shapes. */
interface BlendSample {
  readonly row: Int;
  readonly shapes: Int;
}

/**
 * A skin: per sample a texel (first texel of its joints, number of blend shapes, 0, time); see `BlendStore`. Every vertex is evaluated at the samples that the
 * search for its event looks at, as scene/streaming/blendedPoints.ts does. `motion` = (origin relative to the anchor, …).
 */
export function blendedSamples(
  table: FloatTable,
  source: BlendSource,
  ofVertices: VertexInput['ofVertices'],
  { first, count }: { readonly first: Int; readonly count: Int },
  motion: Vec4,
): VertexSamples {
  const sampleTexel = (index: Int): Vec4 => table.texel(first.add(index)).toVar();
  const sampleOf = (texel: Vec4): BlendSample => ({ row: int(texel.x).toVar(), shapes: int(texel.y).toVar() });
  return {
    count,
    at: (index) => {
      const texel = sampleTexel(index);
      const sample = sampleOf(texel);
      return vec4(ofVertices((vertex) => placeOf(table, source, sample, vertex)).add(motion.xyz), texel.w);
    },
    normal: (index) => {
      const sample = sampleOf(sampleTexel(index));
      return ofVertices((vertex) => normalOf(table, source, sample, vertex));
    },
    time: (index) => sampleTexel(index).w,
  };
}

function placeOf(table: FloatTable, source: BlendSource, sample: BlendSample, vertex: Int): Vec3 {
  const p = vec4(vertexTexel(source, vertex, 0).xyz, 1).toVar();
  addShapes(table, source, sample, vertex, 0, (displacement) => p.xyz.addAssign(displacement));
  const x = vec3(0).toVar();
  eachJoint(table, source, sample, vertex, (row, weight) => {
    x.addAssign(vec3(dot(row(0), p), dot(row(1), p), dot(row(2), p)).mul(weight));
  });
  return x;
}

/** As `makeBlendedNormals`. */
function normalOf(table: FloatTable, source: BlendSource, sample: BlendSample, vertex: Int): Vec3 {
  const n = unpackNormal(vertexTexel(source, vertex, 0).w).toVar();
  addShapes(table, source, sample, vertex, 1, (displacement) => n.addAssign(displacement));
  const rows = [vec3(0).toVar(), vec3(0).toVar(), vec3(0).toVar()];
  eachJoint(table, source, sample, vertex, (row, weight) => {
    for (const [k, sum] of rows.entries()) sum.addAssign(row(k).xyz.mul(weight));
  });
  const [a, b, c] = rows;
  const first = cross(b, c).toVar();
  const turned = vec3(dot(first, n), dot(cross(c, a), n), dot(cross(a, b), n)).toVar();
  const length = sqrt(dot(turned, turned)).toVar();
  const sign = select(dot(a, first).lessThan(0), -1, 1);
  return select(length.greaterThan(0), turned.mul(sign).div(max(length, 1e-30)), vec3(0, 0, 1)).toVar();
}

const vertexTexel = ({ table }: BlendSource, vertex: Int, part: number): Vec4 =>
  table.texel(vertex.mul(int(BLENDED_TEXELS)).add(int(part))).toVar();

/** Adds the displacements of a vertex by the blend shapes of a sample; part 0: of its place, 1: of its normal. */
function addShapes(
  table: FloatTable,
  { table: rest, hasShapes, firstShape, vertices }: BlendSource,
  { row, shapes }: BlendSample,
  vertex: Int,
  part: number,
  add: (displacement: Vec3) => void,
): void {
  if (!hasShapes) return;
  Loop({ start: int(0), end: shapes, type: 'int', condition: '<' }, ({ i: shape }) => {
    const weight = table.texel(row.add(shape)).toVar();
    const at = firstShape.add(int(weight.x).mul(vertices).add(vertex).mul(int(SHAPE_TEXELS))).add(int(part));
    add(rest.texel(at).xyz.mul(weight.y));
  });
}

/** Calls `visit` for the joints of a vertex in a shader's loop, with the rows of a joint's matrix and the weight. */
function eachJoint(
  table: FloatTable,
  source: BlendSource,
  { row, shapes }: BlendSample,
  vertex: Int,
  visit: (row: (k: number) => Vec4, weight: Float) => void,
): void {
  const range = vertexTexel(source, vertex, 1);
  const joints = row.add(shapes).toVar();
  const first = int(range.x).toVar();
  Loop({ start: int(0), end: int(range.y), type: 'int', condition: '<' }, ({ i: influence }) => {
    const texel = source.table.texel(first.add(influence)).toVar();
    const matrix = joints.add(int(texel.x).mul(int(JOINT_TEXELS))).toVar();
    visit((k) => table.texel(matrix.add(int(k))).toVar(), texel.y);
  });
}
