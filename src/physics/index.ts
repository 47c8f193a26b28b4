export { aberrate, unaberrate } from './aberration.ts';
export { apparentPosition, apparentPositions, inverseApparentPosition } from './apparent.ts';
export {
  boost,
  boostMatrix,
  carry,
  gamma,
  inverseBoost,
  oneMinusSquare,
  properVelocity,
  rapidity,
  velocity,
} from './boost.ts';
export {
  type CubicPiece,
  controlVelocities,
  cubicAt,
  cubicCrossing,
  cubicEmission,
  eased,
  slowBend,
} from './cubic.ts';
export {
  apparentSpeedAcross,
  dopplerAtPixel,
  dopplerFactor,
  dopplerFactors,
  emitterDoppler,
  observerDoppler,
  observerDopplers,
} from './doppler.ts';
export {
  circularEmission,
  hyperbolicEmission,
  polylineEmission,
  presentEmission,
  type Seen,
  staticEmission,
  uniformEmission,
} from './emission.ts';
export { type FourVector, fourVector, interval, minkowskiDot, spatial } from './fourVector.ts';
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
} from './lightCone.ts';
export { accelerate, coast, type ObserverState } from './observer.ts';
export {
  applyLorentz,
  applyPoincare,
  composePoincare,
  frameAt,
  inverseLorentz,
  invertPoincare,
  POINCARE_IDENTITY,
  type Poincare,
} from './poincare.ts';
export {
  blackbodyTemperature,
  bolometricRadiance,
  observedFrequency,
  observedSolidAngle,
  observedWavelength,
  radiancePerFrequency,
  radiancePerWavelength,
} from './radiance.ts';
export {
  circularSlice,
  contraction,
  hyperbolicSlice,
  type Slice,
  simultaneitySlice,
  simultaneousPosition,
  simultaneousPositions,
  simultaneousTime,
  simultaneousTimes,
  uniformSlice,
} from './simultaneity.ts';
export { addVelocities, fourAcceleration, relativeVelocity, wignerRotation } from './velocity.ts';
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
} from './worldLine.ts';
