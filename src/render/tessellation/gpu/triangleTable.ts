import { int, select, vec3 } from 'three/tsl';
import { deforms } from '../../../scene/motion/motion.ts';
import type { Float, Int, Vec3, Vec4 } from '../../../shaders/types.ts';
import type { Batch, BatchArrays } from '../../geometry/batches.ts';
import { unpackNormal } from '../../geometry/pointSamples/pointStore.ts';
import { instanceRecord, type PointReader, type VertexInput } from '../../geometry/vertexInput.ts';
import { FloatTable } from '../../gpu/floatTable.ts';

/** Indices are stored as f32, which is exact up to this. */
const MAX_TEXELS = 2 ** 24;
/** Most texels of vertices that are kept without need: 16 MiB. */
const MAX_UNNEEDED_TEXELS = 2 ** 20;
/** Per triangle: (first texels of its corners, in the order of their positions), (object id − 1, material, that order, 0). */
const TRIANGLE_TEXELS = 2;

/** How the triangles of a batch are read; `instances`: of batches with instancing. */
export interface TriangleSources {
  readonly kind: Batch['kind'];
  readonly colored: boolean;
  readonly instances?: FloatTable | undefined;
}

/**
 * Vertex data of triangles that are drawn as patches, for shaders that know a triangle and weights. Two texels per vertex, or three: (offset, u), (normal,
 * v), (colour, 0); of a deforming mesh the first is (vertex, 0, 0, u).
 */
export class TriangleTable {
  private readonly triangles = new FloatTable(4096);
  private readonly vertices = new FloatTable(4096);
  private readonly firstTriangles = new Map<Batch, number>();
  private triangleCount = 0;
  private vertexTexels = 0;

  /** Forgets all batches if those that are not needed have many texels; the others are added again when they are used. */
  trim(isNeeded: (batch: Batch) => boolean): void {
    let texels = 0;
    for (const batch of this.firstTriangles.keys()) if (!isNeeded(batch)) texels += texelsOf(batch);
    if (texels <= MAX_UNNEEDED_TEXELS) return;
    this.firstTriangles.clear();
    this.triangleCount = 0;
    this.vertexTexels = 0;
  }

  /** Index of a batch's first triangle, added on first use; undefined if there is no room left. */
  firstTriangle(batch: Batch): number | undefined {
    const cached = this.firstTriangles.get(batch);
    if (cached !== undefined) return cached;
    const triangles = this.triangleCount + batch.arrays.indices.length / 3;
    const texels = this.vertexTexels + texelsOf(batch);
    if (TRIANGLE_TEXELS * triangles > MAX_TEXELS || texels > MAX_TEXELS) return undefined;
    const first = this.triangleCount;
    this.firstTriangles.set(batch, first);
    this.addTriangles(batch.arrays);
    this.addVertices(batch);
    return first;
  }

  /**
   * The point of a triangle with these weights of its corners, of an instance if there are any. It is summed in the order of the corners' positions, with one
   * product each, and zeros for corners with zero weight: so triangles that share an edge get the same bits, even with their own copies of its vertices.
   */
  interpolate(
    triangle: Int,
    weights: Vec3,
    { kind, colored, instances }: TriangleSources,
    instance: Float,
  ): VertexInput {
    const at = triangle.mul(int(TRIANGLE_TEXELS)).toVar();
    const head = this.triangles.texel(at).toVar();
    const tail = this.triangles.texel(at.add(int(1))).toVar();
    const cornerTexels = [head.x, head.y, head.z].map((x) => int(x).toVar());
    const orderedWeights = inPositionOrder(weights, int(tail.z).toVar()).toVar();
    const blend = (corner: (k: number) => Vec3): Vec3 =>
      corner(0).mul(orderedWeights.x).add(corner(1).mul(orderedWeights.y)).add(corner(2).mul(orderedWeights.z));
    const texel = (k: number, part: number): Vec4 => this.vertices.texel(cornerTexels[k].add(int(part)));
    const firstTexels = cornerTexels.map((_, k) => texel(k, 0).toVar());
    const deforming = deforms({ kind });
    const ids = instances ? instanceRecord(instances, instance) : tail;
    return {
      offset: deforming ? vec3(0) : blend((k) => firstTexels[k].xyz).toVar(),
      get normal() {
        return blend((k) => texel(k, 1).xyz);
      },
      get uv() {
        return blend((k) => vec3(firstTexels[k].w, texel(k, 1).w, 0)).xy;
      },
      get color() {
        return colored ? blend((k) => texel(k, 2).xyz) : undefined;
      },
      object: ids.x,
      material: ids.y,
      sampled: interpolatedPoints(blend, (k) => int(firstTexels[k].x)),
    };
  }

