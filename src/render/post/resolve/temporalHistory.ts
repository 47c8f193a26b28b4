import { texture } from 'three/tsl';
import { HalfFloatType, type RenderTarget } from 'three/webgpu';
import type { Vec4 } from '../../../shaders/types.ts';
import { dataTarget } from '../../gbuffer/gbuffer.ts';
import type { SpacetimeProjection } from '../../geometry/vertexStage.ts';
import { type DisplaySettings, displayKey, temporalResult, temporalSample } from '../display/display.ts';
import { PreviousView, type ViewState } from './previousView.ts';
import type { SampleInputs } from './sampleInputs.ts';
import { ReconstructionFilter, temporalResolve } from './temporalAntialiasing.ts';

/** The mean of former pictures, with which pictures of one sample are blended. */
export class TemporalHistory {
  private readonly inputs: SampleInputs;
  private readonly samples = [dataTarget(1, HalfFloatType), dataTarget(1, HalfFloatType)] as const;
  private readonly histories = [dataTarget(1, HalfFloatType), dataTarget(1, HalfFloatType)] as const;
  private readonly previousView = new PreviousView();
  private readonly filter = new ReconstructionFilter();
  /** Index of the history that was written last. */
  private current = 0;
  /** Texture nodes of ping-pong targets, set before each pass. */
  private readonly now = texture(this.samples[0].texture);
  private readonly former = texture(this.samples[0].texture);
  private readonly history = texture(this.histories[0].texture);
  private readonly latest = texture(this.histories[0].texture);

  constructor(inputs: SampleInputs) {
    this.inputs = inputs;
  }

  setSize(width: number, height: number): void {
    for (const target of this.targets) target.setSize(width, height);
    this.reset();
  }

  /** The next picture will not be blended with previous ones. */
  reset(): void {
    this.previousView.reset();
  }

  /** Blends a picture of one sample with the history. */
  resolve(settings: DisplaySettings, state: ViewState): void {
    const { width, height } = this.samples[0];
    const { x, y } = this.inputs.uniforms.jitter.value;
    this.filter.setJitter((x * width) / 2, (-y * height) / 2);
    this.previousView.update(state);
    this.current = 1 - this.current;
    this.blend(settings, state.projection);
  }

  /** The passes of `resolve`. */
  blend(settings: DisplaySettings, projection: SpacetimeProjection): void {
    const { buffer, uniforms, runPass: run } = this.inputs;
    const light = this.inputs.light();
    const { previousView, filter, current, now, former, history, samples, histories } = this;
    run(
      `fresh ${light.id} ${displayKey(settings)}`,
      () => temporalSample(light, buffer, uniforms, settings),
      samples[current],
    );
    now.value = samples[current].texture;
    former.value = samples[1 - current].texture;
    history.value = histories[1 - current].texture;
    const sources = { current: now, previous: former, history, buffer, uniforms, previousView, filter, projection };
    run(`follow ${projection.event} ${projection.place}`, () => temporalResolve(sources), histories[current]);
  }

  /** The blended picture, in each pass that shows it. */
  shown(): Vec4 {
    return temporalResult(this.latest);
  }

  /** Call before a pass that shows it. */
  bind(): void {
    this.latest.value = this.histories[this.current].texture;
  }

  dispose(): void {
    for (const target of this.targets) target.dispose();
  }

  private get targets(): readonly RenderTarget[] {
    return [...this.samples, ...this.histories];
  }
}
