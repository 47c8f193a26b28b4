import { Fn, uniform } from 'three/tsl';
import { type RenderTarget, type Texture, type TextureDataType, Vector4, type WebGPURenderer } from 'three/webgpu';
import { argumentsOf, type EffectId, type MixMode } from '../../scene/effects.ts';
import type { Program } from '../../scene/shaderText/program.ts';
import { FullScreen } from '../fullScreen.ts';
import { dataTarget } from '../targets.ts';
import type { Uniforms } from '../uniforms.ts';
import type { Effect, Step } from './effect.ts';
import { between, Frame, Picture, type SurfaceTextures } from './frame.ts';
import { effectLibrary } from './library.ts';
import { mixed } from './mix.ts';
import { written } from './shaderText.ts';

/** What passes over a picture read. */
export interface PassInputs {
  readonly image: Texture;
  readonly buffer?: SurfaceTextures;
  /** Its first channel tells how much of the effect is to be seen, 0 … 1. */
  readonly mask?: Texture;
  readonly uniforms: Uniforms;
  /** Of the targets on the way. */
  readonly type: TextureDataType;
}

interface Pass {
  readonly shrink: number;
  readonly pass: FullScreen;
  /** Undefined: into the target that is asked for. */
  readonly target: RenderTarget | undefined;
}

/** The passes of one effect, compiled once; its numbers may change with every picture. */
export class EffectPasses {
  private readonly passes: readonly Pass[];
  private readonly args = uniform(new Vector4());
  private readonly time = uniform(0);
  /** Undefined: its numbers have no ranges. */
  private readonly id: EffectId | undefined;

  /** An effect of the library, or one that somebody wrote. */
  static of(effect: EffectId | Program, inputs: PassInputs): EffectPasses {
    return typeof effect === 'string'
      ? new EffectPasses(effect, effectLibrary[effect], inputs, effect)
      : new EffectPasses('written', written(effect), inputs);
  }

  /** Two pictures into one; its only number is alpha. `image` is below. */
  static mixing(mode: MixMode, over: Texture, inputs: PassInputs): EffectPasses {
    const { mask } = inputs;
    const color: Step['color'] = (frame) =>
      mixed(frame, mode, frame.args[0], new Picture(over), mask && new Picture(mask));
    return new EffectPasses(`mix ${mode}`, [{ name: 'result', shrink: 1, color }], { ...inputs, mask: undefined });
  }

  private constructor(name: string, effect: Effect, inputs: PassInputs, id?: EffectId) {
    const { mask, type } = inputs;
    this.id = id;
    const made = new Map<string, Texture>();
    this.passes = effect.map((step, i) => {
      const last = i === effect.length - 1;
      const before = new Map(made);
      const sources = { ...inputs, args: this.args, time: this.time };
      const color = last && mask ? masked(step, mask) : step.color;
      const output = Fn(() => color(new Frame(sources, before)))();
      const target = last ? undefined : dataTarget(1, type);
      if (target) made.set(step.name, target.texture);
      return { shrink: step.shrink, pass: new FullScreen(output, `${name} ${step.name}`), target };
    });
  }

  setSize(width: number, height: number): void {
    for (const { target, shrink } of this.passes)
      target?.setSize(Math.ceil(width / shrink), Math.ceil(height / shrink));
  }

  /** Into `target`, which must not be what the effect reads. `time`: world time of the observer [s]. */
  render(renderer: WebGPURenderer, target: RenderTarget, args: readonly number[], time = 0): void {
    const [x = 0, y = 0, z = 0, w = 0] = this.id ? argumentsOf(this.id, args) : args;
    this.args.value.set(x, y, z, w);
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
  ({ color }: Step, mask: Texture): Step['color'] =>
  (frame) => {
    const share = new Picture(mask).at(frame.pixel).x.clamp(0, 1).toVar();
    return between(frame.image.at(frame.pixel), color(frame), share);
  };
