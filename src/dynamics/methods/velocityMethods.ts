import { msg } from '../../messages/message.ts';
import { kineticEnergy, potentialEnergy } from '../energy.ts';
import type { Stiffness, StiffnessForm } from '../forces/force.ts';
import { ConjugateGradients } from '../linear/conjugateGradients.ts';
import { StepMatrix } from '../linear/stepMatrix.ts';
import { momenta, pointAt, type State, type System, SystemError, velocities } from '../system.ts';
import { type EnergyCorrection, momentumFactor, velocityChangeFraction } from './energyCorrection.ts';
import { type IntegrationMethod, potentialForces, StepFailure, type Stepper } from './method.ts';

/* The methods of the source documents (docs/physics.md §14), for comparison: their state are velocities, forces become accelerations by (I
   − ββᵀ)/γm at the velocity before the step, and nothing keeps them below c. Their energy is corrected after each step
   (energyCorrection.ts). */

/** v += h a(x, v), x += h v */
export const semiImplicitEuler = (correction: EnergyCorrection): IntegrationMethod =>
  velocityMethod('semi-implicit-euler', correction, (system) => {
    const force = new Float64Array(3 * system.masses.length);
    return (x, v, h) => {
      potentialForces(system, x, force);
      addMagneticForce(system, v, force);
      return accelerationStep(system, v, force, h);
    };
  });

/** Implicit Euler with a single Newton iteration. */
export const linearlyImplicit = (correction: EnergyCorrection): IntegrationMethod =>
  velocityMethod('linearly-implicit', correction, (system) => implicitChange(system, 1, 'exact'));

/**
 * Local–global iteration: springs pull towards fixed positions, which then rotate with them; the spring part of the
 * global linear system is constant.
 */
export const localGlobal = (correction: EnergyCorrection): IntegrationMethod =>
  velocityMethod('local-global', correction, (system) => implicitChange(system, 10, 'isotropic'));

/**
 * Positions after a step by γm/h² (I + γ²ββᵀ)(x − xₙ − hv) = F(x), the documents’ equation times (I − ββᵀ)⁻¹, which
 * makes it symmetric: iterations of [γm/h² (I + γ²ββᵀ) + K] δ = F − γm/h² (I + γ²ββᵀ)(x − xₙ − hv), with K a form of
 * ∇²V.
 */
function implicitChange(system: System, rounds: number, form: StiffnessForm): VelocityChange {
  const linear = new ConjugateGradients(3 * system.masses.length);
  const matrix = new StepMatrix(system.pinned);
  let stiffnesses: Stiffness[] = [];
  return (x0, v, h) => {
    const { u, weights } = pointInertia(system, v, h);
    // Pinned points continue at their prescribed velocity.
    const x = x0.map((value, j) => (system.pinned[Math.floor(j / 3)] ? value + h * v[j] : value));
    for (let round = 0; round < rounds; round++) {
      const b = stepResidual(system, { x0, x, v, h, u, weights });
      stiffnesses = system.forces.map((each, k) => each.stiffness(x, form, stiffnesses[k]));
      matrix.set(stiffnesses, weights, u);
      const dx = new Float64Array(x.length);
      const { indefinite } = linear.solve(matrix, b, dx, 1e-10, 1000);
      if (indefinite)
        throw new StepFailure('indefinite', msg`the matrix of the step is not positive definite; take a smaller step`);
      for (let j = 0; j < x.length; j++) x[j] += dx[j];
    }
    return x.map((value, j) => (value - x0[j]) / h - v[j]);
  };
}

interface TrialStep {
  readonly x0: Float64Array;
  readonly x: Float64Array;
  readonly v: Float64Array;
  readonly h: number;
  /** γβ and γm/h² of each point. */
  readonly u: Float64Array;
  readonly weights: Float64Array;
}

/** F − γm/h² (I + γ²ββᵀ)(x − xₙ − hv) */
function stepResidual(system: System, { x0, x, v, h, u, weights }: TrialStep): Float64Array {
  const b = new Float64Array(x.length);
  potentialForces(system, x, b);
  addMagneticForce(system, v, b);
  for (let i = 0, j = 0; i < weights.length; i++, j += 3) {
    const d = [0, 1, 2].map((k) => x[j + k] - x0[j + k] - h * v[j + k]);
    const along = d[0] * u[j] + d[1] * u[j + 1] + d[2] * u[j + 2];
    for (let k = 0; k < 3; k++) b[j + k] = system.pinned[i] ? 0 : b[j + k] - weights[i] * (d[k] + along * u[j + k]);
  }
  return b;
}

