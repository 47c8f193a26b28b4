import type { Vec3 } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import type { Stiffness } from '../forces/force.ts';
import { AndersonAcceleration } from '../linear/andersonAcceleration.ts';
import { ConjugateGradients } from '../linear/conjugateGradients.ts';
import { StepMatrix } from '../linear/stepMatrix.ts';
import { maxAngularFrequency } from '../stability.ts';
import { assignState, relativisticMasses, type State, type System } from '../system.ts';
import { type IntegrationMethod, potentialForces, StepFailure, type Stepper } from './method.ts';

/** Steps x₁ = x₀ + h (p₀ + p₁)/W, p₁ = p₀ + h F̄, where W and F̄ define the method. |x₁ − x₀| < c h by construction. */
interface ImplicitScheme {
  /** W of each point [kg]; M₀ = E₀/c². */
  weights(system: System, step: StepStart, p1: Float64Array, out: Float64Array): void;
  /** F̄ of the potentials [N]; `half` is a scratch buffer of positions. */
  meanForce(system: System, x0: Float64Array, x1: Float64Array, half: Float64Array, out: Float64Array): void;
}

interface StepStart {
  readonly p0: Float64Array;
  readonly M0: Float64Array;
}

/**
 * W = (E₀ + E₁)/c² and F̄ the discrete gradient: v̄·Δp = ΔT and F̄·Δx = −ΔV, so energy is conserved to the solver's
 * tolerance.
 */
const DISCRETE_GRADIENT_SCHEME: ImplicitScheme = {
  weights(system, { M0 }, p1, out) {
    relativisticMasses(system, p1, out);
    for (let i = 0; i < out.length; i++) out[i] += M0[i];
  },
  meanForce({ forces }, x0, x1, _, out) {
    out.fill(0);
    for (const force of forces) force.addDiscreteGradient(x0, x1, out);
  },
};

/** Midpoint velocity and force; symplectic, conserves quadratic invariants: momentum and angular momentum. */
const MIDPOINT_SCHEME: ImplicitScheme = {
  weights({ c, masses }, { p0 }, p1, out) {
    const perSquare = 1 / (c * c);
    for (let i = 0, j = 0; i < masses.length; i++, j += 3) {
      const x = p0[j] + p1[j];
      const y = p0[j + 1] + p1[j + 1];
      const z = p0[j + 2] + p1[j + 2];
      out[i] = Math.sqrt(4 * masses[i] * masses[i] + (x * x + y * y + z * z) * perSquare);
    }
  },
  meanForce(system, x0, x1, half, out) {
    midpointOf(x0, x1, half);
    potentialForces(system, half, out);
  },
};

function midpointOf(a: Float64Array, b: Float64Array, out: Float64Array): void {
  for (let j = 0; j < out.length; j++) out[j] = 0.5 * (a[j] + b[j]);
}

/** Conserves energy for any step size. Source: Gonzalez 1996; for H = √(p²c² + m²c⁴) + V: docs/physics.md §11.4. */
export const discreteGradient: IntegrationMethod = {
  id: 'discrete-gradient',
  order: 2,
  conditionallyStable: false,
  begin: (system) => new ImplicitStepper(system, DISCRETE_GRADIENT_SCHEME),
};

/** Source: Hairer, Lubich, Wanner, §II.1 and §VI.4. */
export const implicitMidpoint: IntegrationMethod = {
  id: 'implicit-midpoint',
  order: 2,
  conditionallyStable: false,
  begin: (system) => new ImplicitStepper(system, MIDPOINT_SCHEME),
};

/** Maximum number of fixed-point iterations x₁ → x₀ + h v̄(x₁), and of Newton iterations. */
const MAX_ITERATIONS = 200;
/** Iterations without improvement before giving up. */
const MAX_STALLED_ITERATIONS = 12;
/**
 * Fixed-point iterations contract the error by (hω/2)² or more; below 1, Newton iterations are not worth their cost.
 */
const FIXED_POINT_LIMIT = 4;
/** Converged if an iteration moves no point by more than this, relative to the largest coordinate. */
const TOLERANCE = Number.EPSILON;
/** Fixed-point iterates are one iteration ahead of the forces that they are computed from. */
const FIXED_POINT_TOLERANCE = 4 * Number.EPSILON;
/**
 * Rounding may prevent more: accepted after one Newton iteration, or two fixed-point iterations, without improvement.
 */
const STALL_TOLERANCE = 8 * Number.EPSILON;
const REPEATED_STALL_TOLERANCE = 1e-13;
/** A step is split into at most 2¹⁰ parts. */
const MAX_HALVINGS = 10;
/** Lower bound of 1 − β², which rounding must not make 0. */
const MIN_INVERSE_GAMMA_SQUARED = 1e-12;
/**
 * Tolerance and iteration limit of Newton's linear systems: more accuracy would be wasted, since their matrix is
 * approximate.
 */
