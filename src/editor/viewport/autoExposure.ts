import { adaptExposure, exposureForMetering, measuredFalseColorScale } from '../../nodes/pictures/metering.ts';
import type { PictureSpec } from '../../nodes/socketValues.ts';
import { contentKey } from '../../scene/frameGraph/frameGraph.ts';
import type { LightMeterReadings, MeteredQuantities } from '../../scene/view/metering.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { PictureViews } from '../../scene/view/pictureViews.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import type { FalseColorQuantity, ValueRange } from '../../spectrum/falseColor/falseColor.ts';

/** Minimum interval of measurements [ms] and in pictures: each waits for the GPU, and may render the picture again. */
const MIN_METERING_INTERVAL = 80;
const MIN_FRAMES_BETWEEN = 4;
/** Smaller differences are invisible [EV]; adaptation ends and no more frames are drawn. */
const SETTLED_DIFFERENCE = 0.004;

/** A rendered picture that can be measured. */
export interface MeteredPicture {
  readonly picture: PictureSpec;
  readonly views: PictureViews;
  /** As it is drawn. */
  readonly settings: RenderSettings;
  /** As it is asked for, of which there may be time for less. */
  readonly wanted: RenderSettings;
  /** How much of that is drawn; it rises with pixels and quality. */
  readonly detail: number;
  readonly size: PictureSize;
  readonly measureLight: (quantities: MeteredQuantities) => Promise<LightMeterReadings>;
}

/**
 * Automatic exposure of the page. The luminance of drawn pictures is measured asynchronously at intervals, and the
 * exposure adapts like an eye in real time, also with world time paused. A picture that does not change is measured
 * once, and again only when it is drawn in more detail, so that it settles.
 */
export class AutoExposure {
  /** Whether exposure jumps instead of adapting, with prefers-reduced-motion. */
  private readonly withoutAdaptation: boolean;
  private value: number | undefined;
  private target = 0;
  private readings: LightMeterReadings | undefined;
  /** Value ranges of the last measurement. */
  private rangesOfReadings:
    | { readonly readings: LightMeterReadings | undefined; readonly scales: Map<FalseColorQuantity, ValueRange> }
    | undefined;
  /** What is drawn, if it is not measured yet. */
  private unmeasured: (MeteredPicture & { readonly content: string }) | undefined;
  /** The last picture whose measurement has begun. */
  private measured = { content: '', detail: 0 };
  isMeasuring = false;
  /** Generation, incremented by `reset`. */
  private generation = 0;
  private lastMeasurement = Number.NEGATIVE_INFINITY;

  constructor(withoutAdaptation: boolean) {
    this.withoutAdaptation = withoutAdaptation;
  }

  /** Automatic part of the exposure [EV]. */
  exposure({ metering }: PictureSpec): number {
    return metering === 'manual' ? 0 : (this.value ?? 0);
  }

  /** Value range of a false colour: round numbers that enclose the last measurement. */
  scale(kind: FalseColorQuantity): ValueRange {
    if (!this.rangesOfReadings || this.rangesOfReadings.readings !== this.readings)
      this.rangesOfReadings = { readings: this.readings, scales: new Map() };
    const { scales } = this.rangesOfReadings;
    const scale = scales.get(kind) ?? measuredFalseColorScale(kind, this.readings);
    scales.set(kind, scale);
    return scale;
  }

  /** Whether the last picture is measured and adaptation has ended. */
  get isSettled(): boolean {
    return !this.unmeasured && !this.isMeasuring && (this.value === undefined || this.value === this.target);
  }

  /** Restarts: the next measurement applies at once, and pending ones are discarded. */
  reset(): void {
    this.generation++;
    this.value = undefined;
    this.unmeasured = undefined;
    this.measured = { content: '', detail: 0 };
  }

  /** Call with every drawn picture. `isBetter`: the same view as before, drawn again with more of the scene. */
  observe(drawn: MeteredPicture, isBetter = false): void {
    const { metering, falseColor, frameGraph } = drawn.picture;
    if (metering === 'manual' && !showsFalseColors(drawn.picture)) return;
    // Luminance does not depend on display settings, except through frame graphs.
    const { exposure: _, tone: __, falseColors: ___, frameGraph: ____, ...lit } = drawn.wanted;
    const { width, height } = drawn.size;
    const content = contentKey([metering, falseColor === 'none', drawn.views, lit, frameGraph, width / height]);
    if (isBetter) this.measured = { content: '', detail: 0 };
    const isMeasured = content === this.measured.content && drawn.detail <= this.measured.detail;
    this.unmeasured = isMeasured ? undefined : { ...drawn, content };
  }

  /** Advances by dt [s] of real time; `now` [ms]. Returns the running measurement, if any. */
  advance(dt: number, now: number): Promise<void> | undefined {
    if (this.value !== undefined) {
      const next = this.withoutAdaptation ? this.target : adaptExposure(this.value, this.target, dt);
      this.value = Math.abs(next - this.target) < SETTLED_DIFFERENCE ? this.target : next;
    }
    if (
      !this.unmeasured ||
      this.isMeasuring ||
      now - this.lastMeasurement < Math.max(MIN_METERING_INTERVAL, MIN_FRAMES_BETWEEN * 1000 * dt)
    )
      return undefined;
    this.lastMeasurement = now;
    return this.measure(this.unmeasured);
  }

  private async measure(drawn: NonNullable<AutoExposure['unmeasured']>): Promise<void> {
    const { picture, views, settings, size, content, detail, measureLight: readings } = drawn;
    const generation = this.generation;
    this.measured = { content, detail };
    this.isMeasuring = true;
    this.unmeasured = undefined;
    try {
      const measured = await readings(showsFalseColors(picture) ? 'all' : 'luminance');
      if (generation !== this.generation) return;
      this.readings = measured;
      this.target = exposureForMetering(picture.metering, this.readings, views, settings, size);
      this.value ??= this.target;
    } finally {
      this.isMeasuring = false;
    }
  }
}

/** Whether scales of false colours are measured too. */
const showsFalseColors = ({ falseColor, frameGraph }: PictureSpec): boolean => falseColor !== 'none' || !!frameGraph;