  dispose(): void {
    this.triangles.dispose();
    this.vertices.dispose();
  }

  private addTriangles(arrays: BatchArrays): void {
    const { indices, ids } = arrays;
    const size = texelsPerVertex(arrays);
    this.triangles.reserve(TRIANGLE_TEXELS * (this.triangleCount + indices.length / 3));
    const out = this.triangles.values;
    for (let i = 0; i < indices.length; i += 3) {
      const order = positionOrder(arrays, i);
      const at = 4 * TRIANGLE_TEXELS * this.triangleCount++;
      for (let k = 0; k < 3; k++) out[at + k] = this.vertexTexels + size * indices[i + order[k]];
      out[at + 4] = ids[2 * indices[i]];
      out[at + 5] = ids[2 * indices[i] + 1];
      out[at + 6] = order[0] + 4 * order[1] + 16 * order[2];
    }
    this.triangles.upload();
  }

  private addVertices({ kind, arrays }: Batch): void {
    const { positions, normals, uvs, colors } = arrays;
    const size = texelsPerVertex(arrays);
    const count = positions.length / 3;
    this.vertices.reserve(this.vertexTexels + size * count);
    const out = this.vertices.values;
    for (let v = 0; v < count; v++) {
      const at = 4 * (this.vertexTexels + size * v);
      for (let k = 0; k < 3; k++) {
        out[at + k] = positions[3 * v + k];
        out[at + 4 + k] = normals[3 * v + k];
        if (colors) out[at + 8 + k] = colors[3 * v + k];
      }
      if (deforms({ kind })) out.set([v, 0, 0], at);
      out[at + 3] = uvs[2 * v];
      out[at + 7] = uvs[2 * v + 1];
    }
    this.vertexTexels += size * count;
    this.vertices.upload();
  }
}

const texelsOf = ({ arrays }: Batch): number => texelsPerVertex(arrays) * (arrays.positions.length / 3);

const texelsPerVertex = ({ colors }: BatchArrays): number => (colors ? 3 : 2);

const interpolatedPoints = (blend: (corner: (k: number) => Vec3) => Vec3, vertex: (k: number) => Int): PointReader => ({
  place: (points, first) => blend((k) => points.texel(first.add(vertex(k))).xyz),
  normal: (points, first) => blend((k) => unpackNormal(points.texel(first.add(vertex(k))).w)),
});

/** The triangle's corners in the order of their positions. */
function positionOrder({ indices, positions }: BatchArrays, i: number): number[] {
  const compare = (a: number, b: number): number => {
    const [p, q] = [3 * indices[i + a], 3 * indices[i + b]];
    for (let k = 0; k < 3; k++) if (positions[p + k] !== positions[q + k]) return positions[p + k] - positions[q + k];
    return p - q;
  };
  return [0, 1, 2].sort(compare);
}

/** Weights in the order that `positionOrder` returned, two bits each. */
function inPositionOrder(weights: Vec3, order: Int): Vec3 {
  const pick = (k: number): Float => {
    const corner = order.shiftRight(int(2 * k)).bitAnd(int(3));
    return select(corner.equal(int(0)), weights.x, select(corner.equal(int(1)), weights.y, weights.z));
  };
  return vec3(pick(0), pick(1), pick(2));
}