/** Core of the documents’ methods: Δv of a step from positions and velocities. */
type VelocityChange = (x: Float64Array, v: Float64Array, h: number) => Float64Array;

function velocityMethod(
  id: string,
  correction: EnergyCorrection,
  begin: (system: System) => VelocityChange,
): IntegrationMethod {
  return {
    id: `${id}-${correction}`,
    order: 1,
    conditionallyStable: id === 'semi-implicit-euler',
    begin: (system) => new VelocityStepper(system, correction, begin(system)),
  };
}

class VelocityStepper implements Stepper {
  /** Undefined where the energy is not corrected. */
  corrected: number | undefined;
  private readonly system: System;
  private readonly correction: EnergyCorrection;
  private readonly change: VelocityChange;
  private readonly v: Float64Array;

  constructor(system: System, correction: EnergyCorrection, change: VelocityChange) {
    this.system = system;
    this.correction = correction;
    this.corrected = correction === 0 ? undefined : 0;
    this.change = change;
    this.v = new Float64Array(3 * system.masses.length);
  }

  step(state: State, h: number): void {
    const { system, v, correction } = this;
    const { x, p } = state;
    velocities(system, p, v);
    const potential = potentialEnergy(system, x);
    const kinetic = kineticEnergy(system, p);
    const dv = this.change(x, v, h);
    const held = heldPositions(system, x);
    for (let j = 0; j < v.length; j++) x[j] += h * (v[j] + dv[j]);
    const gain = correction === 0 ? 0 : potential - potentialEnergy(system, held ? held(x) : x);
    const fraction = correction === 1 || correction === 2 ? velocityChangeFraction(correction, system, v, dv, gain) : 1;
    for (let j = 0; j < v.length; j++) v[j] += fraction * dv[j];
    p.set(this.momenta());
    const factor =
      correction === 3 ? momentumFactor(system, p, kinetic + gain, Math.abs(potential) + Math.abs(gain) + kinetic) : 1;
    for (let j = 0; j < p.length; j++) p[j] *= factor;
    if (this.corrected !== undefined && (fraction !== 1 || factor !== 1)) this.corrected++;
    state.t += h;
  }

  private momenta(): Float64Array {
    try {
      return momenta(this.system, this.v);
    } catch (error) {
      if (error instanceof SystemError)
        throw new StepFailure('light', msg`${error.text}; take a smaller step`, error.point);
      throw error;
    }
  }
}

/**
 * Where there are kinematic points: a function that returns positions with these where they are now, since the energy
 * that their motion adds is not the method's error.
 */
function heldPositions({ kinematic }: System, now: Float64Array): ((x: Float64Array) => Float64Array) | undefined {
  if (!kinematic) return undefined;
  const at = kinematic.map(({ point }) => pointAt(now, point));
  return (x) => {
    const held = x.slice();
    kinematic.forEach(({ point }, i) => {
      held.set(at[i], 3 * point);
    });
    return held;
  };
}

/** h (F − (F·β)β)/γm */
function accelerationStep(
  { c, masses, pinned }: System,
  v: Float64Array,
  force: Float64Array,
  h: number,
): Float64Array {
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
function addMagneticForce({ charges, magneticField: B }: System, v: Float64Array, force: Float64Array): void {
  if (!charges || !B) return;
  for (let i = 0, j = 0; i < charges.length; i++, j += 3) {
    force[j] += charges[i] * (v[j + 1] * B[2] - v[j + 2] * B[1]);
    force[j + 1] += charges[i] * (v[j + 2] * B[0] - v[j] * B[2]);
    force[j + 2] += charges[i] * (v[j] * B[1] - v[j + 1] * B[0]);
  }
}

/** γβ and γm/h² of each point. */
function pointInertia({ c, masses }: System, v: Float64Array, h: number): Pick<TrialStep, 'u' | 'weights'> {
  const u = new Float64Array(v.length);
  const weights = new Float64Array(masses.length);
  for (let i = 0, j = 0; i < masses.length; i++, j += 3) {
    const gamma = 1 / Math.sqrt(1 - (v[j] * v[j] + v[j + 1] * v[j + 1] + v[j + 2] * v[j + 2]) / (c * c));
    weights[i] = (gamma * masses[i]) / (h * h);
    for (let k = j; k < j + 3; k++) u[k] = (gamma * v[k]) / c;
  }
  return { u, weights };
}
