import { cross } from '../../math/vec3.ts';
import { pointAt } from '../mesh/polygons.ts';
import { type LimitMatrices, limitMatrices, limitPositions } from './limit.ts';
import { type RefinementStep, refinementStep } from './masks.ts';
import { type SubdivisionScheme, splitsTriangles } from './scheme.ts';
import { multiplySparse, multiplySparseInto, rowCount, type SparseMatrix } from './sparseMatrix.ts';
import { splitIntoQuads, splitIntoTriangles } from './splitTopology.ts';
import type { SubdivisionTopology } from './topology.ts';

/** Weights that take values on a cage's points to the points of a refined mesh; built once, for any number of values. */
export interface Refinement {
  readonly topology: SubdivisionTopology;
  readonly scheme: SubdivisionScheme;
  readonly steps: readonly RefinementStep[];
}

/** `levels` ≥ 1; triangle schemes need an all-triangle cage. */
export function refineTopology(
  cage: SubdivisionTopology,
  scheme: SubdivisionScheme,
  levels: number,
  smoothTriangles = false,
): Refinement {
  let topology = cage;
  const steps: RefinementStep[] = [];
  for (let level = 0; level < levels; level++) {
    steps.push(refinementStep(topology, scheme, smoothTriangles));
    topology = splitsTriangles(scheme) ? splitIntoTriangles(topology) : splitIntoQuads(topology);
  }
  return { topology, scheme, steps };
}

/** The cage face that contains each refined face; `faceCounts`: of the cage. */
export function parentFaces({ topology, scheme, steps }: Refinement, faceCounts: ArrayLike<number>): Uint32Array {
  const parents = new Uint32Array(topology.faceStarts.length - 1);
  const each = 4 ** (steps.length - (splitsTriangles(scheme) ? 0 : 1));
  let at = 0;
  for (let face = 0; face < faceCounts.length; face++) {
    const children = (splitsTriangles(scheme) ? 1 : faceCounts[face]) * each;
    parents.fill(face, at, at + children);
    at += children;
  }
  return parents;
}

/** Values of `width` numbers on the refined points, before projection to the limit. */
function refinedValues({ steps }: Refinement, values: ArrayLike<number>, width: number): Float64Array {
  let now: Float64Array = Float64Array.from(values);
  for (const { middles, children } of steps) {
    const both = new Float64Array(now.length + rowCount(middles) * width);
    both.set(now);
    multiplySparseInto(middles, both, width, both, now.length / width);
    now = multiplySparse(children, both, width);
  }
  return now;
}

/** Limit values of `width` numbers on the refined points. */
export function limitValues(refinement: Refinement, values: ArrayLike<number>, width: number): Float64Array {
  const limit: SparseMatrix = limitPositions(refinement.topology, refinement.scheme);
  return multiplySparse(limit, refinedValues(refinement, values, width), width);
}

/** The limit surface: positions and normals of the refined mesh for given cage points. */
export class LimitSurface {
  readonly refinement: Refinement;
  private readonly limit: LimitMatrices;

  constructor(refinement: Refinement) {
    this.refinement = refinement;
    this.limit = limitMatrices(refinement.topology, refinement.scheme);
  }

  /** Corners of one slot share position and normal. */
  get slotOfCorner(): Uint32Array {
    return this.limit.slotOfCorner;
  }

  get slots(): number {
    return this.limit.pointOfSlot.length;
  }

  /** 3 numbers per slot from 3 per cage point; unit normals, outward for counter-clockwise faces. */
  at(points: ArrayLike<number>): { positions: Float32Array; normals: Float32Array } {
    const refined = refinedValues(this.refinement, points, 3);
    const limit = multiplySparse(this.limit.positions, refined, 3);
    const along = multiplySparse(this.limit.along, refined, 3);
    const across = multiplySparse(this.limit.across, refined, 3);
    const { pointOfSlot } = this.limit;
    const positions = new Float32Array(3 * pointOfSlot.length);
    const normals = new Float32Array(positions.length);
    const without: number[] = [];
    for (let s = 0; s < pointOfSlot.length; s++) {
      for (let k = 0; k < 3; k++) positions[3 * s + k] = limit[3 * pointOfSlot[s] + k];
      if (!setCross(normals, s, along, across)) without.push(s);
    }
    if (without.length > 0) this.setFaceNormals(normals, without, limit);
    return { positions, normals };
  }

  /** Fallback where tangents vanish or are parallel: the mean normal of the faces. */
  private setFaceNormals(normals: Float32Array, slots: readonly number[], limit: Float64Array): void {
    const { corners, faceStarts } = this.refinement.topology;
    const missing = new Map(slots.map((s) => [s, new Float64Array(3)]));
    for (let c = 0; c < corners.length; c++) {
      const sum = missing.get(this.slotOfCorner[c]);
      if (!sum) continue;
      const size = faceStarts[1];
      const first = c - (c % size);
      const d = diagonals(limit, corners.subarray(first, first + size));
      for (let k = 0; k < 3; k++) sum[k] += d[k];
    }
    for (const [slot, sum] of missing) {
      const length = Math.hypot(...sum);
      normals.set(length > 0 ? sum.map((x) => x / length) : [0, 0, 1], 3 * slot);
    }
  }
}

/** Below this sine two tangents count as parallel. */
const PARALLEL = 1e-9;

function setCross(out: Float32Array, slot: number, a: Float64Array, b: Float64Array): boolean {
  const i = 3 * slot;
  const x = a[i + 1] * b[i + 2] - a[i + 2] * b[i + 1];
  const y = a[i + 2] * b[i] - a[i] * b[i + 2];
  const z = a[i] * b[i + 1] - a[i + 1] * b[i];
  const length = Math.sqrt(x * x + y * y + z * z);
  const most = Math.hypot(a[i], a[i + 1], a[i + 2]) * Math.hypot(b[i], b[i + 1], b[i + 2]);
  if (!(length > PARALLEL * most)) return false;
  out[i] = x / length;
  out[i + 1] = y / length;
  out[i + 2] = z / length;
  return true;
}

/** Twice the area vector of a triangle or quad. */
function diagonals(points: Float64Array, [a, b, c, d = c]: Uint32Array) {
  const [p, q, r, s] = [a, b, c, d].map((i) => pointAt(points, i));
  const from = d === c ? q : s;
  const minus = (u: readonly number[], v: readonly number[]): [number, number, number] => [
    u[0] - v[0],
    u[1] - v[1],
    u[2] - v[2],
  ];
  return d === c ? cross(minus(q, p), minus(r, p)) : cross(minus(r, p), minus(from, q));
}
