import type { Float, Vec3 } from '../../../shaders/types.ts';
import type { BrdfNodes } from '../../brdf/brdf.ts';
import type { FrameUniforms } from '../../gpu/frameUniforms.ts';
import type { RestFrameNodes } from '../restFrame.ts';

/** A surface that a local light shines on: `dx` observer → surface [m] and `time` after his [m of light], world. */
export interface LitSurface {
  readonly brdf: BrdfNodes;
  readonly dx: Vec3;
  readonly time: Float;
  readonly rest: RestFrameNodes;
  readonly uniforms: FrameUniforms;
}
