import { Anderson } from '../linear/anderson.ts';
import { ConjugateGradients } from '../linear/conjugateGradients.ts';
import { StepMatrix } from '../linear/stepMatrix.ts';
import { fastestOscillation } from '../stability.ts';
import { assign, movingMasses, type State, type System } from '../system.ts';
import { type Method, StepFailure, type Stepper } from './method.ts';

/**
 * Steps x₁ = x₀ + h (p₀ + p₁)/W, p₁ = p₀ + h F̄: what W and F̄ are makes the method. |x₁ − x₀| < c h by construction.
 */
interface Rule {
  /** W of each point [kg]. */
  weights(system: System, p0: Float64Array, p1: Float64Array, out: Float64Array): void;
  /** F̄ of the potentials [N]. */
  meanForce(system: System, x0: Float64Array, x1: Float64Array, out: Float64Array): void;
}

/** W = (E₀ + E₁)/c² and F̄ the discrete gradient: v̄·Δp = ΔT and F̄·Δx = −ΔV, and so the energy is kept, as far as the equations are solved. */
const KEEPING_ENERGY: Rule = {
  weights(system, p0, p1, out) {
    movingMasses(system, p0, out);
    const M0 = out.slice();
    movingMasses(system, p1, out);
    for (let i = 0; i < out.length; i++) out[i] += M0[i];
  },
  meanForce({ forces }, x0, x1, out) {
    out.fill(0);
    for (const force of forces) force.addMean(x0, x1, out);
  },
};

/** Velocity and force halfway; symplectic, and it keeps what is quadratic: momentum and angular momentum. */
const HALFWAY: Rule = {
  weights(system, p0, p1, out) {
    const half = p0.map((value, j) => (value + p1[j]) / 2);
    movingMasses(system, half, out);
    for (let i = 0; i < out.length; i++) out[i] *= 2;
  },
  meanForce({ forces }, x0, x1, out) {
    const half = x0.map((value, j) => (value + x1[j]) / 2);
    out.fill(0);
    for (const force of forces) force.add(half, out);
  },
};

/** Keeps the energy exactly, whatever the step. Source: Gonzalez 1996; for H = √(p²c² + m²c⁴) + V physics.md, Mechanics. */
export const discreteGradient: Method = {
  id: 'discrete-gradient',
  order: 2,
  bounded: false,
  begin: (system) => new Implicit(system, KEEPING_ENERGY),
};

/** Source: Hairer, Lubich, Wanner, §II.1 and §VI.4. */
export const implicitMidpoint: Method = {
  id: 'implicit-midpoint',
  order: 2,
  bounded: false,
  begin: (system) => new Implicit(system, HALFWAY),
};

/** Rounds of x₁ → x₀ + h v̄(x₁) that may be taken, and of Newton's. */
const MOST_ROUNDS = 200;
/** So many that bring it no nearer are the end. */
const PATIENCE = 12;
/** Rounds by themselves leave (hω/2)² of the error or less: where that is little, Newton's steps are not worth their price. */
const SIMPLE = 4 * 0.25;
/** Solved where a round moves no point by more than this, over the largest coordinate. */
const ENOUGH = 4 * Number.EPSILON;
/** Rounding may leave more: where rounds make it no better, this is enough. */
const ALMOST = 1e-12;
/** A step is cut into 2¹⁰ at most. */
const MOST_HALVINGS = 10;
/** Of 1 − β², for rounding must not make it 0. */
const LEAST_REST = 1e-12;
/** How well, and in how many rounds, Newton's linear systems are solved. */
const LINEAR = { tolerance: 1e-6, most: 400 };

class Implicit implements Stepper {
  private readonly system: System;
  private readonly rule: Rule;
  private readonly omega: number;
  private readonly W: Float64Array;
  private readonly x0: Float64Array;
  private readonly p0: Float64Array;
  private readonly next: Float64Array;
  private readonly force: Float64Array;
  private readonly change: Float64Array;
  private readonly linear: ConjugateGradients;
  private readonly anderson = new Anderson();

  constructor(system: System, rule: Rule) {
    this.system = system;
    this.rule = rule;
    this.omega = fastestOscillation(system);
    const size = 3 * system.masses.length;
    this.W = new Float64Array(system.masses.length);
    this.x0 = new Float64Array(size);
    this.p0 = new Float64Array(size);
    this.next = new Float64Array(size);
    this.force = new Float64Array(size);
    this.change = new Float64Array(size);
    this.linear = new ConjugateGradients(size);
  }

  /** A step whose equations resist is taken in halves: what is kept exactly is kept by these too. */
  step(state: State, h: number, halvings = 0): void {
    const { t } = state;
    const start = { x: state.x.slice(), p: state.p.slice() };
    if (this.whole(state, h)) {
      state.t = t + h;
      return;
    }
    if (halvings === MOST_HALVINGS)
      throw new StepFailure('unsolved', 'the equations of an implicit step were not solved; take a smaller step');
    assign(state, { ...start, t });
    this.step(state, h / 2, halvings + 1);
    this.step(state, h / 2, halvings + 1);
    state.t = t + h;
  }

