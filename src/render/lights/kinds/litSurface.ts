import type { Float, Int, Vec3 } from '../../../shaders/types.ts';
import type { BrdfNodes } from '../../brdf/brdf.ts';
import type { FrameUniforms } from '../../gpu/frameUniforms.ts';
import type { LightAtEmission } from '../lightAtEmission.ts';
import type { LightTexels } from '../lightTexels.ts';
import type { RestFrameNodes } from '../restFrame.ts';

/** A surface event that lights shine on: `dx` observer → event [m] and `time` after the observer's [m of light], world. */
export interface LitSurface {
  readonly brdf: BrdfNodes;
  readonly dx: Vec3;
  readonly time: Float;
  readonly rest: RestFrameNodes;
  /** Fraction of the sky's light that its own fine structure leaves. */
  readonly occlusion: Float;
  /** Fraction of the sky that nothing hides, weighted by the cosine (occlusion/); absent: all of it. */
  readonly openness?: Float;
  readonly uniforms: FrameUniforms;
  /** Absent where nothing casts shadows. */
  readonly visibility?: SurfaceVisibility;
}

/** The fraction of a light that reaches the surface past what occludes it; undefined: all of it. */
export interface SurfaceVisibility {
  /** `index`: in the table of distant lights; undefined if it is not known before the shader runs. */
  ofDistantLight(index: number | undefined): Float | undefined;
  /** `slot`: among the local lights that cast shadows; undefined if it casts none. */
  ofLocalLight(slot: Int | number | undefined, light: LightTexels, emitter: LightAtEmission): Float | undefined;
}
