import { addScaled, dot, type Vec3 } from '../math/vec3.ts';
import { gamma } from '../physics/lorentz/boost.ts';
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
  /** ct, x and y of the drawn frame, of (cΔt, Δx, Δy, Δz) of the world. */
  readonly forms: readonly [ct: Form, x: Form, y: Form];
}

type Form = readonly [ct: number, x: number, y: number, z: number];

/** What is shown: |ct| ≤ height, |x| ≤ width, |y| ≤ depth [m]; and where, by a linear map. */
export interface ChartWindow {
  readonly height: number;
  readonly width: number;
  /** Infinite in 1+1, where y is not shown. */
  readonly depth: number;
  toPixel(event: ChartEvent): PixelPoint;
}

/** The frame with its axes as linear forms of a separation of the world. */
export function chartFrame(origin: ObserverEvent, u: Vec3, axes: ChartFrame['axes'], c: number): ChartFrame {
  const g = gamma(u);
  // ct′ = γ ct − u·x, and e·x′ = e·x + (u·e)[u·x/(γ + 1) − ct]; docs/physics.md §2.2.
  const place = (e: Vec3): Form => [-dot(u, e), ...addScaled(e, u, dot(u, e) / (g + 1))];
  return { origin, u, axes, c, forms: [[g, -u[0], -u[1], -u[2]], place(axes[0]), place(axes[1])] };
}

/** A separation (cΔt, Δx, Δy, Δz) [m] of the world in the drawn frame. */
export function inFrame({ forms: [f, g, h] }: ChartFrame, ct: number, x: number, y: number, z: number): ChartEvent {
  return [
    f[0] * ct + f[1] * x + f[2] * y + f[3] * z,
    g[0] * ct + g[1] * x + g[2] * y + g[3] * z,
    h[0] * ct + h[1] * x + h[2] * y + h[3] * z,
  ];
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

export const isInside = ({ height, width, depth }: ChartWindow, [ct, x, y]: ChartEvent): boolean =>
  Math.abs(ct) <= height && Math.abs(x) <= width && Math.abs(y) <= depth;

/** The part of a straight piece within the window (Liang, Barsky 1984); undefined if there is none. */
export function clipped(
  window: ChartWindow,
  from: ChartEvent,
  to: ChartEvent,
): readonly [ChartEvent, ChartEvent] | undefined {
  if (isInside(window, from) && isInside(window, to)) return [from, to];
  const { height, width, depth } = window;
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