const LINEAR_SOLVE = { tolerance: 1e-2, most: 400 };

class ImplicitStepper implements Stepper {
  private readonly system: System;
  private readonly scheme: ImplicitScheme;
  private readonly omega: number;
  private readonly W: Float64Array;
  private readonly M0: Float64Array;
  /** 2W/h² per point [kg/s²]. */
  private readonly N: Float64Array;
  private readonly x0: Float64Array;
  private readonly p0: Float64Array;
  private readonly stepStart: StepStart;
  private readonly next: Float64Array;
  private readonly force: Float64Array;
  private readonly half: Float64Array;
  private readonly change: Float64Array;
  /** γβ of the mean velocities. */
  private readonly u: Float64Array;
  private readonly linear: ConjugateGradients;
  private readonly matrix: StepMatrix;
  private stiffnesses: Stiffness[] = [];
  private readonly anderson: AndersonAcceleration;

  constructor(system: System, scheme: ImplicitScheme) {
    this.system = system;
    this.scheme = scheme;
    this.omega = maxAngularFrequency(system);
    const size = 3 * system.masses.length;
    this.W = new Float64Array(system.masses.length);
    this.M0 = new Float64Array(system.masses.length);
    this.N = new Float64Array(system.masses.length);
    this.x0 = new Float64Array(size);
    this.p0 = new Float64Array(size);
    this.stepStart = { p0: this.p0, M0: this.M0 };
    this.next = new Float64Array(size);
    this.force = new Float64Array(size);
    this.half = new Float64Array(size);
    this.change = new Float64Array(size);
    this.u = new Float64Array(size);
    this.linear = new ConjugateGradients(size);
    this.matrix = new StepMatrix(system.pinned);
    this.anderson = new AndersonAcceleration(size);
  }

  /** If the equations cannot be solved the step is split in halves, which conserve the same quantities. */
  step(state: State, h: number, halvings = 0): void {
    const { t } = state;
    if (this.solveStep(state, h)) {
      state.t = t + h;
      return;
    }
    if (halvings === MAX_HALVINGS)
      throw new StepFailure('unsolved', msg`the equations of an implicit step were not solved; take a smaller step`);
    assignState(state, { x: this.x0, p: this.p0, t });
    this.step(state, h / 2, halvings + 1);
    this.step(state, h / 2, halvings + 1);
    state.t = t + h;
  }

  private solveStep(state: State, h: number): boolean {
    this.x0.set(state.x);
    this.p0.set(state.p);
    relativisticMasses(this.system, state.p, this.M0);
    this.predict(state, h);
    if (
      (this.omega * h) ** 2 < FIXED_POINT_LIMIT &&
      this.solve(state, h, FIXED_POINT_TOLERANCE, () => this.fixedPointChange(state.x))
    ) {
      state.x.set(this.next);
      return true;
    }
    state.p.set(this.p0);
    this.predict(state, h);
    return this.solve(state, h, TOLERANCE, () => this.newtonChange(state.x, h));
  }

  /** Initial guess: uniform motion. */
  private predict({ x, p }: State, h: number): void {
    const { M0, x0 } = this;
    for (let i = 0, j = 0; i < M0.length; i++, j += 3) {
      const s = h / M0[i];
      x[j] = x0[j] + s * p[j];
      x[j + 1] = x0[j + 1] + s * p[j + 1];
      x[j + 2] = x0[j + 2] + s * p[j + 2];
    }
  }

  /** Iterates until x₁ converges; `change` returns the update of x₁. Returns whether it converged. */
  private solve(state: State, h: number, enough: number, change: () => Float64Array): boolean {
    const { anderson } = this;
    anderson.reset();
    let best = Number.POSITIVE_INFINITY;
    for (let round = 0, since = 0; since < MAX_STALLED_ITERATIONS && round < MAX_ITERATIONS; round++) {
      const [off, size] = this.evaluateResidual(state, h);
      if (off <= enough * size) return true;
      since = off < best ? 0 : since + 1;
      if ((since > 0 && off <= STALL_TOLERANCE * size) || (since > 1 && off <= REPEATED_STALL_TOLERANCE * size))
        return true;
      if (!Number.isFinite(off)) return false;
      best = Math.min(best, off);
      anderson.next(state.x, change());
    }
    return false;
  }

  /** Update of a fixed-point iteration. */
  private fixedPointChange(x: Float64Array): Float64Array {
    const { next, change } = this;
    for (let j = 0; j < x.length; j++) change[j] = next[j] - x[j];
    return change;
  }

