/**
 * Relativistic mass–spring systems: forces with a potential, integrators, conserved quantities. World frame, SI units;
 * points one after another, x, y, z each.
 *
 * @module slowlight/dynamics
 */

export { type ConservedQuantities, conservedQuantities } from './energy.ts';
export { barrier } from './forces/barrier.ts';
export {
  type ContactParameters,
  type ContactSphere,
  DEFAULT_CONTACT,
  PenaltyPotential,
  sphereContacts,
} from './forces/contact.ts';
export { COULOMB_CONSTANT, coulomb } from './forces/coulomb.ts';
export type {
  BarrierData,
  Force,
  ForceData,
  NeighborForceData,
  PairForceData,
  Stiffness,
  StiffnessForm,
  UniformFieldData,
} from './forces/force.ts';
export { NeighborPairs } from './forces/neighborPairs.ts';
export { box, type Obstacle, plane } from './forces/obstacle.ts';
export { PairForce, type PairPotential } from './forces/pairs.ts';
export { type Springs, springForce } from './forces/springs.ts';
export { uniformField } from './forces/uniformField.ts';
export { type FaceTopology, type MeshStiffness, meshSprings } from './meshSprings.ts';
export { METHODS } from './methods/library.ts';
export {
  type IntegrationMethod,
  type SplittingWork,
  StepFailure,
  type StepFailureReason,
  type Stepper,
} from './methods/method.ts';
export {
  type EarlyStop,
  integrate,
  type RunOptions,
  type RunTally,
  type SimulationFrame,
  type StepSchedule,
  stepSchedule,
} from './run.ts';
export { type RunRecord, RunRecorder, runRecordCsv } from './runRecord.ts';
export { maxAngularFrequency } from './stability.ts';
export {
  copyState,
  type KinematicPoint,
  makeSystem,
  momenta,
  type State,
  type System,
  SystemError,
  stateAtRest,
  velocities,
} from './system.ts';
export { serveTeam, type TeamTask } from './threads/teamHelper.ts';
export type { TeamThreads } from './threads/threadTeam.ts';
