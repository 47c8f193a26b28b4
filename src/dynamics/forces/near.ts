import type { Force, Stiffness, StiffnessForm } from './force.ts';
import { type PairLaw, Pairs } from './pairs.ts';

/** Points are looked at anew when one has gone this share of the reach. */
const SKIN = 0.5;

/**
 * A short force between points of different bodies: of all pairs only those are looked at that can be within reach. They are found by cells as wide as the reach and a
 * skin, and found anew when a point has gone half of the skin: so none is ever missed. Source: Verlet 1967, Phys. Rev. 159, 98.
 */
export class NearPairs implements Force {
  /** Of each point; pairs of one body are left out, and so are points of none (−1). */
  private readonly bodies: Int32Array;
  private readonly reach: number;
  private readonly law: PairLaw;
  private found: { readonly at: Float64Array; readonly pairs: Pairs } | undefined;

  constructor(bodies: Int32Array, reach: number, law: PairLaw) {
    this.bodies = bodies;
    this.reach = reach;
    this.law = law;
  }

  energy = (x: Float64Array): number => this.pairs(x).energy(x);
  add = (x: Float64Array, sum: Float64Array): void => this.pairs(x).add(x, sum);

  addMean(x0: Float64Array, x1: Float64Array, sum: Float64Array): void {
    const pairs = this.pairs(x0);
    if (this.holds(x1)) pairs.addMean(x0, x1, sum);
    else this.search(x0, largestWay(x0, x1)).addMean(x0, x1, sum);
  }

  stiffness = (x: Float64Array, form: StiffnessForm): Stiffness => this.pairs(x).stiffness(x, form);

  /** As if each point met one other: how many will nobody can tell. */
  addRigidity(bound: Float64Array): void {
    this.bodies.forEach((body, i) => {
      if (body >= 0) bound[i] += 2 * this.law.rigidity(0);
    });
  }

  private pairs(x: Float64Array): Pairs {
    if (!this.found || !this.holds(x)) this.found = { at: x.slice(), pairs: this.search(x, (SKIN / 2) * this.reach) };
    return this.found.pairs;
  }

  /** Whether no point is farther than half of the skin from where pairs were found. */
  private holds(x: Float64Array): boolean {
    return largestWay(this.found!.at, x) <= (SKIN / 2) * this.reach;
  }

  /** Pairs that are within reach where each point goes `way` at most. */
  private search(x: Float64Array, way: number): Pairs {
    const { bodies } = this;
    const width = this.reach + 2 * way;
    const cells = new Map<string, number[]>();
    const cellOf = (i: number): [number, number, number] => [
      Math.floor(x[3 * i] / width),
      Math.floor(x[3 * i + 1] / width),
      Math.floor(x[3 * i + 2] / width),
    ];
    const ends: number[] = [];
    bodies.forEach((body, i) => {
      if (body < 0) return;
      const [cx, cy, cz] = cellOf(i);
      for (const [dx, dy, dz] of AROUND)
        for (const j of cells.get(`${cx + dx} ${cy + dy} ${cz + dz}`) ?? [])
          if (bodies[j] !== body && apart(x, i, j) <= width) ends.push(j, i);
      const own = `${cx} ${cy} ${cz}`;
      const members = cells.get(own);
      if (members) members.push(i);
      else cells.set(own, [i]);
    });
    return new Pairs(Uint32Array.from(ends), this.law);
  }
}

const AROUND = [-1, 0, 1].flatMap((x) => [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((z) => [x, y, z] as const)));

const apart = (x: Float64Array, i: number, j: number): number =>
  Math.hypot(x[3 * i] - x[3 * j], x[3 * i + 1] - x[3 * j + 1], x[3 * i + 2] - x[3 * j + 2]);

function largestWay(a: Float64Array, b: Float64Array): number {
  let most = 0;
  for (let j = 0; j < a.length; j += 3)
    most = Math.max(most, (a[j] - b[j]) ** 2 + (a[j + 1] - b[j + 1]) ** 2 + (a[j + 2] - b[j + 2]) ** 2);
  return Math.sqrt(most);
}