  /** Computes p₁ at x₁ = `state.x`, and `next` = x₀ + h v̄; returns its distance from x₁ and the largest coordinate. */
  private evaluateResidual({ x, p }: State, h: number): readonly [off: number, size: number] {
    const { system, x0, p0, next, W } = this;
    this.updateMomenta(x, p, h);
    this.scheme.weights(system, this.stepStart, p, W);
    let off = 0;
    let size = 0;
    for (let i = 0, j = 0; i < W.length; i++, j += 3) {
      const s = h / W[i];
      const a = x0[j] + s * (p0[j] + p[j]);
      const b = x0[j + 1] + s * (p0[j + 1] + p[j + 1]);
      const c = x0[j + 2] + s * (p0[j + 2] + p[j + 2]);
      next[j] = a;
      next[j + 1] = b;
      next[j + 2] = c;
      off = Math.max(off, Math.abs(a - x[j]), Math.abs(b - x[j + 1]), Math.abs(c - x[j + 2]));
      size = Math.max(size, Math.abs(a), Math.abs(b), Math.abs(c));
    }
    return [Number.isNaN(off) ? Number.POSITIVE_INFINITY : off, size];
  }

  /** p = p₀ + h (F̄ + q v̄ × B), v̄ = (x − x₀)/h; p₀ for pinned points. */
  private updateMomenta(x: Float64Array, p: Float64Array, h: number): void {
    const { system, x0, p0, force } = this;
    this.scheme.meanForce(system, x0, x, this.half, force);
    for (let j = 0; j < p.length; j++) p[j] = p0[j] + h * force[j];
    const { charges, magneticField: B, pinned } = system;
    if (charges && B) addMagneticImpulse(p, x0, x, charges, B);
    for (let i = 0; i < pinned.length; i++) if (pinned[i]) for (let j = 3 * i; j < 3 * i + 3; j++) p[j] = p0[j];
  }

  /**
   * x −= [N(I + γ²ββᵀ) + ∇²V]⁻¹ N(I + γ²ββᵀ)(x − next), N = 2W/h²: a Newton step with ∇²V of the midpoint; without its
   * negative parts where the matrix would be indefinite.
   */
  private newtonChange(x: Float64Array, h: number): Float64Array {
    const { system, x0, change, matrix, half, u, N, force: b } = this;
    midpointOf(x0, x, half);
    this.assembleInertia(x, h, b);
    for (const form of ['exact', 'safe'] as const) {
      this.stiffnesses = system.forces.map((force, k) => force.stiffness(half, form, this.stiffnesses[k]));
      matrix.set(this.stiffnesses, N, u);
      change.fill(0);
      if (!this.linear.solve(matrix, b, change, LINEAR_SOLVE.tolerance, LINEAR_SOLVE.most).indefinite) break;
    }
    return change;
  }

  /** γβ of the mean velocities, N, and b = N(I + γ²ββᵀ)(next − x). */
  private assembleInertia(x: Float64Array, h: number, b: Float64Array): void {
    const { system, x0, W, N, next, u } = this;
    const perLight = 1 / (h * system.c);
    for (let i = 0, j = 0; i < W.length; i++, j += 3) {
      const held = system.pinned[i] ? 0 : 1;
      N[i] = (2 * W[i]) / (h * h);
      const bx = (next[j] - x0[j]) * perLight;
      const by = (next[j + 1] - x0[j + 1]) * perLight;
      const bz = (next[j + 2] - x0[j + 2]) * perLight;
      const gamma = 1 / Math.sqrt(Math.max(MIN_INVERSE_GAMMA_SQUARED, 1 - (bx * bx + by * by + bz * bz)));
      u[j] = gamma * bx;
      u[j + 1] = gamma * by;
      u[j + 2] = gamma * bz;
      const dx = next[j] - x[j];
      const dy = next[j + 1] - x[j + 1];
      const dz = next[j + 2] - x[j + 2];
      const along = u[j] * dx + u[j + 1] * dy + u[j + 2] * dz;
      b[j] = held * N[i] * (dx + along * u[j]);
      b[j + 1] = held * N[i] * (dy + along * u[j + 1]);
      b[j + 2] = held * N[i] * (dz + along * u[j + 2]);
    }
  }
}

/** p += q (x − x₀) × B */
function addMagneticImpulse(p: Float64Array, x0: Float64Array, x: Float64Array, charges: Float64Array, B: Vec3): void {
  for (let i = 0, j = 0; i < charges.length; i++, j += 3) {
    const [dx, dy, dz] = [x[j] - x0[j], x[j + 1] - x0[j + 1], x[j + 2] - x0[j + 2]];
    p[j] += charges[i] * (dy * B[2] - dz * B[1]);
    p[j + 1] += charges[i] * (dz * B[0] - dx * B[2]);
    p[j + 2] += charges[i] * (dx * B[1] - dy * B[0]);
  }
}
