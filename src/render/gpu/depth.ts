import { length, log2 } from 'three/tsl';
import type { Float, Vec3 } from '../../shaders/types.ts';

/** Clip planes [m]. Reversed 32-bit float depth resolves 1e-6 of the distance from one to the other. */
export const NEAR = 1e-3;
export const FAR = 1e9;

/**
 * Depth if the buffer cannot be reversed (WebGL2 without EXT_clip_control): log(r/NEAR)/log(FAR/NEAR) of the distance r = |cameraPosition| [m], which resolves 2e-6 of
 * it. Written per fragment, which disables the GPU's early depth test: a fallback only.
 */
export const logarithmicDepth = (cameraPosition: Vec3): Float => logarithmicDepthOf(length(cameraPosition));

/** The same of a distance [m]. */
export const logarithmicDepthOf = (distance: Float): Float => log2(distance.div(NEAR)).div(Math.log2(FAR / NEAR));
