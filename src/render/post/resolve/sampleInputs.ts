import type { Node, RenderTarget, Texture } from 'three/webgpu';
import type { GBuffer } from '../../gbuffer/gbuffer.ts';
import type { FrameUniforms } from '../../gpu/frameUniforms.ts';

/** Runs the pass of a name, created when it is first needed. */
export type RunPass = (name: string, output: () => Node, target: RenderTarget | null) => void;

/** What samples are made into a picture of. */
export interface SampleInputs {
  /** Light of the last sample. */
  readonly light: () => Texture;
  readonly buffer: GBuffer;
  readonly uniforms: FrameUniforms;
  readonly runPass: RunPass;
}
