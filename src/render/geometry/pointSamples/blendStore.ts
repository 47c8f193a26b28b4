import { boundingBox } from '../../../scene/bounds/bounds.ts';
import { type BlendedPoints, jointMatrices, MATRIX, shapeWeightsAt } from '../../../scene/streaming/blendedPoints.ts';
import { FloatTable } from '../../gpu/floatTable.ts';
import { packNormal } from '../../gpu/packNormal.ts';

/** Texels of a vertex: (place from the centre of the rest shape, packed normal), (first influence, number of influences, 0, 0). */
export const BLENDED_TEXELS = 2;
/** Texels of a joint in a sample: the rows of its matrix. */
export const JOINT_TEXELS = 3;
/** Texels of a vertex in a blend shape: displacements of its place and of its normal. */
export const SHAPE_TEXELS = 2;
/** Most texels of the samples that all bodies of a picture take together: 64 MiB. */
const MAX_FRAME_TEXELS = 2 ** 22;

/**
 * The rest shape of a skin on the GPU, with its influences, (joint, weight, 0, 0) each, and its blend shapes. The joints' matrices of the samples that a frame
 * needs are in its sample table: per sample first the blend shapes that have a weight, (index, weight, 0, 0), then the joints.
 */
export class BlendStore {
  readonly table = new FloatTable(4096);
  readonly vertices: number;
  /** First texel of the blend shapes. */
  readonly firstShape: number;
  readonly hasShapes: boolean;
  private readonly points: BlendedPoints;
  /** Centre of the rest shape, so that f32 never holds a large number [m]. */
  private readonly center: readonly number[];
  private readonly matrices: Float64Array;

  constructor(points: BlendedPoints) {
    const { first, influences, shapes, rest, joints } = points;
    this.points = points;
    this.vertices = first.length - 1;
    this.hasShapes = shapes.length > 0;
    this.firstShape = BLENDED_TEXELS * this.vertices + influences.length;
    this.matrices = new Float64Array(MATRIX * joints.length);
    const box = boundingBox(rest.positions);
    this.center = box ? box.min.map((x, i) => (x + box.max[i]) / 2) : [0, 0, 0];
    this.table.reserve(this.firstShape + SHAPE_TEXELS * shapes.length * this.vertices);
    this.fillVertices();
    shapes.forEach((shape, s) => {
      const out = this.table.values;
      for (let v = 0; v < this.vertices; v++) {
        const at = 4 * (this.firstShape + SHAPE_TEXELS * (s * this.vertices + v));
        for (let k = 0; k < 3; k++) {
          out[at + k] = shape.positions[3 * v + k];
          out[at + 4 + k] = shape.normals[3 * v + k];
        }
      }
    });
    this.table.upload();
  }

  private fillVertices(): void {
    const { first, influences, weights, rest } = this.points;
    const { positions: p, normals: n } = rest;
    const out = this.table.values;
    const firstInfluence = BLENDED_TEXELS * this.vertices;
    for (let v = 0; v < this.vertices; v++) {
      const at = 4 * BLENDED_TEXELS * v;
      for (let k = 0; k < 3; k++) out[at + k] = p[3 * v + k] - this.center[k];
      out[at + 3] = packNormal(n[3 * v], n[3 * v + 1], n[3 * v + 2]);
      out[at + 4] = firstInfluence + first[v];
      out[at + 5] = first[v + 1] - first[v];
    }
    for (let i = 0; i < influences.length; i++) {
      out[4 * (firstInfluence + i)] = influences[i];
      out[4 * (firstInfluence + i) + 1] = weights[i];
    }
  }

  /** Texels that a sample takes at most. */
  private get sampleTexels(): number {
    return JOINT_TEXELS * this.points.joints.length + this.points.shapes.length;
  }

  /** Most samples that a picture with so many deforming bodies may need of it. */
  capacity(bodies: number): number {
    return Math.max(2, Math.floor(MAX_FRAME_TEXELS / bodies / (1 + this.sampleTexels)));
  }

  /** Writes sample k to a table from a texel on; returns the number of blend shapes and the next texel. */
  writeSample(k: number, table: FloatTable, texel: number): { readonly shapes: number; readonly next: number } {
    table.reserve(texel + this.sampleTexels);
    const out = table.values;
    let at = 4 * texel;
    let shapes = 0;
    shapeWeightsAt(this.points, k).forEach((weight, s) => {
      if (weight === 0) return;
      out.set([s, weight, 0, 0], at);
      at += 4;
      shapes++;
    });
    const m = jointMatrices(this.points, k, this.matrices);
    const [x, y, z] = this.center;
    for (let i = 0; i < m.length; i += 4, at += 4) {
      out[at] = m[i];
      out[at + 1] = m[i + 1];
      out[at + 2] = m[i + 2];
      out[at + 3] = m[i] * x + m[i + 1] * y + m[i + 2] * z + m[i + 3];
    }
    return { shapes, next: at / 4 };
  }

  /** Frees its memory on the GPU until it is next read. */
  release(): void {
    this.table.dispose();
  }

  dispose(): void {
    this.table.dispose();
  }
}
