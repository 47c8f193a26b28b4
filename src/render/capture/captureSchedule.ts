import { addScaled, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import type { Body } from '../geometry/bodies.ts';
import { type CaptureEvent, captureError, isSameEvent } from './captureError.ts';

/** A capture lasts for as many pictures, if the observer goes on as from the last one; what it cannot hold so long is drawn as geometry. */
const LASTING_PICTURES = 16;

/** What a picture asks of a capture. */
export interface CaptureRequest {
  /** Captures with another key are of something else. */
  readonly key: string;
  readonly event: CaptureEvent;
  /** All that it may hold. */
  readonly bodies: readonly Body[];
  /** Greatest error of what it holds [rad at rest]. */
  readonly maxError: number;
}

interface HeldCapture {
  readonly key: string;
  readonly event: CaptureEvent;
  readonly bodies: ReadonlySet<Body>;
}

/** Decides which bodies a picture takes from a capture, and when that is renewed; the others are drawn as geometry over it. */
export class CaptureSchedule {
  private held: HeldCapture | undefined;
  /** The one that `held` becomes when it has been drawn. */
  private due: HeldCapture | undefined;
  private last: { readonly key: string; readonly event: CaptureEvent } | undefined;
  /** Whether it is to be drawn again for an observer who stays. */
  private isProvisional = false;

  /** Sets what the next picture is drawn with. */
  next({ key, event, bodies, maxError }: CaptureRequest): void {
    const { held, last } = this;
    const previous = last?.key === key ? last.event : event;
    const rests = last?.key === key && isSameEvent(previous, event);
    this.last = { key, event };
    const lasts =
      held?.key === key && [...held.bodies].every((each) => captureError(each, held.event, event) <= maxError);
    const isFinal = held?.bodies.size === bodies.length && !this.isProvisional;
    this.due = undefined;
    if (lasts && (isFinal || !rests)) return;
    const later = goneOn(previous, event);
    this.due = { key, event, bodies: new Set(bodies.filter((each) => captureError(each, event, later) <= maxError)) };
  }

  get isDue(): boolean {
    return this.due !== undefined;
  }

  /** Those that the next picture takes from the capture. */
  get bodies(): ReadonlySet<Body> {
    return (this.due ?? this.held)?.bodies ?? new Set();
  }

  /** From the place of the capture to that of the picture [m]. */
  get moved(): Vec3 {
    const from = (this.due ?? this.held)?.event;
    return from && this.last ? sub(this.last.event.position, from.position) : ZERO;
  }

  /** It has been drawn. `isProvisional`: not with the best tessellation. */
  taken(isProvisional: boolean): void {
    this.held = this.due ?? this.held;
    this.due = undefined;
    this.isProvisional = isProvisional;
  }

  /** What it holds is lost. */
  reset(): void {
    this.held = undefined;
    this.due = undefined;
    this.last = undefined;
  }
}

/** Where an observer will be. */
const goneOn = (previous: CaptureEvent, event: CaptureEvent): CaptureEvent => ({
  t: event.t + LASTING_PICTURES * (event.t - previous.t),
  position: addScaled(event.position, sub(event.position, previous.position), LASTING_PICTURES),
});
