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
export { aberrate, unaberrate } from './optics/aberration.ts';
export { apparentPosition, apparentPositions, inverseApparentPosition } from './optics/apparentPosition.ts';
export {
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
  type CubicPiece,
  controlVelocities,
  cubicAt,
  cubicCrossing,
  cubicEmission,
  subluminalBend,
  withBend,
} from './worldLines/cubicPiece.ts';
export {
  circularEmission,
  hyperbolicEmission,
  polylineEmission,
  presentEmission,
  type RetardedEvent,
  staticEmission,
  uniformEmission,
} from './worldLines/emission.ts';
export {
  type EmissionEvent,
  emissionEvent,
  emissionOffsets,
  emissionTime,
  emissionTimes,
  type NewtonOptions,
  newtonEmissionTime,
  type ObserverEvent,
  pastLightCone,
} from './worldLines/lightCone.ts';
export {
  circularSlice,
  contraction,
  hyperbolicSlice,
  type SimultaneousEvent,
  simultaneitySlice,
  simultaneousPosition,
  simultaneousPositions,
  simultaneousTime,
  simultaneousTimes,
  uniformSlice,
} from './worldLines/simultaneity.ts';
export {
  type CircularLine,
  type CubicLine,
  circleAt,
  cubicPiece,
  type HyperbolicLine,
  type PolylineLine,
  positionAt,
  restsOutsideSamples,
  type StaticLine,
  samplePosition,
  samplesUntil,
  type UniformLine,
  velocityAt,
  type WorldLine,
} from './worldLines/worldLine.ts';
