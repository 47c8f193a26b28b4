/**
 * Special relativity: boosts, aberration, Doppler factors, world lines, the past light cone and simultaneity.
 * Velocities are proper velocities u = γβ in units of c, in the world frame, unless a function says otherwise; its
 * formulas, with sources, are in docs/physics.md.
 *
 * @module slowlight/physics
 */

export {
  boost,
  boostMatrix,
  gamma,
  inverseBoost,
  inverseBoostSpatial,
  oneMinusBetaSquared,
  properVelocity,
  rapidity,
  velocity,
} from './lorentz/boost.ts';
export { type FourVector, fourVector, interval, minkowskiDot, spatial } from './lorentz/fourVector.ts';
export { accelerate, coast, type ObserverState } from './lorentz/observer.ts';
export {
  applyLorentz,
  applyPoincare,
  composePoincare,
  frameAt,
  inverseLorentz,
  invertPoincare,
  POINCARE_IDENTITY,
  type Poincare,
} from './lorentz/poincare.ts';
export { addVelocities, fourAcceleration, relativeVelocity, wignerRotation } from './lorentz/velocity.ts';
export { aberrate, terrellRotation, unaberrate } from './optics/aberration.ts';
export { apparentPosition, apparentPositions, inverseApparentPosition } from './optics/apparentPosition.ts';
export {
  apparentRadialSpeed,
  apparentSpeedAcross,
  dopplerAtPixel,
  dopplerFactor,
  dopplerFactors,
  emitterDoppler,
  observerDoppler,
  observerDopplers,
} from './optics/doppler.ts';
export {
  blackbodyTemperature,
  bolometricRadiance,
  observedFrequency,
  observedSolidAngle,
  observedWavelength,
  radiancePerFrequency,
  radiancePerWavelength,
} from './optics/radiance.ts';
export {
  circularEmission,
  hyperbolicEmission,
  polylineEmission,
  type RetardedEvent,
  staticEmission,
  uniformEmission,
} from './worldLines/emission.ts';
export type { CircularLine } from './worldLines/kinds/circularLine.ts';
export type { CubicLine } from './worldLines/kinds/cubicLine.ts';
export type { HyperbolicLine } from './worldLines/kinds/hyperbolicLine.ts';
export type { PolylineLine } from './worldLines/kinds/polylineLine.ts';
export type { StaticLine } from './worldLines/kinds/staticLine.ts';
export type { UniformLine } from './worldLines/kinds/uniformLine.ts';
export type { ObserverEvent } from './worldLines/kinds/worldLineKind.ts';
export {
  type EmissionEvent,
  emissionEvent,
  emissionOffsets,
  emissionTime,
  emissionTimes,
  type NewtonOptions,
  newtonEmissionTime,
  pastLightCone,
} from './worldLines/lightCone.ts';
export { properTimeBetween } from './worldLines/properTime.ts';
export type { SampledLine } from './worldLines/samples.ts';
export {
  contraction,
  newtonSimultaneousTime,
  simultaneitySlice,
  simultaneousPosition,
  simultaneousPositions,
  simultaneousTime,
  simultaneousTimes,
} from './worldLines/simultaneity.ts';
export { circularSlice, hyperbolicSlice, type SimultaneousEvent, uniformSlice } from './worldLines/slice.ts';
export { positionAt, velocityAt, type WorldLine } from './worldLines/worldLine.ts';
