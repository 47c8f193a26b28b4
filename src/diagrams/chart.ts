import { dot, type Vec3, ZERO } from '../math/vec3.ts';
import { boost, gamma } from '../physics/lorentz/boost.ts';
import { fourVector, spatial } from '../physics/lorentz/fourVector.ts';
import type { ObserverEvent } from '../physics/worldLines/kinds/worldLineKind.ts';
import { simultaneousTime } from '../physics/worldLines/simultaneity.ts';
import type { WorldLine } from '../physics/worldLines/worldLine.ts';
import type { PixelPoint } from './marks.ts';

/** An event relative to the observer's, in the frame that is drawn: (ct, x, y) [m]. */
export type ChartEvent = readonly [ct: number, x: number, y: number];

/** The drawn frame: its velocity and the directions of its axes, about the observer's event. */
export interface ChartFrame {
  readonly origin: ObserverEvent;
  /** γβ of the drawn frame in the world: 0, or the observer's. */
  readonly u: Vec3;
  /** Unit vectors on the drawn frame's axes, which are the world's carried by the pure boost; the second also of 1+1. */
  readonly axes: readonly [x: Vec3, y: Vec3];
  /** [m/s] */
  readonly c: number;
}

/** What is shown: |ct| ≤ height, |x| ≤ width, |y| ≤ depth [m]; and where, by a linear map. */
export interface ChartWindow {
  readonly height: number;
  readonly width: number;
  /** Infinite in 1+1, where y is not shown. */
  readonly depth: number;
  toPixel(event: ChartEvent): PixelPoint;
}

export const restFrame = (origin: ObserverEvent, axes: ChartFrame['axes'], c: number): ChartFrame => ({
  origin,
  u: ZERO,
  axes,
  c,
});

/** A separation (cΔt, Δx) [m] of the world in the drawn frame; docs/physics.md §2.2. */
export function inFrame({ u, axes }: ChartFrame, ct: number, x: Vec3): ChartEvent {
  const moved = boost(fourVector(ct, x), u);
  const place = spatial(moved);
  return [moved[0], dot(place, axes[0]), dot(place, axes[1])];
}

/** World time [s] at which a line is at the time ct [m] of the drawn frame: the slice of an event further along that frame's clock. */
export function worldTimeAt({ origin, u, c }: ChartFrame, line: WorldLine, ct: number): number {
  const { t, position } = origin;
  const later = {
    t: t + (gamma(u) * ct) / c,
    position: [position[0] + u[0] * ct, position[1] + u[1] * ct, position[2] + u[2] * ct] as const,
  };
  return simultaneousTime(line, later, u, c);
}

/** The part of a straight piece within the window (Liang, Barsky 1984); undefined if there is none. */
export function clipped(
  { height, width, depth }: ChartWindow,
  from: ChartEvent,
  to: ChartEvent,
): readonly [ChartEvent, ChartEvent] | undefined {
  let [begin, end] = [0, 1];
  const half = [height, width, depth];
  for (let k = 0; k < 3; k++) {
    const step = to[k]! - from[k]!;
    for (const sign of [-1, 1]) {
      const room = half[k]! - sign * from[k]!;
      const rate = sign * step;
      if (rate === 0 && room < 0) return undefined;
      if (rate > 0) end = Math.min(end, room / rate);
      if (rate < 0) begin = Math.max(begin, room / rate);
    }
  }
  return begin <= end ? [between(from, to, begin), between(from, to, end)] : undefined;
}

function between(from: ChartEvent, to: ChartEvent, s: number): ChartEvent {
  if (s === 0) return from;
  if (s === 1) return to;
  return [from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1]), from[2] + s * (to[2] - from[2])];
}
