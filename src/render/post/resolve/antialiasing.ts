import { texture } from 'three/tsl';
import { FloatType, LinearFilter, type RenderTarget, UnsignedByteType } from 'three/webgpu';
import type { RenderSettings } from '../../../scene/view/view.ts';
import type { Vec4 } from '../../../shaders/types.ts';
import { dataTarget } from '../../gbuffer/gbuffer.ts';
import type { SpacetimeProjection } from '../../geometry/vertexStage.ts';
import {
  accumulatedSample,
  antialiased,
  type DisplaySettings,
  displayKey,
  sampleMean,
  singleSample,
  unfiltered,
} from '../display/display.ts';
import type { ViewState } from './previousView.ts';
import type { SampleInputs } from './sampleInputs.ts';
import type { TemporalHistory } from './temporalHistory.ts';

type AntialiasingSettings = DisplaySettings & Pick<RenderSettings, 'antialiasing'>;

/** Inputs of the antialiasing modes. */
export interface AntialiasingInputs extends SampleInputs {
  /** Makes the history of temporal antialiasing, with the first picture that is blended. */
  readonly makeHistory: (inputs: SampleInputs) => TemporalHistory;
}

/** How a picture is made of samples: one without filtering, one with FXAA, the mean of many, or one blended with the history (temporal antialiasing). */
export type AntialiasingMode = 'none' | 'fxaa' | 'mean' | 'temporal';

/** Resolves samples of light into an antialiased picture. */
export class Antialiasing {
  private readonly inputs: AntialiasingInputs;
  private readonly single = filteredTarget();
  private readonly sums = [sumTarget(), sumTarget()] as const;
  private temporal: TemporalHistory | undefined;
  /** Index of the sum that was written last. */
  private sum = 0;
  /** Texture nodes of ping-pong targets, set before each pass. */
  private readonly picture = texture(this.sums[0].textures[0]);
  private readonly light = texture(this.sums[0].textures[1]);
  private readonly mean = texture(this.sums[0].textures[0]);
  private mode: AntialiasingMode = 'none';

  constructor(inputs: AntialiasingInputs) {
    this.inputs = inputs;
  }

  setSize(width: number, height: number): void {
    for (const target of this.targets) target.setSize(width, height);
    this.temporal?.setSize(width, height);
  }

  /** The next picture will not be blended with previous ones. */
  resetHistory(): void {
    this.temporal?.reset();
  }

  /** Resolves a picture of one sample. */
  resolveSingle(settings: AntialiasingSettings): void {
    this.drawSingle(settings);
    this.mode = settings.antialiasing ? 'fxaa' : 'none';
    this.temporal?.reset();
  }

  /** Adds sample `index` of `count`; the previous picture stays until `shown` is true. */
  addSample(index: number, count: number, settings: AntialiasingSettings, shown: boolean): void {
    const { uniforms } = this.inputs;
    uniforms.weight.value = 1 / count;
    uniforms.firstSample.value = index === 0 ? 1 : 0;
    this.sum = index % 2;
    this.accumulate(settings);
    if (shown) this.mode = 'mean';
  }

  /** Resolves a picture of one sample, blended with the history. */
  resolveTemporal(settings: AntialiasingSettings, state: ViewState): void {
    this.history().resolve(settings, state);
    this.mode = 'temporal';
  }

  present(target: RenderTarget | null): void {
    this.show(this.mode, target);
  }

  /** Runs the passes of a mode, and those of accumulation, without changing mode or history. */
  runPasses(
    mode: AntialiasingMode,
    settings: AntialiasingSettings,
    projection: SpacetimeProjection,
    target: RenderTarget | null,
  ): void {
    if (mode === 'none' || mode === 'fxaa') this.drawSingle(settings);
    if (mode === 'temporal') this.history().blend(settings, projection);
    if (settings.antialiasing || mode === 'mean') this.accumulate(settings);
    for (const each of settings.antialiasing ? [mode, 'mean' as const] : [mode]) this.show(each, target);
  }

  /** The mean of the samples' light, once all samples are added. */
  get lightMean(): { readonly target: RenderTarget; readonly index: number } {
    return { target: this.sums[this.sum], index: 1 };
  }

  dispose(): void {
    for (const target of this.targets) target.dispose();
    this.temporal?.dispose();
  }

  private history(): TemporalHistory {
    if (this.temporal) return this.temporal;
    this.temporal = this.inputs.makeHistory(this.inputs);
    this.temporal.setSize(this.single.width, this.single.height);
    return this.temporal;
  }

  private drawSingle(settings: AntialiasingSettings): void {
    const { buffer, uniforms, runPass: run } = this.inputs;
    const light = this.inputs.light();
    run(
      `single ${light.id} ${displayKey(settings)}`,
      () => singleSample(light, buffer, uniforms, settings),
      this.single,
    );
  }

  /** Writes the last sum plus the weighted sample. */
  private accumulate(settings: AntialiasingSettings): void {
    const { buffer, uniforms, runPass: run } = this.inputs;
    const light = this.inputs.light();
    const { picture, light: sum } = this;
    [picture.value, sum.value] = this.sums[1 - this.sum].textures;
    const previous = { picture, light: sum };
    run(
      `add ${light.id} ${displayKey(settings)}`,
      () => accumulatedSample(light, previous, buffer, uniforms, settings),
      this.sums[this.sum],
    );
  }

  private show(mode: AntialiasingMode, target: RenderTarget | null): void {
    const { single, mean, temporal } = this;
    const { runPass: run } = this.inputs;
    mean.value = this.sums[this.sum].textures[0];
    temporal?.bind();
    const passes: Record<AntialiasingMode, () => Vec4> = {
      none: () => unfiltered(single.texture),
      fxaa: () => antialiased(single.texture),
      mean: () => sampleMean(mean),
      temporal: () => this.history().shown(),
    };
    run(`show ${mode}`, passes[mode], target);
  }

  private get targets(): readonly RenderTarget[] {
    return [this.single, ...this.sums];
  }
}

function filteredTarget(): RenderTarget {
  const target = dataTarget(1, UnsignedByteType);
  target.texture.minFilter = LinearFilter;
  target.texture.magFilter = LinearFilter;
  return target;
}

function sumTarget(): RenderTarget {
  const target = dataTarget(2, FloatType);
  ['picture', 'light'].forEach((name, i) => {
    target.textures[i].name = name;
  });
  return target;
}
