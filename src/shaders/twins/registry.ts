import { colorTwins } from './color.ts';
import { emissionTwins } from './emission.ts';
import { kinematicsTwins } from './kinematics.ts';
import { shallowConeTwins } from './shallowCone.ts';
import { simultaneityTwins } from './simultaneity.ts';
import { spectrumTwins } from './spectrum.ts';
import type { Twin } from './twin.ts';

/**
 * Every shader function with its f64 counterpart, the inputs on which both are compared, and the tolerances.
 * tests/gpu/twins/twins.test.ts runs it on WebGPU and WebGL2 and fails where a function of this folder is missing from it.
 */
export const twinRegistry: readonly Twin[] = [
  ...kinematicsTwins,
  ...emissionTwins,
  ...simultaneityTwins,
  ...shallowConeTwins,
  ...colorTwins,
  ...spectrumTwins,
];
