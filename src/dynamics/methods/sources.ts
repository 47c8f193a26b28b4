import { potentialEnergy } from '../energy.ts';
import type { Stiffness, StiffnessForm } from '../forces/force.ts';
import { ConjugateGradients } from '../linear/conjugateGradients.ts';
import { StepMatrix } from '../linear/stepMatrix.ts';
import { momenta, type State, type System, SystemError, velocities } from '../system.ts';
import { type Correction, correctedShare } from './correction.ts';
import { forceAt, type Method, StepFailure, type Stepper } from './method.ts';

/*
 * The methods of the source documents, to be compared with: they hold velocities, turn forces into accelerations by (I − ββᵀ)/γm at the velocity before the step,
 * and nothing keeps them below c. Their energy is corrected by a share of each step's Δv (correction.ts).
 */

/** v += h a(x, v), x += h v */
export const semiImplicitEuler = (correction: Correction): Method =>
  method('semi-implicit-euler', correction, (system) => {
    const force = new Float64Array(3 * system.masses.length);
    return (x, v, h) => {
      forceAt(system, x, force);
      addMagnetic(system, v, force);
      return accelerated(system, v, force, h);
    };
  });

/** One Newton step for the places. */
export const linearlyImplicit = (correction: Correction): Method =>
  method('linearly-implicit', correction, (system) => towards(system, 1, 'exact'));

/** Springs are drawn to fixed places, which then turn with them, in turns: each global step is a linear system whose part of the springs does not change. */
export const localGlobal = (correction: Correction): Method =>
  method('local-global', correction, (system) => towards(system, 10, 'isotropic'));

/**
 * The places after a step by γm/h² (I + γ²ββᵀ)(x − xₙ − hv) = F(x), which is the documents’ equation times (I − ββᵀ)⁻¹, and so symmetric: rounds of
 * [γm/h² (I + γ²ββᵀ) + K] δ = F − γm/h² (I + γ²ββᵀ)(x − xₙ − hv), with K a form of ∇²V.
 */
function towards(system: System, rounds: number, form: StiffnessForm): Change {
  const linear = new ConjugateGradients(3 * system.masses.length);
  const matrix = new StepMatrix(system.pinned);
  let stiffnesses: Stiffness[] = [];
  return (x0, v, h) => {
    const { u, weights } = inertia(system, v, h);
    // Points that are held go on as they are led.
    const x = x0.map((value, j) => (system.pinned[Math.floor(j / 3)] ? value + h * v[j] : value));
    for (let round = 0; round < rounds; round++) {
      const b = missing(system, { x0, x, v, h, u, weights });
      stiffnesses = system.forces.map((each, k) => each.stiffness(x, form, stiffnesses[k]));
      matrix.set(stiffnesses, weights, u);
      const dx = new Float64Array(x.length);
      const { indefinite } = linear.solve(matrix, b, dx, 1e-10, 1000);
      if (indefinite)
        throw new StepFailure('indefinite', 'the matrix of the step is not positive definite; take a smaller step');
      for (let j = 0; j < x.length; j++) x[j] += dx[j];
    }
    return x.map((value, j) => (value - x0[j]) / h - v[j]);
  };
}

interface Trial {
  readonly x0: Float64Array;
  readonly x: Float64Array;
  readonly v: Float64Array;
  readonly h: number;
  /** γβ and γm/h² of each point. */
  readonly u: Float64Array;
  readonly weights: Float64Array;
}

/** F − γm/h² (I + γ²ββᵀ)(x − xₙ − hv) */
function missing(system: System, { x0, x, v, h, u, weights }: Trial): Float64Array {
  const b = new Float64Array(x.length);
  forceAt(system, x, b);
  addMagnetic(system, v, b);
  for (let i = 0, j = 0; i < weights.length; i++, j += 3) {
    const d = [0, 1, 2].map((k) => x[j + k] - x0[j + k] - h * v[j + k]);
    const along = d[0] * u[j] + d[1] * u[j + 1] + d[2] * u[j + 2];
    for (let k = 0; k < 3; k++) b[j + k] = system.pinned[i] ? 0 : b[j + k] - weights[i] * (d[k] + along * u[j + k]);
  }
  return b;
}

