export { Bookkeeper, type Books, booksCsv } from './books.ts';
export { type Ledger, ledger } from './energy.ts';
export { barrier } from './forces/barrier.ts';
export { type Ball, ballContacts, CONTACT, type Contact, Penalty } from './forces/contact.ts';
export { COULOMB, coulomb } from './forces/coulomb.ts';
export type { Force, PlainForce, Stiffness, StiffnessForm } from './forces/force.ts';
export { NearPairs } from './forces/near.ts';
export { box, type Obstacle, plane } from './forces/obstacle.ts';
export { type PairLaw, Pairs } from './forces/pairs.ts';
export { type Springs, springs } from './forces/springs.ts';
export { uniform } from './forces/uniform.ts';
export { METHODS } from './methods/library.ts';
export { type Failure, type Method, StepFailure, type Stepper } from './methods/method.ts';
export { type Faces, meshSprings, type NetStiffness } from './nets.ts';
export { type Frame, type Order, run, type Steps, type Stop, stepsOf } from './run.ts';
export { fastestOscillation } from './stability.ts';
export {
  copyOf,
  makeSystem,
  momenta,
  restingAt,
  type State,
  type System,
  SystemError,
  velocities,
} from './system.ts';
