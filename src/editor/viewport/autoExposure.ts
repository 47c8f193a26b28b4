import { adaptExposure, exposureForMetering, measuredFalseColorScale } from '../../nodes/pictures/metering.ts';
import type { PictureSpec } from '../../nodes/socketValues.ts';
import { contentKey } from '../../scene/frameGraph/frameGraph.ts';
import type { LightMeterReadings } from '../../scene/view/metering.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import type { FalseColorQuantity, ValueRange } from '../../spectrum/falseColor/falseColor.ts';

/** Minimum interval of measurements [ms] and in pictures: each waits for the GPU, and may render the picture again. */
const MIN_METERING_INTERVAL = 80;
const MIN_FRAMES_BETWEEN = 4;
/** Smaller differences are invisible [EV]; adaptation ends and no more frames are drawn. */
const SETTLED_DIFFERENCE = 0.004;

/** A rendered picture that can be measured. */
export interface MeteredPicture {
  readonly picture: PictureSpec;
  readonly viewPoint: ViewPoint;
  readonly settings: RenderSettings;
  /** Aspect ratio, width over height. */
  readonly aspect: number;
  readonly measureLight: () => Promise<LightMeterReadings>;
}

/**
 * Automatic exposure of the page. The luminance of drawn pictures is measured asynchronously at intervals, and the
 * exposure adapts like an eye in real time, also with world time paused. A picture that does not change is measured
 * once, so that it settles.
 */
export class AutoExposure {
  /** Whether exposure jumps instead of adapting, with prefers-reduced-motion. */
  private readonly atOnce: boolean;
  private value: number | undefined;
  private target = 0;
  private gauge: LightMeterReadings | undefined;
  /** Value ranges of the last measurement. */
  private scaled:
    | { readonly gauge: LightMeterReadings | undefined; readonly scales: Map<FalseColorQuantity, ValueRange> }
    | undefined;
  /** The drawn picture that is not measured yet. */
  private drawn: MeteredPicture | undefined;
  private known = '';
  private busy = false;
  /** Generation, incremented by `reset`. */
  private life = 0;
  private since = Number.NEGATIVE_INFINITY;

  constructor(atOnce: boolean) {
    this.atOnce = atOnce;
  }

  /** Automatic part of the exposure [EV]. */
  exposure({ metering }: PictureSpec): number {
    return metering === 'manual' ? 0 : (this.value ?? 0);
  }

  /** Value range of a false colour: round numbers that enclose the last measurement. */
  scale(kind: FalseColorQuantity): ValueRange {
    if (!this.scaled || this.scaled.gauge !== this.gauge) this.scaled = { gauge: this.gauge, scales: new Map() };
    const { scales } = this.scaled;
    const scale = scales.get(kind) ?? measuredFalseColorScale(kind, this.gauge);
    scales.set(kind, scale);
    return scale;
  }

  /** Whether the last picture is measured and adaptation has ended. */
  get isSettled(): boolean {
    return !this.drawn && !this.busy && (this.value === undefined || this.value === this.target);
  }

  /** Restarts: the next measurement applies at once, and pending ones are discarded. */
  reset(): void {
    this.life++;
    this.value = undefined;
    this.drawn = undefined;
    this.known = '';
  }

  /** Call with every drawn picture. */
  observe(drawn: MeteredPicture): void {
    const { metering, falseColor, frameGraph } = drawn.picture;
    if (metering === 'manual' && falseColor === 'none' && !frameGraph) return;
    // Luminance does not depend on display settings, except through frame graphs.
    const { exposure: _, tone: __, falseColors: ___, frameGraph: ____, ...lit } = drawn.settings;
    const what = contentKey([metering, falseColor === 'none', drawn.viewPoint, lit, frameGraph, drawn.aspect]);
    if (what === this.known) return;
    this.known = what;
    this.drawn = drawn;
  }

  /** Advances by dt [s] of real time; `now` [ms]. Returns the running measurement, if any. */
  advance(dt: number, now: number): Promise<void> | undefined {
    if (this.value !== undefined) {
      const next = this.atOnce ? this.target : adaptExposure(this.value, this.target, dt);
      this.value = Math.abs(next - this.target) < SETTLED_DIFFERENCE ? this.target : next;
    }
    if (!this.drawn || this.busy || now - this.since < Math.max(MIN_METERING_INTERVAL, MIN_FRAMES_BETWEEN * 1000 * dt))
      return undefined;
    this.since = now;
    return this.measure(this.drawn);
  }

  private async measure(drawn: MeteredPicture): Promise<void> {
    const { picture, viewPoint, settings, aspect, measureLight: gauge } = drawn;
    const life = this.life;
    this.busy = true;
    this.drawn = undefined;
    try {
      const measured = await gauge();
      if (life !== this.life) return;
      this.gauge = measured;
      this.target = exposureForMetering(picture.metering, this.gauge, viewPoint, settings, aspect);
      this.value ??= this.target;
    } finally {
      this.busy = false;
    }
  }
}
