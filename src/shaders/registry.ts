import { colour } from './twins/colour.ts';
import { emission } from './twins/emission.ts';
import { seeing } from './twins/seeing.ts';
import { slice } from './twins/slice.ts';
import { spectrumTwins } from './twins/spectrum.ts';
import type { Twin } from './twins/twin.ts';

/**
 * Every shader function with its f64 equal, the inputs on which both are compared, and how equal they must be.
 * tests/gpu/twins.test.ts runs it on WebGPU and WebGL2 and fails where a function of this folder is missing from it.
 */
export const registry: readonly Twin[] = [...seeing, ...emission, ...slice, ...colour, ...spectrumTwins];
