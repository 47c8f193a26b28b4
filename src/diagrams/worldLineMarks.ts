import { safeguardedNewton } from '../math/roots.ts';
import { gamma } from '../physics/lorentz/boost.ts';
import type { PolylineLine } from '../physics/worldLines/kinds/polylineLine.ts';
import { properTimeBetween } from '../physics/worldLines/properTime.ts';
import { samplesUntil } from '../physics/worldLines/samples.ts';
import { asInertial, positionAt, properVelocityAt, type WorldLine } from '../physics/worldLines/worldLine.ts';
import type { Lifetime } from '../scene/motion/motionTypes.ts';
import {
  type ChartEvent,
  type ChartFrame,
  type ChartWindow,
  clipped,
  inFrame,
  isInside,
  worldTimeAt,
} from './chart.ts';
import type { PixelPoint } from './marks.ts';

/** A curve is at most this far from its chords [px]. */
export const CHORD_ERROR = 0.25;
/** Halvings of a piece between two knots, and ticks of one line. */
const [MAX_DEPTH, MAX_TICKS] = [14, 400];
/** Half the length of a tick [px]. */
const TICK = 4;
/** Parts of a turn in which a circle is begun. */
const PARTS_OF_TURN = 8;
/** Knots of one line: of more pieces several are taken together. */
const MAX_KNOTS = 4096;

/** The event of a line at world time t [s] in the drawn frame. */
export function eventAt(frame: ChartFrame, line: WorldLine, t: number): ChartEvent {
  const [x, y, z] = positionAt(line, t, frame.c);
  return atPlace(frame, t, x, y, z);
}

function atPlace(frame: ChartFrame, t: number, x: number, y: number, z: number): ChartEvent {
  const { t: t0, position } = frame.origin;
  return inFrame(frame, frame.c * (t - t0), x - position[0], y - position[1], z - position[2]);
}

/** World times [s] between which a line is in the window's height and alive; undefined if it never is. */
export function timesInWindow(
  frame: ChartFrame,
  { height }: ChartWindow,
  line: WorldLine,
  { birth, death }: Lifetime,
): readonly [number, number] | undefined {
  const from = Math.max(birth, worldTimeAt(frame, line, -height));
  const to = Math.min(death, worldTimeAt(frame, line, height));
  return from < to ? [from, to] : undefined;
}

/** A world line between two world times, as lines in pixels, cut to the window; `CHORD_ERROR` says how exact. */
export function worldLinePath(
  frame: ChartFrame,
  window: ChartWindow,
  line: WorldLine,
  [from, to]: readonly [number, number],
): PixelPoint[][] {
  if (line.kind === 'polyline') return cutToWindow(window, polylineEvents(frame, line, from, to));
  const knots = knotsOf(line, from, to);
  const events: ChartEvent[] = [eventAt(frame, line, knots[0]!)];
  const bends = line.kind === 'hyperbolic' || line.kind === 'cubic' || line.kind === 'circular';
  for (let i = 1; i < knots.length; i++) {
    const next = eventAt(frame, line, knots[i]!);
    if (bends) refine(frame, window, line, knots[i - 1]!, events.at(-1)!, knots[i]!, next, MAX_DEPTH, events);
    events.push(next);
  }
  return cutToWindow(window, events);
}

/** The ends and the samples between them. */
function polylineEvents(frame: ChartFrame, line: PolylineLine, from: number, to: number): readonly ChartEvent[] {
  const { times, positions } = line;
  const events = [eventAt(frame, line, from)];
  const end = samplesUntil(times, to);
  for (let i = samplesUntil(times, from); i < end; i++)
    events.push(atPlace(frame, times[i]!, positions[3 * i]!, positions[3 * i + 1]!, positions[3 * i + 2]!));
  events.push(eventAt(frame, line, to));
  return events;
}

/** World times between which the line bends one way. */
function knotsOf(line: WorldLine, from: number, to: number): readonly number[] {
  if (line.kind === 'hyperbolic') return line.t0 > from && line.t0 < to ? [from, line.t0, to] : [from, to];
  if (line.kind === 'circular') {
    const parts = Math.ceil((Math.abs(line.angularVelocity) * (to - from) * PARTS_OF_TURN) / (2 * Math.PI));
    const count = Math.min(MAX_KNOTS, Math.max(1, parts));
    return Array.from({ length: count + 1 }, (_, i) => (i === count ? to : from + (i / count) * (to - from)));
  }
  if (line.kind !== 'cubic') return [from, to];
  const first = samplesUntil(line.times, from);
  const end = samplesUntil(line.times, to);
  const every = Math.ceil(Math.max(1, end - first) / MAX_KNOTS);
  const inner = Array.from({ length: Math.ceil((end - first) / every) }, (_, i) => line.times[first + i * every]!);
  return [from, ...inner.filter((t) => t > from && t < to), to];
}

