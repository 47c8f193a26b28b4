import { Fn, uniform } from 'three/tsl';
import { type RenderTarget, type Texture, type TextureDataType, Vector4, type WebGPURenderer } from 'three/webgpu';
import { clampEffectArguments, type EffectId, type FogColor, type MixMode } from '../../scene/frameGraph/effects.ts';
import type { ShaderProgram } from '../../scene/shaderText/program.ts';
import { dataTarget } from '../gbuffer/gbuffer.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { FullScreenPass } from '../gpu/fullScreenPass.ts';
import type { Effect, EffectStep } from './effect.ts';
import { EffectContext, EffectImage, type GBufferTextures, mixExact } from './effectContext.ts';
import { effectLibrary } from './effectLibrary.ts';
import { mixImages } from './mix.ts';
import { compileShaderText } from './shaderText.ts';

/** What the passes of an effect read. */
export interface PassInputs {
  readonly image: Texture;
  readonly buffer?: GBufferTextures;
  /** What `image2` of a user's text reads. */
  readonly second?: Texture;
  /** Its first channel is the weight of the effect, 0 … 1. */
  readonly mask?: Texture;
  readonly uniforms: FrameUniforms;
  /** Type of the intermediate targets. */
  readonly type: TextureDataType;
}

/** What may change with every picture. */
export interface EffectValues {
  readonly args: readonly number[];
  /** Absent: the effect's own. */
  readonly fogColor?: FogColor;
}

interface CompiledStep {
  readonly downscale: number;
  readonly pass: FullScreenPass;
  /** undefined: the target that is passed to `render`. */
  readonly target: RenderTarget | undefined;
}

/** The passes of one effect, compiled once; its arguments may change with every picture. */
export class EffectPasses {
  private readonly passes: readonly CompiledStep[];
  private readonly args = uniform(new Vector4());
  private readonly fog = uniform(new Vector4());
  private readonly time = uniform(0);
  /** undefined for effects whose arguments have no ranges. */
  private readonly id: EffectId | undefined;

  /** An effect of the library, or a user's shader program. */
  static forEffect(effect: EffectId | ShaderProgram, inputs: PassInputs): EffectPasses {
    return typeof effect === 'string'
      ? new EffectPasses(effect, effectLibrary[effect], inputs, effect)
      : new EffectPasses('written', compileShaderText(effect), inputs);
  }

  /** Blends two pictures; the only argument is alpha. `image` is below, `over` above. */
  static forMix(mode: MixMode, over: Texture, inputs: PassInputs): EffectPasses {
    const { mask } = inputs;
    const color: EffectStep['color'] = (frame) =>
      mixImages(frame, mode, frame.args[0], new EffectImage(over), mask && new EffectImage(mask));
    return new EffectPasses(`mix ${mode}`, [{ name: 'result', downscale: 1, color }], { ...inputs, mask: undefined });
  }

  private constructor(name: string, effect: Effect, inputs: PassInputs, id?: EffectId) {
    const { mask, type } = inputs;
    this.id = id;
    const stepImages = new Map<string, Texture>();
    this.passes = effect.map((step, i) => {
      const last = i === effect.length - 1;
      const previousImages = new Map(stepImages);
      const sources = { ...inputs, args: this.args, fog: this.fog, time: this.time };
      const color = last && mask ? masked(step, mask) : step.color;
      const output = Fn(() => color(new EffectContext(sources, previousImages)))();
      const target = last ? undefined : dataTarget(1, type);
      if (target) stepImages.set(step.name, target.texture);
      return { downscale: step.downscale, pass: new FullScreenPass(output, `${name} ${step.name}`), target };
    });
  }

  setSize(width: number, height: number): void {
    for (const { target, downscale } of this.passes)
      target?.setSize(Math.ceil(width / downscale), Math.ceil(height / downscale));
  }

  /** Renders into `target`, which must not be read by the effect. `time`: world time of the observer [s]. */
  render(renderer: WebGPURenderer, target: RenderTarget, { args, fogColor }: EffectValues, time = 0): void {
    const [x = 0, y = 0, z = 0, w = 0] = this.id ? clampEffectArguments(this.id, args) : args;
    this.args.value.set(x, y, z, w);
    if (typeof fogColor === 'object') this.fog.value.set(...fogColor, 2);
    else this.fog.value.set(0, 0, 0, fogColor === 'sky' ? 1 : 0);
    this.time.value = time;
    for (const step of this.passes) step.pass.render(renderer, step.target ?? target);
  }

  dispose(): void {
    for (const { pass, target } of this.passes) {
      pass.dispose();
      target?.dispose();
    }
  }
}

/** A step's colours where the mask is 1, the picture's where it is 0. */
const masked =
  ({ color }: EffectStep, mask: Texture): EffectStep['color'] =>
  (frame) => {
    const weight = new EffectImage(mask).at(frame.pixel).x.clamp(0, 1).toVar();
    return mixExact(frame.image.at(frame.pixel), color(frame), weight);
  };
