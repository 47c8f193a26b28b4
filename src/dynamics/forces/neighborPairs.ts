import type { Force, NeighborForceData, Stiffness, StiffnessForm } from './force.ts';
import { PairForce, type PairPotential } from './pairs.ts';

/** The pair list is rebuilt when a point has moved by this fraction of the reach. */
const SKIN_RATIO = 0.5;

/**
 * A short-range force between points of different bodies, and within a body between points that are farther apart at
 * rest than its reach, so that folds do not pass through each other. Candidate pairs come from a Verlet list: found by
 * cells as wide as the reach plus a skin, and rebuilt when a point has moved by half of the skin, so that none is
 * missed. Source: Verlet 1967, Phys. Rev. 159, 98.
 * @example
 * // Points of two bodies that come nearer than 0.2 m repel.
 * const rest = Float64Array.of(0, 0, 0, 1, 0, 0);
 * const force = new NeighborPairs(Int32Array.of(0, 1), rest, 0.2, new PenaltyPotential(1000, () => 0.2));
 * force.energy(Float64Array.of(0, 0, 0, 0.1, 0, 0)); // 5 J
 * force.energy(rest); // 0 J
 */
export class NeighborPairs implements Force {
  private readonly bodies: Int32Array;
  private readonly rest: Float64Array;
  private readonly reach: number;
  private readonly potential: PairPotential;
  readonly data: NeighborForceData;
  private found: { readonly at: Float64Array; readonly pairs: PairForce } | undefined;

  /** `bodies`: body of each point; points of none (−1) are excluded. `rest`: positions before any deformation. */
  constructor(bodies: Int32Array, rest: Float64Array, reach: number, potential: PairPotential) {
    this.bodies = bodies;
    this.rest = rest;
    this.reach = reach;
    this.potential = potential;
    const candidates = (x: Float64Array, maxTravel: number): Uint32Array => this.candidates(x, maxTravel);
    this.data = { kind: 'near', strength: potential.strength(0), cutoff: reach, candidates };
  }

  energy = (x: Float64Array): number => this.pairs(x).energy(x);
  add = (x: Float64Array, sum: Float64Array): void => this.pairs(x).add(x, sum);

  addDiscreteGradient(x0: Float64Array, x1: Float64Array, sum: Float64Array): void {
    const pairs = this.pairs(x0);
    if (this.isListValid(x1)) pairs.addDiscreteGradient(x0, x1, sum);
    else this.among(x0, maxDisplacement(x0, x1)).addDiscreteGradient(x0, x1, sum);
  }

  stiffness = (x: Float64Array, form: StiffnessForm): Stiffness => this.pairs(x).stiffness(x, form);

  /** Assumes one contact per point; their actual number is not known in advance. */
  addStiffnessBound(bound: Float64Array): void {
    this.bodies.forEach((body, i) => {
      if (body >= 0) bound[i] += 2 * this.potential.maxStiffness(0);
    });
  }

  private pairs(x: Float64Array): PairForce {
    if (!this.found || !this.isListValid(x))
      this.found = { at: x.slice(), pairs: this.among(x, (SKIN_RATIO / 2) * this.reach) };
    return this.found.pairs;
  }

  /** Whether no point is farther than half of the skin from its position at the last rebuild. */
  private isListValid(x: Float64Array): boolean {
    return maxDisplacement(this.found!.at, x) <= (SKIN_RATIO / 2) * this.reach;
  }

  private among = (x: Float64Array, maxTravel: number): PairForce =>
    new PairForce(this.candidates(x, maxTravel), this.potential);

  /**
   * Both ends of all pairs that can be within reach while each point moves by at most `maxTravel`. In index order, so that
   * sums are bit-identical whatever the positions at the rebuild.
   */
  private candidates(x: Float64Array, maxTravel: number): Uint32Array {
    const { bodies } = this;
    const width = this.reach + 2 * maxTravel;
    const cells = new CellList(x, bodies, width);
    const ends: number[] = [];
    for (let i = 0; i < bodies.length; i++) {
      if (bodies[i] < 0) continue;
      const near: number[] = [];
      cells.forEachNeighbor(i, (j) => {
        if (j < i && distanceBetween(x, i, j) <= width && this.canInteract(i, j)) near.push(j);
      });
      for (const j of near.sort((a, b) => a - b)) ends.push(j, i);
    }
    return Uint32Array.from(ends);
  }

  private canInteract = (i: number, j: number): boolean =>
    this.bodies[i] !== this.bodies[j] || distanceBetween(this.rest, i, j) > this.reach;
}

/**
 * Points by grid cell, through a hash of the cell. Source: Teschner et al. 2003, "Optimized Spatial Hashing for
 * Collision Detection of Deformable Objects".
 */
class CellList {
  /** x, y, z of each point's cell. */
  private readonly cells: Int32Array;
  /** Start of each hash bucket. */
  private readonly from: Uint32Array;
  private readonly points: Uint32Array;

  constructor(x: Float64Array, bodies: Int32Array, width: number) {
    const count = bodies.length;
    this.cells = Int32Array.from(x, (value) => Math.floor(value / width));
    this.from = new Uint32Array(2 ** Math.ceil(Math.log2(count + 1)) + 1);
    this.points = new Uint32Array(count);
    for (let i = 0; i < count; i++) if (bodies[i] >= 0) this.from[this.hashOf(i) + 1]++;
    for (let h = 1; h < this.from.length; h++) this.from[h] += this.from[h - 1];
    const free = this.from.slice();
    for (let i = 0; i < count; i++) if (bodies[i] >= 0) this.points[free[this.hashOf(i)]++] = i;
  }

  /** Visits all points in the cell of a point and the cells around it. */
  forEachNeighbor(i: number, visit: (j: number) => void): void {
    const { cells, from, points } = this;
    for (const [dx, dy, dz] of NEIGHBOR_CELLS) {
      const cx = cells[3 * i] + dx;
      const cy = cells[3 * i + 1] + dy;
      const cz = cells[3 * i + 2] + dz;
      const hash = this.hash(cx, cy, cz);
      for (let k = from[hash]; k < from[hash + 1]; k++) {
        const j = points[k];
        if (cells[3 * j] === cx && cells[3 * j + 1] === cy && cells[3 * j + 2] === cz) visit(j);
      }
    }
  }

  private hashOf = (i: number): number => this.hash(this.cells[3 * i], this.cells[3 * i + 1], this.cells[3 * i + 2]);

  private hash = (x: number, y: number, z: number): number =>
    (Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791)) & (this.from.length - 2);
}

const NEIGHBOR_CELLS = [-1, 0, 1].flatMap((x) => [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((z) => [x, y, z] as const)));

const distanceBetween = (x: Float64Array, i: number, j: number): number =>
  Math.hypot(x[3 * i] - x[3 * j], x[3 * i + 1] - x[3 * j + 1], x[3 * i + 2] - x[3 * j + 2]);

/** Maximum displacement of any point. */
export function maxDisplacement(a: Float64Array, b: Float64Array): number {
  let most = 0;
  for (let j = 0; j < a.length; j += 3)
    most = Math.max(most, (a[j] - b[j]) ** 2 + (a[j + 1] - b[j + 1]) ** 2 + (a[j + 2] - b[j + 2]) ** 2);
  return Math.sqrt(most);
}
