import { texture } from 'three/tsl';
import {
  FloatType,
  HalfFloatType,
  LinearFilter,
  type Node,
  type RenderTarget,
  type Texture,
  UnsignedByteType,
} from 'three/webgpu';
import type { RenderSettings } from '../../../scene/view/view.ts';
import type { Vec4 } from '../../../shaders/types.ts';
import { dataTarget, type GBuffer } from '../../gbuffer/gbuffer.ts';
import type { SpacetimeProjection } from '../../geometry/vertexStage.ts';
import type { FrameUniforms } from '../../gpu/frameUniforms.ts';
import {
  accumulatedSample,
  antialiased,
  type DisplaySettings as DisplayLook,
  sampleMean,
  singleSample,
  temporalResult,
  temporalSample,
  unfiltered,
} from '../display/display.ts';
import { PreviousView, type ViewState as Seen } from './previousView.ts';
import { ReconstructionFilter, temporalResolve } from './temporalAntialiasing.ts';

type AntialiasingSettings = DisplayLook & Pick<RenderSettings, 'antialiasing'>;

/** Runs the pass of a name, made when it is first asked for. */
export type RunPass = (name: string, output: () => Node, target: RenderTarget | null) => void;

/** What the ways of smoothing read. */
export interface AntialiasingInputs {
  /** Of the sample that was drawn last. */
  readonly light: () => Texture;
  readonly buffer: GBuffer;
  readonly uniforms: FrameUniforms;
  readonly runPass: RunPass;
}

/** How a picture is made of samples: one as it is, one with FXAA, the mean of many, or one blended with the history (temporal antialiasing). */
export type AntialiasingMode = 'none' | 'fxaa' | 'mean' | 'temporal';

/** From samples of light to a picture without steps. */
export class Antialiasing {
  private readonly inputs: AntialiasingInputs;
  private readonly single = filteredTarget();
  private readonly sums = [sumTarget(), sumTarget()] as const;
  private readonly temporalSamples = [dataTarget(1, HalfFloatType), dataTarget(1, HalfFloatType)] as const;
  private readonly histories = [dataTarget(1, HalfFloatType), dataTarget(1, HalfFloatType)] as const;
  private readonly previousView = new PreviousView();
  private readonly filter = new ReconstructionFilter();
  /** Which of two targets was written last. */
  private sum = 0;
  private turn = 0;
  /** What passes read of targets that take turns. */
  private readonly picture = texture(this.sums[0].textures[0]);
  private readonly light = texture(this.sums[0].textures[1]);
  private readonly mean = texture(this.sums[0].textures[0]);
  private readonly now = texture(this.temporalSamples[0].texture);
  private readonly former = texture(this.temporalSamples[0].texture);
  private readonly history = texture(this.histories[0].texture);
  private readonly latest = texture(this.histories[0].texture);
  private mode: AntialiasingMode = 'none';

  constructor(from: AntialiasingInputs) {
    this.inputs = from;
  }

  setSize(width: number, height: number): void {
    for (const target of this.targets) target.setSize(width, height);
    this.previousView.reset();
  }

  /** The next picture has nothing to do with those before. */
  resetHistory(): void {
    this.previousView.reset();
  }

  /** A picture of one sample. */
  resolveSingle(look: AntialiasingSettings): void {
    this.drawSingle(look);
    this.mode = look.antialiasing ? 'fxaa' : 'none';
    this.previousView.reset();
  }

  /** Sample `index` of `count`; until it is `shown`, the picture before them stays. */
  addSample(index: number, count: number, look: AntialiasingSettings, shown: boolean): void {
    const { uniforms } = this.inputs;
    uniforms.weight.value = 1 / count;
    uniforms.firstSample.value = index === 0 ? 1 : 0;
    this.sum = index % 2;
    this.accumulate(look);
    if (shown) this.mode = 'mean';
  }

  /** A picture of one sample, which follows those before. */
  resolveTemporal(look: AntialiasingSettings, seen: Seen): void {
    const { width, height } = this.single;
    const { x, y } = this.inputs.uniforms.jitter.value;
    this.filter.setJitter((x * width) / 2, (-y * height) / 2);
    this.previousView.update(seen);
    this.turn = 1 - this.turn;
    this.blend(look, seen.projection);
    this.mode = 'temporal';
  }

  present(target: RenderTarget | null): void {
    this.show(this.mode, target);
  }

  /** Runs the passes of a way, and those of more samples, and leaves what is known of pictures that were made. */
  runPasses(
    way: AntialiasingMode,
    look: AntialiasingSettings,
    projection: SpacetimeProjection,
    target: RenderTarget | null,
  ): void {
    if (way === 'none' || way === 'fxaa') this.drawSingle(look);
    if (way === 'temporal') this.blend(look, projection);
    if (look.antialiasing || way === 'mean') this.accumulate(look);
    for (const each of look.antialiasing ? [way, 'mean' as const] : [way]) this.show(each, target);
  }

  /** Where the mean of the samples' light is, once all are added. */
  get lightMean(): { readonly target: RenderTarget; readonly index: number } {
    return { target: this.sums[this.sum], index: 1 };
  }

  dispose(): void {
    for (const target of this.targets) target.dispose();
  }

  private drawSingle(look: AntialiasingSettings): void {
    const { buffer, uniforms, runPass: run } = this.inputs;
    const light = this.inputs.light();
    run(`single ${light.id} ${keyOf(look)}`, () => singleSample(light, buffer, uniforms, look), this.single);
  }

  /** The last sum, and this sample. */
  private accumulate(look: AntialiasingSettings): void {
    const { buffer, uniforms, runPass: run } = this.inputs;
    const light = this.inputs.light();
    const { picture, light: sum } = this;
    [picture.value, sum.value] = this.sums[1 - this.sum].textures;
    const before = { picture, light: sum };
    run(
      `add ${light.id} ${keyOf(look)}`,
      () => accumulatedSample(light, before, buffer, uniforms, look),
      this.sums[this.sum],
    );
  }

  private blend(look: AntialiasingSettings, projection: SpacetimeProjection): void {
    const { buffer, uniforms, runPass: run } = this.inputs;
    const light = this.inputs.light();
    const { previousView, filter, turn, now, former, history } = this;
    run(
      `fresh ${light.id} ${keyOf(look)}`,
      () => temporalSample(light, buffer, uniforms, look),
      this.temporalSamples[turn],
    );
    now.value = this.temporalSamples[turn].texture;
    former.value = this.temporalSamples[1 - turn].texture;
    history.value = this.histories[1 - turn].texture;
    const sources = {
      current: now,
      previous: former,
      history,
      buffer,
      uniforms,
      previousView,
      filter,
      projection,
    };
    run(`follow ${projection.event} ${projection.place}`, () => temporalResolve(sources), this.histories[turn]);
  }

  private show(way: AntialiasingMode, target: RenderTarget | null): void {
    const { single, mean, latest } = this;
    const { runPass: run } = this.inputs;
    mean.value = this.sums[this.sum].textures[0];
    latest.value = this.histories[this.turn].texture;
    const passes: Record<AntialiasingMode, () => Vec4> = {
      none: () => unfiltered(single.texture),
      fxaa: () => antialiased(single.texture),
      mean: () => sampleMean(mean),
      temporal: () => temporalResult(latest),
    };
    run(`show ${way}`, passes[way], target);
  }

  private get targets(): readonly RenderTarget[] {
    return [this.single, ...this.sums, ...this.temporalSamples, ...this.histories];
  }
}

const keyOf = ({ tone, grid, hasStars }: DisplayLook): string => `${tone} ${grid} ${hasStars}`;

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
