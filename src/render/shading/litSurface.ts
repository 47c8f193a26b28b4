import type { Float, Vec3 } from '../../shaders/types.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import type { RestFrame } from '../lights/restFrame.ts';
import type { Brdf } from './brdf.ts';

/** A surface that a lamp shines on: `dx` observer → surface [m] and `time` after his [m of light], world. */
export interface LitSurface {
  readonly brdf: Brdf;
  readonly dx: Vec3;
  readonly time: Float;
  readonly rest: RestFrame;
  readonly uniforms: FrameUniforms;
}