/** How the documents’ methods begin: Δv of a step from places and velocities. */
type Change = (x: Float64Array, v: Float64Array, h: number) => Float64Array;

function method(id: string, correction: Correction, begin: (system: System) => Change): Method {
  return {
    id: `${id}-${correction}`,
    order: 1,
    bounded: id === 'semi-implicit-euler',
    begin: (system) => new OfSources(system, correction, begin(system)),
  };
}

class OfSources implements Stepper {
  private readonly system: System;
  private readonly correction: Correction;
  private readonly change: Change;
  private readonly v: Float64Array;

  constructor(system: System, correction: Correction, change: Change) {
    this.system = system;
    this.correction = correction;
    this.change = change;
    this.v = new Float64Array(3 * system.masses.length);
  }

  step(state: State, h: number): void {
    const { system, v } = this;
    velocities(system, state.p, v);
    const before = potentialEnergy(system, state.x);
    const dv = this.change(state.x, v, h);
    for (let j = 0; j < v.length; j++) state.x[j] += h * (v[j] + dv[j]);
    const share = correctedShare(this.correction, system, v, dv, before - potentialEnergy(system, state.x));
    for (let j = 0; j < v.length; j++) v[j] += share * dv[j];
    state.p.set(this.momenta());
    state.t += h;
  }

  private momenta(): Float64Array {
    try {
      return momenta(this.system, this.v);
    } catch (error) {
      if (error instanceof SystemError)
        throw new StepFailure('light', `${error.message}; take a smaller step`, error.point);
      throw error;
    }
  }
}

/** h (F − (F·β)β)/γm */
function accelerated({ c, masses, pinned }: System, v: Float64Array, force: Float64Array, h: number): Float64Array {
  const dv = new Float64Array(v.length);
  for (let i = 0, j = 0; i < masses.length; i++, j += 3) {
    if (pinned[i]) continue;
    const square = (v[j] * v[j] + v[j + 1] * v[j + 1] + v[j + 2] * v[j + 2]) / (c * c);
    const along = (v[j] * force[j] + v[j + 1] * force[j + 1] + v[j + 2] * force[j + 2]) / (c * c);
    const s = (h * Math.sqrt(1 - square)) / masses[i];
    for (let k = j; k < j + 3; k++) dv[k] = s * (force[k] - along * v[k]);
  }
  return dv;
}

/** force += q v × B */
function addMagnetic({ charges, magneticField: B }: System, v: Float64Array, force: Float64Array): void {
  if (!charges || !B) return;
  for (let i = 0, j = 0; i < charges.length; i++, j += 3) {
    force[j] += charges[i] * (v[j + 1] * B[2] - v[j + 2] * B[1]);
    force[j + 1] += charges[i] * (v[j + 2] * B[0] - v[j] * B[2]);
    force[j + 2] += charges[i] * (v[j] * B[1] - v[j + 1] * B[0]);
  }
}

/** γβ and γm/h² of each point. */
function inertia({ c, masses }: System, v: Float64Array, h: number): Pick<Trial, 'u' | 'weights'> {
  const u = new Float64Array(v.length);
  const weights = new Float64Array(masses.length);
  for (let i = 0, j = 0; i < masses.length; i++, j += 3) {
    const gamma = 1 / Math.sqrt(1 - (v[j] * v[j] + v[j + 1] * v[j + 1] + v[j + 2] * v[j + 2]) / (c * c));
    weights[i] = (gamma * masses[i]) / (h * h);
    for (let k = j; k < j + 3; k++) u[k] = (gamma * v[k]) / c;
  }
  return { u, weights };
}
