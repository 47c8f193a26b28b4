import { clamp, dot, If, int, length, max, select, vec3 } from 'three/tsl';
import type { WebGPURenderer } from 'three/webgpu';
import { deforms } from '../../../scene/motion/motion.ts';
import type { Bool, Float, Int, Vec3, Vec4 } from '../../../shaders/types.ts';
import type { Batch, BatchArrays } from '../../geometry/batches.ts';
import type { BatchSolid } from '../../geometry/batchSolids.ts';
import { instanceOf, type VertexInput } from '../../geometry/vertexInput.ts';
import { FloatTable } from '../../gpu/floatTable.ts';

/** Indices are stored as f32, which is exact up to this. */
const MAX_TEXELS = 2 ** 24;
/** Most texels of vertices that are kept without need: 16 MiB. */
const MAX_UNNEEDED_TEXELS = 2 ** 20;
/** Per triangle: (first texels of its corners, in the order of their positions), (object id − 1, material, that order, solid); solid: 0, or 1 + its first texel. */
const TRIANGLE_TEXELS = 2;
/** Of a round solid (batchSolids.ts), among the vertices: the rows of its map with its place, and of the inverse, the first with its reach. */
const SOLID_TEXELS = 6;

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
  private readonly renderer: WebGPURenderer;
  private readonly triangles = new FloatTable(4096);
  private readonly vertices = new FloatTable(4096);
  private readonly firstTriangles = new Map<Batch, number>();
  private triangleCount = 0;
  private vertexTexels = 0;

  constructor(renderer: WebGPURenderer) {
    this.renderer = renderer;
  }

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
    const { renderer, triangleCount: first, vertexTexels: firstTexel } = this;
    this.firstTriangles.set(batch, first);
    this.addTriangles(batch, this.addSolids(batch.solids ?? new Map()));
    this.addVertices(batch);
    this.triangles.uploadTexels(renderer, TRIANGLE_TEXELS * first, TRIANGLE_TEXELS * (triangles - first));
    this.vertices.uploadTexels(renderer, firstTexel, texels - firstTexel);
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
    const body = instances && instanceOf(instances, instance);
    const offset = deforming ? vec3(0) : blend((k) => firstTexels[k].xyz).toVar();
    if (!deforming)
      this.ontoSolid(
        tail.w,
        offset,
        orderedWeights,
        firstTexels.map((texel) => texel.xyz),
      );
    return {
      offset: body ? body.offset(offset) : offset,
      get normal() {
        const normal = blend((k) => texel(k, 1).xyz);
        return body ? body.normal(normal) : normal;
      },
      get uv() {
        return blend((k) => vec3(firstTexels[k].w, texel(k, 1).w, 0)).xy;
      },
      get color() {
        return colored ? blend((k) => texel(k, 2).xyz) : undefined;
      },
      object: body?.object ?? tail.x,
      material: body?.material ?? tail.y,
      ofVertices: (read) => blend((k) => read(int(firstTexels[k].x))),
    };
  }

  /** See `ProjectedBody`. */
  isRound(triangle: Int): Bool {
    const tail = this.triangles.texel(triangle.mul(int(TRIANGLE_TEXELS)).add(int(1)));
    return tail.w.greaterThan(0.5).toVar();
  }

  /** Moves a point of a triangle onto the surface of its round solid, if it has one; corners stay where they are. See `TrianglePoints` (batchSolids.ts). */
  private ontoSolid(solid: Float, point: Vec3, weights: Vec3, corners: readonly Vec3[]): void {
    const isCorner = max(weights.x, max(weights.y, weights.z)).greaterThanEqual(1);
    If(solid.greaterThan(0.5).and(isCorner.not()), () => {
      const texel = (k: number): Vec4 => this.vertices.texel(int(solid).add(int(k - 1))).toVar();
      const rows = [texel(0), texel(1), texel(2)];
      const [first, second, third] = [texel(3), texel(4), texel(5)];
      const fromAxis = (p: Vec3): Vec3 => {
        const [x, y, z] = rows.map((row) => dot(row.xyz, p).add(row.w).toVar());
        return vec3(x, y, z.sub(clamp(z, first.w.negate(), first.w))).toVar();
      };
      const out = fromAxis(point);
      const distance = length(out).toVar();
      const [a, b, c] = corners.map((corner) => length(fromAxis(corner)));
      const wanted = a.mul(weights.x).add(b.mul(weights.y)).add(c.mul(weights.z));
      const moved = out.mul(wanted.sub(distance).div(max(distance, 1e-30))).toVar();
      point.addAssign(vec3(dot(first.xyz, moved), dot(second.xyz, moved), dot(third.xyz, moved)));
    });
  }

  dispose(): void {
    this.triangles.dispose();
    this.vertices.dispose();
  }

  /** Returns the first texel of each body's solid. */
  private addSolids(solids: ReadonlyMap<number, BatchSolid>): ReadonlyMap<number, number> {
    const places = new Map<number, number>();
    this.vertices.reserve(this.vertexTexels + SOLID_TEXELS * solids.size);
    for (const [body, { toSolid: m, fromSolid: n, place, reach }] of solids) {
      places.set(body, this.vertexTexels);
      const rows = [0, 3, 6].map((i) => [m[i], m[i + 1], m[i + 2], place[i / 3]]);
      const inverse = [0, 3, 6].map((i) => [n[i], n[i + 1], n[i + 2], i === 0 ? reach : 0]);
      this.vertices.values.set([...rows, ...inverse].flat(), 4 * this.vertexTexels);
      this.vertexTexels += SOLID_TEXELS;
    }
    return places;
  }

  private addTriangles({ arrays, bodies, instancing }: Batch, solids: ReadonlyMap<number, number>): void {
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
      const solid = solids.get(instancing ? bodies[0].id : ids[2 * indices[i]] + 1);
      out[at + 7] = solid === undefined ? 0 : 1 + solid;
    }
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
  }
}

const texelsOf = ({ arrays, solids }: Batch): number =>
  SOLID_TEXELS * (solids?.size ?? 0) + texelsPerVertex(arrays) * (arrays.positions.length / 3);

const texelsPerVertex = ({ colors }: BatchArrays): number => (colors ? 3 : 2);

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