/** Adds the events between two, halving until the chord is near enough. What is wholly beyond one side of the window is not refined. */
function refine(
  frame: ChartFrame,
  window: ChartWindow,
  line: WorldLine,
  t0: number,
  from: ChartEvent,
  t1: number,
  to: ChartEvent,
  depth: number,
  out: ChartEvent[],
): void {
  const middle = t0 + (t1 - t0) / 2;
  const event = eventAt(frame, line, middle);
  if (depth === 0 || isBeyond(window, from, event, to)) return;
  if (chordError(window.toPixel(from), window.toPixel(event), window.toPixel(to)) < CHORD_ERROR / 2) return;
  refine(frame, window, line, t0, from, middle, event, depth - 1, out);
  out.push(event);
  refine(frame, window, line, middle, event, t1, to, depth - 1, out);
}

function isBeyond({ width, depth }: ChartWindow, a: ChartEvent, b: ChartEvent, d: ChartEvent): boolean {
  const [x, y] = [Math.min(a[1], b[1], d[1]), Math.min(a[2], b[2], d[2])];
  return x > width || y > depth || Math.max(a[1], b[1], d[1]) < -width || Math.max(a[2], b[2], d[2]) < -depth;
}

/** How far a point is from the chord between two others. */
function chordError(a: PixelPoint, p: PixelPoint, b: PixelPoint): number {
  const [x, y] = [b[0] - a[0], b[1] - a[1]];
  const long = Math.hypot(x, y);
  if (long === 0) return Math.hypot(p[0] - a[0], p[1] - a[1]);
  return Math.abs(x * (p[1] - a[1]) - y * (p[0] - a[0])) / long;
}

/** The parts within the window, each as a line. Steps below the chord error are left out. */
function cutToWindow(window: ChartWindow, events: readonly ChartEvent[]): PixelPoint[][] {
  const lines: PixelPoint[][] = [];
  let open: PixelPoint[] | undefined;
  for (let i = 1; i < events.length; i++) {
    const part = clipped(window, events[i - 1]!, events[i]!);
    if (!part) {
      open = undefined;
      continue;
    }
    if (!open || part[0] !== events[i - 1]) {
      open = [window.toPixel(part[0])];
      lines.push(open);
    }
    const next = window.toPixel(part[1]);
    const last = open.at(-1)!;
    const ends = part[1] !== events[i] || i === events.length - 1;
    if (ends || Math.hypot(next[0] - last[0], next[1] - last[1]) > CHORD_ERROR / 2) open.push(next);
    if (part[1] !== events[i]) open = undefined;
  }
  return lines;
}

/** World times at which the clock of a line that shows 0 at world time `zero` shows multiples of `step`, all in s. */
export function clockTimes(
  line: WorldLine,
  [from, to]: readonly [number, number],
  zero: number,
  step: number,
  c: number,
): readonly number[] {
  const begin = properTimeBetween(line, zero, from, c);
  const end = begin + properTimeBetween(line, from, to, c);
  const first = Math.ceil(begin / step - 1e-9);
  const times: number[] = [];
  const constant = asInertial(line) !== undefined || line.kind === 'circular';
  const dilation = (to - from) / (end - begin);
  let [last, shown] = [from, begin];
  for (let k = first; k * step <= end * (1 + 1e-12) && times.length < MAX_TICKS; k++) {
    if (constant) {
      times.push(from + (k * step - begin) * dilation);
      continue;
    }
    const wanted = k * step - shown;
    const slope = (t: number) => 1 / gamma(properVelocityAt(line, t, c));
    const start = last;
    last = safeguardedNewton(
      (t) => [properTimeBetween(line, start, t, c) - wanted, slope(t)],
      start,
      to,
      start + wanted / slope(start),
    );
    shown = k * step;
    times.push(last);
  }
  return times;
}

/** Ticks across a line at world times, cut away outside the window. */
export function ticksAt(
  frame: ChartFrame,
  window: ChartWindow,
  line: WorldLine,
  times: readonly number[],
): PixelPoint[][] {
  return times.flatMap((t) => {
    const event = eventAt(frame, line, t);
    if (!isInside(window, event)) return [];
    const u = properVelocityAt(line, t, frame.c);
    return [tick(window, event, inFrame(frame, gamma(u), ...u))];
  });
}

/** A tick at an event of a line with a direction. */
export function tick(window: ChartWindow, event: ChartEvent, direction: ChartEvent): PixelPoint[] {
  const at = window.toPixel(event);
  const [origin, ahead] = [window.toPixel([0, 0, 0]), window.toPixel(direction)];
  const [x, y] = [ahead[0] - origin[0], ahead[1] - origin[1]];
  const scale = TICK / (Math.hypot(x, y) || 1);
  return [
    [at[0] - y * scale, at[1] + x * scale],
    [at[0] + y * scale, at[1] - x * scale],
  ];
}
