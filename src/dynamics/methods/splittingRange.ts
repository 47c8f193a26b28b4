import type { Vec3 } from '../../math/vec3.ts';
import type { State, System } from '../system.ts';
import type { SplittingWork } from './method.ts';

/**
 * The stages of a splitting's step, for the points first … end − 1 of a system; default: all. Each point's numbers are
 * the same to the bit whatever the range. A range of some points needs forces that can be bound.
 */
export class SplittingRange implements SplittingWork {
  private readonly system: System;
  private readonly first: number;
  private readonly end: number;
  /** [N]; beyond the range without meaning. */
  private readonly force: Float64Array;
  /** For the last state, and for the one before: adaptive steps alternate between two. */
  private bound: readonly [last: BoundStages, other?: BoundStages] | undefined;

  constructor(system: System, first = 0, end = system.masses.length) {
    this.system = system;
    this.first = first;
    this.end = end;
    this.force = new Float64Array(3 * system.masses.length);
  }

  /** x += h p/γm */
  drift(state: State, h: number): void {
    this.stagesFor(state).drift(h);
  }

  kick(state: State, h: number, drift: number): void {
    this.sumForces(state);
    this.applyForces(state, h, drift);
  }

  /** The force on each point at x. */
  sumForces(state: State): void {
    const { force, first, end } = this;
    force.fill(0, 3 * first, 3 * end);
    for (const add of this.stagesFor(state).forces) add();
  }

  /** p += h F at constant x, with a magnetic field in two halves, before and after p rotates; then the drift. */
  applyForces(state: State, h: number, drift: number): void {
    const { charges, magneticField } = this.system;
    const stages = this.stagesFor(state);
    if (charges && magneticField) {
      stages.addImpulse(h / 2);
      this.rotateMomenta(state.p, h, charges, magneticField);
      stages.addImpulse(h / 2);
      stages.drift(drift);
    } else stages.kickAndDrift(h, drift);
  }

  private stagesFor({ x, p }: State): BoundStages {
    const [last, other] = this.bound ?? [];
    if (last?.x === x && last.p === p) return last;
    const found = other?.x === x && other.p === p ? other : this.bind(x, p);
    this.bound = [found, last];
    return found;
  }

  /** Functions of their own for the arrays: compiled for them where they are the only ones (docs/adr/0057-threads-of-cloth.md). */
  private bind(x: Float64Array, p: Float64Array): BoundStages {
    const { force, first, end } = this;
    const { c, masses, pinned, forces } = this.system;
    return {
      ...{ x, p },
      drift: (h) => driftPoints(x, p, masses, 1 / (c * c), h, first, end),
      addImpulse: (h) => addImpulse(p, force, pinned, h, first, end),
      kickAndDrift: (h, drift) => kickAndDrift(x, p, force, masses, pinned, 1 / (c * c), h, drift, first, end),
      forces: forces.map((each) => each.bind?.(x, force, first, end) ?? (() => each.add(x, force))),
    };
  }

  /** dp/dt = q p × B/γm rotates p about −B by q|B|h/γm, exactly. */
  private rotateMomenta(p: Float64Array, h: number, charges: Float64Array, B: Vec3): void {
    const { first, end } = this;
    const { c: light, masses, pinned } = this.system;
    const strength = Math.hypot(...B);
    if (strength === 0) return;
    const [bx, by, bz] = B.map((value) => value / strength);
    for (let i = first, j = 3 * first; i < end; i++, j += 3) {
      if (pinned[i] || charges[i] === 0) continue;
      const [x, y, z] = [p[j], p[j + 1], p[j + 2]];
      const M = Math.sqrt(masses[i] * masses[i] + (x * x + y * y + z * z) / (light * light));
      const angle = (-charges[i] * strength * h) / M;
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      const along = (1 - c) * (x * bx + y * by + z * bz);
      p[j] = c * x + s * (by * z - bz * y) + along * bx;
      p[j + 1] = c * y + s * (bz * x - bx * z) + along * by;
      p[j + 2] = c * z + s * (bx * y - by * x) + along * bz;
    }
  }
}

interface BoundStages {
  readonly x: Float64Array;
  readonly p: Float64Array;
  readonly drift: (h: number) => void;
  readonly addImpulse: (h: number) => void;
  readonly kickAndDrift: (h: number, drift: number) => void;
  readonly forces: readonly (() => void)[];
}

function driftPoints(
  x: Float64Array,
  p: Float64Array,
  masses: Float64Array,
  perSquare: number,
  h: number,
  first: number,
  end: number,
): void {
  for (let i = first, j = 3 * first; i < end; i++, j += 3) {
    const px = p[j];
    const py = p[j + 1];
    const pz = p[j + 2];
    const s = h / Math.sqrt(masses[i] * masses[i] + (px * px + py * py + pz * pz) * perSquare);
    x[j] += s * px;
    x[j + 1] += s * py;
    x[j + 2] += s * pz;
  }
}

function addImpulse(
  p: Float64Array,
  force: Float64Array,
  pinned: Uint8Array,
  h: number,
  first: number,
  end: number,
): void {
  for (let i = first, j = 3 * first; i < end; i++, j += 3) {
    if (pinned[i]) continue;
    p[j] += h * force[j];
    p[j + 1] += h * force[j + 1];
    p[j + 2] += h * force[j + 2];
  }
}

function kickAndDrift(
  x: Float64Array,
  p: Float64Array,
  force: Float64Array,
  masses: Float64Array,
  pinned: Uint8Array,
  perSquare: number,
  h: number,
  drift: number,
  first: number,
  end: number,
): void {
  for (let i = first, j = 3 * first; i < end; i++, j += 3) {
    let px = p[j];
    let py = p[j + 1];
    let pz = p[j + 2];
    if (!pinned[i]) {
      px += h * force[j];
      py += h * force[j + 1];
      pz += h * force[j + 2];
      p[j] = px;
      p[j + 1] = py;
      p[j + 2] = pz;
    }
    const s = drift / Math.sqrt(masses[i] * masses[i] + (px * px + py * py + pz * pz) * perSquare);
    x[j] += s * px;
    x[j + 1] += s * py;
    x[j + 2] += s * pz;
  }
}