  private whole(state: State, h: number): boolean {
    this.x0.set(state.x);
    this.p0.set(state.p);
    this.guess(state, h);
    if ((this.omega * h) ** 2 < SIMPLE && this.solve(state, h, (x) => this.rest(x))) return true;
    state.p.set(this.p0);
    this.guess(state, h);
    return this.solve(state, h, (x) => this.newton(x, h));
  }

  /** Straight on. */
  private guess({ x, p }: State, h: number): void {
    movingMasses(this.system, p, this.W);
    for (let i = 0; i < this.W.length; i++)
      for (let j = 3 * i; j < 3 * i + 3; j++) x[j] = this.x0[j] + (h * p[j]) / this.W[i];
  }

  /** Rounds until x₁ stays; `change` tells by how much x₁ is to change. Whether it came to an end. */
  private solve(state: State, h: number, change: (x: Float64Array) => Float64Array): boolean {
    const { anderson } = this;
    anderson.forget();
    let best = Number.POSITIVE_INFINITY;
    for (let round = 0, since = 0; since < PATIENCE && round < MOST_ROUNDS; round++) {
      const [off, size] = this.round(state, h);
      if (off <= ENOUGH * size) return true;
      since = off < best ? 0 : since + 1;
      // What rounding leaves goes up and down.
      if (since > 1 && off <= ALMOST * size) return true;
      if (!Number.isFinite(off)) return false;
      best = Math.min(best, off);
      anderson.next(state.x, change(state.x));
    }
    return false;
  }

  /** What a round changes by itself. */
  private rest(x: Float64Array): Float64Array {
    const { next, change } = this;
    for (let j = 0; j < x.length; j++) change[j] = next[j] - x[j];
    return change;
  }

  /** p₁ of x₁ = `state.x`, and `next` = x₀ + h v̄: how far it is from x₁, and the largest coordinate. */
  private round({ x, p }: State, h: number): readonly [off: number, size: number] {
    const { system, x0, p0, next, W } = this;
    this.push(x, p, h);
    this.rule.weights(system, p0, p, W);
    let [off, size] = [0, 0];
    for (let i = 0; i < W.length; i++) {
      if (system.pinned[i]) p.fill(0, 3 * i, 3 * i + 3);
      for (let j = 3 * i; j < 3 * i + 3; j++) {
        next[j] = x0[j] + (h * (p0[j] + p[j])) / W[i];
        off = Math.max(off, Math.abs(next[j] - x[j]));
        size = Math.max(size, Math.abs(next[j]));
      }
    }
    return [Number.isNaN(off) ? Number.POSITIVE_INFINITY : off, size];
  }

  /** p = p₀ + h (F̄ + q v̄ × B), v̄ = (x − x₀)/h */
  private push(x: Float64Array, p: Float64Array, h: number): void {
    const { system, x0, p0, force } = this;
    this.rule.meanForce(system, x0, x, force);
    for (let j = 0; j < p.length; j++) p[j] = p0[j] + h * force[j];
    const { charges, magneticField: B } = system;
    if (!charges || !B) return;
    for (let i = 0, j = 0; i < charges.length; i++, j += 3) {
      const [dx, dy, dz] = [x[j] - x0[j], x[j + 1] - x0[j + 1], x[j + 2] - x0[j + 2]];
      p[j] += charges[i] * (dy * B[2] - dz * B[1]);
      p[j + 1] += charges[i] * (dz * B[0] - dx * B[2]);
      p[j + 2] += charges[i] * (dx * B[1] - dy * B[0]);
    }
  }

  /** x −= [W(I + γ²ββᵀ) + ½h²∇²V]⁻¹ W(I + γ²ββᵀ)(x − next): Newton's step, but that ∇²V is that of halfway; without its negative parts, where they would lead astray. */
  private newton(x: Float64Array, h: number): Float64Array {
    const { system, x0, change } = this;
    const { forces, pinned } = system;
    const half = x.map((value, j) => (value + x0[j]) / 2);
    const { u, b } = this.inertia(x, h);
    for (const form of ['exact', 'safe'] as const) {
      const stiffnesses = forces.map((force) => force.stiffness(half, form));
      const A = new StepMatrix(pinned, stiffnesses, (h * h) / 2, this.W, u);
      change.fill(0);
      if (!this.linear.solve(A, b, change, LINEAR.tolerance, LINEAR.most).indefinite) break;
    }
    return change;
  }

  /** γβ of the mean velocities, and W(I + γ²ββᵀ)(next − x). */
  private inertia(x: Float64Array, h: number): { readonly u: Float64Array; readonly b: Float64Array } {
    const { system, x0, W, next } = this;
    const u = new Float64Array(x.length);
    const b = new Float64Array(x.length);
    for (let i = 0, j = 0; i < W.length; i++, j += 3) {
      if (system.pinned[i]) continue;
      const beta = [0, 1, 2].map((k) => (next[j + k] - x0[j + k]) / (h * system.c));
      const gamma = 1 / Math.sqrt(Math.max(LEAST_REST, 1 - (beta[0] ** 2 + beta[1] ** 2 + beta[2] ** 2)));
      let along = 0;
      for (let k = 0; k < 3; k++) {
        u[j + k] = gamma * beta[k];
        along += u[j + k] * (next[j + k] - x[j + k]);
      }
      for (let k = j; k < j + 3; k++) b[k] = W[i] * (next[k] - x[k] + along * u[k]);
    }
    return { u, b };
  }
}
