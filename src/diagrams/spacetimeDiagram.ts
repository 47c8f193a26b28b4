import { addScaled, cross, dot, length, negate, normalize, scale, type Vec3, ZERO } from '../math/vec3.ts';
import { type LocalizedText, listed, type Message, msg } from '../messages/message.ts';
import { gamma, inverseBoost, velocity } from '../physics/lorentz/boost.ts';
import { fourVector, spatial } from '../physics/lorentz/fourVector.ts';
import { pastLightCone } from '../physics/worldLines/lightCone.ts';
import { simultaneitySlice } from '../physics/worldLines/simultaneity.ts';
import { velocityAt } from '../physics/worldLines/worldLine.ts';
import { isAlive } from '../scene/motion/lifetimes.ts';
import type { ProbeObserver } from '../scene/views/viewRecord.ts';
import { type ChartEvent, type ChartFrame, type ChartWindow, chartFrame, clipped, inFrame, isInside } from './chart.ts';
import type { DiagramLine } from './diagramLines.ts';
import { figureOf } from './figure.ts';
import { type ChartLayout, obliqueLayout, planeLayout } from './layouts.ts';
import { type LegendRow, legendMarks } from './legend.ts';
import type { Diagram, Mark, MarkRole, PixelPoint } from './marks.ts';
import { roundStep } from './roundStep.ts';
import { betaText, lengthUnit, plainNumber, timeUnit } from './units.ts';
import { clockTimes, tick, ticksAt, timesInWindow, worldLinePath } from './worldLineMarks.ts';

/** The frame in which a diagram is drawn: the world's, or that in which the observer is at rest. */
export const DIAGRAM_FRAMES = ['world', 'observer'] as const;
export type DiagramFrame = (typeof DIAGRAM_FRAMES)[number];

/** A spacetime diagram to be drawn. */
export interface SpacetimeDiagramSpec {
  /** His event is the origin. */
  readonly observer: ProbeObserver;
  /** [m/s] */
  readonly speedOfLight: number;
  readonly lines: readonly DiagramLine[];
  readonly frame: DiagramFrame;
  /** The direction of the x axis; absent: that of the observer's velocity, else of the fastest line's, else of the most distant line. */
  readonly axis?: Vec3;
  /** A second direction: the diagram is of 2+1 dimensions. Not parallel to `axis`. */
  readonly secondAxis?: Vec3;
  /** Half the length of the x axis [m]; absent: so that all events that are seen are in the picture. */
  readonly span?: number;
  /** World time at which the clocks of what always existed show 0 [s]; those of others do at birth. */
  readonly clockZero?: number;
  /** [px] */
  readonly width: number;
  /** [px] */
  readonly height: number;
}

/** A drawn spacetime diagram, and how to read events from it. */
export interface SpacetimeDiagram extends Diagram {
  /** Half the length of the x axis [m]. */
  readonly span: number;
  /** The direction of the x axis. */
  readonly axis: Vec3;
  /** The world's separation (cΔt [m], Δx [m]) from the observer's event of the event at a pixel; in 2+1 at ct = 0 of the drawn frame. */
  eventAtPixel(pixel: PixelPoint): { readonly ct: number; readonly x: Vec3 };
}

/** Marks are farther than this from the axis of a line that is listed as beside it, in parts of the span. */
const BESIDE = 0.02;

/**
 * The Minkowski diagram about an observer's event: world lines with ticks of their own time, his past and future light
 * cones, the events that are simultaneous for him, and those that he sees. In 1+1 dimensions ct against x, in 2+1 the
 * same with a plane. Scales of time and place are equal: light moves at 45°. docs/physics.md §2, §3.1, §5.1.
 */
export function spacetimeDiagram(spec: SpacetimeDiagramSpec): SpacetimeDiagram {
  const { observer, speedOfLight: c, lines } = spec;
  const axes = chartAxes(spec);
  const frame = chartFrame(observer, spec.frame === 'observer' ? observer.u : ZERO, axes, c);
  const events = lines.map((line) => eventsOf(line, observer, c, frame));
  const span = spec.span ?? suggestedSpan(events, spec);
  const layout = (spec.secondAxis ? obliqueLayout : planeLayout)(spec.width, spec.height, span);
  const { window } = layout;
  const step = clockStep(window, c);
  const roles = new Map(namesOf(lines).map((name, n) => [name, n]));
  const curves = lines.map((line) => lineMarks(line, roles.get(line.name)!, frame, window, step, spec.clockZero ?? 0));
  const beside = lines.filter((_, n) => !spec.secondAxis && isBeside(events[n]!, span));
  const marks: Mark[] = [
    ...layout.frameMarks(axisTexts(spec, span)),
    ...layout.coneMarks(),
    ...otherFrameMarks(spec, frame, layout),
    ...curves.flat(),
    ...events.flatMap((own, n) => eventMarks(lines[n]!, own, roles.get(lines[n]!.name)!, window)),
    ...legendMarks(legendRows(spec, step), layout.legendAt, spec.height),
  ];
  return {
    width: spec.width,
    height: spec.height,
    title: msg`Spacetime diagram`,
    description: description(spec, events, beside),
    marks,
    span,
    axis: axes[0],
    eventAtPixel: (pixel) => worldSeparation(frame, layout.eventAt(pixel)),
  };
}

/** The events of a line that the observer sees, and that is simultaneous for him, where it exists then. */
interface LineEvents {
  readonly seen: ChartEvent | undefined;
  readonly present: ChartEvent | undefined;
  /** Distance of both from the x axis [m]. */
  readonly beside: number;
}

function eventsOf({ line, lifetime }: DiagramLine, observer: ProbeObserver, c: number, frame: ChartFrame): LineEvents {
  const light = pastLightCone(line, observer, c);
  const slice = simultaneitySlice(line, observer, observer.u, c);
  const seen = light && isAlive(lifetime, observer.t - light.delay / c) ? light : undefined;
  const present = isAlive(lifetime, observer.t + slice.ahead / c) ? slice : undefined;
  const across = ({ offset }: { readonly offset: Vec3 }) => length(cross(offset, frame.axes[0]));
  return {
    seen: seen && inFrame(frame, -seen.delay, ...seen.offset),
    present: present && inFrame(frame, present.ahead, ...present.offset),
    beside: Math.max(seen ? across(seen) : 0, present ? across(present) : 0),
  };
}

const isBeside = ({ beside }: LineEvents, span: number): boolean => beside > BESIDE * span;

/** A direction, and one across it: the second given one, without what is along the first. */
function chartAxes(spec: SpacetimeDiagramSpec): readonly [Vec3, Vec3] {
  const x = normalize(spec.axis ?? suggestedAxis(spec), [1, 0, 0]);
  const across = (v: Vec3): Vec3 => cross(x, cross(v, x));
  const least: Vec3 = Math.abs(x[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
  return [x, normalize(across(spec.secondAxis ?? least), normalize(across(least)))];
}

function suggestedAxis({ observer, lines, speedOfLight: c }: SpacetimeDiagramSpec): Vec3 {
  if (length(observer.u) > 0) return observer.u;
  const longest = (vectors: readonly Vec3[]): Vec3 =>
    vectors.reduce((best, v) => (length(v) > length(best) ? v : best), ZERO);
  const fastest = longest(lines.map(({ line }) => velocityAt(line, observer.t, c)));
  if (length(fastest) > 0) return fastest;
  return longest(lines.map(({ line }) => simultaneitySlice(line, observer, observer.u, c).offset));
}

/** So that all the events are in the picture, whose height is `1/aspect` of its width; 1 m where there is none. */
function suggestedSpan(events: readonly LineEvents[], { secondAxis, width, height }: SpacetimeDiagramSpec): number {
  const plot = figureOf(width, height);
  const aspect = secondAxis ? 1 : plot.width / plot.height;
  const reach = ([ct, x, y]: ChartEvent) => Math.max(Math.abs(ct) * aspect, Math.abs(x), secondAxis ? Math.abs(y) : 0);
  const far = events.flatMap(({ seen, present }) => [seen, present].flatMap((event) => (event ? [reach(event)] : [])));
  return 1.1 * Math.max(...far.filter(Number.isFinite), 0) || 1;
}

/** Of proper time between ticks [s]: about ten of the observer's in the picture. */
function clockStep({ height }: ChartWindow, c: number): number {
  const half = height / c;
  const { size } = timeUnit(half);
  return roundStep((2 * half) / size, 10) * size;
}

function lineMarks(
  { line, lifetime }: DiagramLine,
  role: MarkRole,
  frame: ChartFrame,
  window: ChartWindow,
  step: number,
  clockZero: number,
): readonly Mark[] {
  const times = timesInWindow(frame, window, line, lifetime);
  if (!times) return [];
  const lines = worldLinePath(frame, window, line, times);
  if (lines.length === 0) return [];
  const zero = Number.isFinite(lifetime.birth) ? lifetime.birth : clockZero;
  const ticks = ticksAt(frame, window, line, clockTimes(line, times, zero, step, frame.c));
  return [
    { kind: 'lines', role, lines, width: 2 },
    { kind: 'lines', role, lines: ticks, width: 1.25 },
  ];
}

function eventMarks({ name }: DiagramLine, { seen, present }: LineEvents, role: MarkRole, window: ChartWindow): Mark[] {
  const dot = (event: ChartEvent | undefined, filled: boolean, title: Message): Mark[] =>
    event && isInside(window, event) ? [{ kind: 'dot', role, at: window.toPixel(event), filled, title }] : [];
  return [...dot(present, false, msg`${name}, now for the observer`), ...dot(seen, true, msg`${name}, as seen`)];
}

/** Axes of the frame that is not drawn: the observer's in the world's diagram, the world's in his. Its x axis is the slice of the observer's event in 1+1. */
function otherFrameMarks(spec: SpacetimeDiagramSpec, frame: ChartFrame, layout: ChartLayout): readonly Mark[] {
  const { window } = layout;
  const isWorld = spec.frame === 'world';
  const w = isWorld ? spec.observer.u : negate(spec.observer.u);
  const beta = velocity(w);
  const along: ChartEvent = [1, dot(beta, frame.axes[0]), dot(beta, frame.axes[1])];
  const clock = throughOrigin(window, along);
  const slice = layout.sliceMarks(isWorld ? [along[1], along[2]] : [0, 0]);
  const observerLine: ChartEvent = isWorld ? along : [1, 0, 0];
  const step = clockStep(window, spec.speedOfLight) * spec.speedOfLight;
  const observerTicks = multiples(observerLine, isWorld ? step * gamma(w) : step, window);
  const marks: Mark[] = [
    ...slice,
    { kind: 'lines', role: 'observer', lines: [throughOrigin(window, observerLine)], width: 2.5 },
    { kind: 'lines', role: 'observer', lines: observerTicks, width: 1.25 },
  ];
  if (length(w) === 0) return marks;
  const [name, place] = isWorld ? ['ct′', 'x′'] : ['ct', 'x'];
  if (!isWorld) marks.push({ kind: 'lines', role: 'otherAxis', lines: [clock], width: 1.25, dashed: true });
  marks.push(layout.endLabel(along, 'otherAxis', name));
  if (spec.secondAxis) return marks;
  const x: ChartEvent = [along[1], 1, 0];
  marks.push(layout.endLabel(x, 'otherAxis', place));
  if (!isWorld)
    marks.push({ kind: 'lines', role: 'otherAxis', lines: [throughOrigin(window, x)], width: 1.25, dashed: true });
  // Unit lengths of the other frame: events at its time 0 whose interval is a multiple of the step.
  const lengths = multiples(x, step / Math.sqrt(1 - along[1] * along[1]), window);
  return [...marks, { kind: 'lines', role: 'otherAxis', lines: lengths, width: 1.25 }];
}

/** The line through the origin within the window. */
function throughOrigin(window: ChartWindow, [ct, x, y]: ChartEvent): PixelPoint[] {
  const far = 4 * Math.max(window.height, window.width);
  const ends = clipped(window, [-far * ct, -far * x, -far * y], [far * ct, far * x, far * y]);
  return ends ? ends.map(window.toPixel) : [];
}

/** Ticks across a line through the origin at multiples of a length of the direction. */
function multiples(direction: ChartEvent, step: number, window: ChartWindow): PixelPoint[][] {
  const count = Math.min(200, Math.ceil((2 * Math.max(window.height, window.width)) / step));
  const ticks: PixelPoint[][] = [];
  for (let k = -count; k <= count; k++) {
    const s = k * step;
    const event: ChartEvent = [s * direction[0], s * direction[1], s * direction[2]];
    if (k !== 0 && isInside(window, event)) ticks.push(tick(window, event, direction));
  }
  return ticks;
}

function axisTexts(spec: SpacetimeDiagramSpec, span: number) {
  const prime = spec.frame === 'observer' && length(spec.observer.u) > 0 ? '′' : '';
  return { x: `x${prime}`, y: `y${prime}`, ct: `ct${prime}`, unit: lengthUnit(span) };
}

/** Each once: pieces of one thing have one name, and one colour. */
const namesOf = (lines: readonly DiagramLine[]): readonly string[] => [...new Set(lines.map(({ name }) => name))];

/** Lines that the legend names; of others only the number. */
const NAMED = 12;

function legendRows({ lines, observer }: SpacetimeDiagramSpec, step: number): readonly LegendRow[] {
  const unit = timeUnit(step);
  const names = namesOf(lines);
  const more = names.length - NAMED;
  return [
    {
      text: msg`Observer, β = ${betaText(length(observer.u))}`,
      role: 'observer',
      sample: 'line',
    },
    { text: msg`Now for the observer`, role: 'slice', sample: 'dashes' },
    { text: msg`Past light cone`, role: 'pastCone', sample: 'line' },
    { text: msg`Future light cone`, role: 'futureCone', sample: 'line' },
    { text: msg`Emission of the light seen`, role: 'axis', sample: 'filled' },
    { text: msg`Event of the observer’s now`, role: 'axis', sample: 'hollow' },
    { text: msg`Ticks: ${plainNumber(step / unit.size)} ${unit.name} of own time`, role: 'axis', sample: 'tick' },
    ...names.slice(0, NAMED).map((text, role): LegendRow => ({ text, role, sample: 'line' })),
    ...(more > 0 ? [{ text: msg`${more} more`, role: 'axis', sample: 'none' } as const] : []),
  ];
}

/** Sentences for those who do not see the picture. */
function description(
  { lines, observer, frame }: SpacetimeDiagramSpec,
  events: readonly LineEvents[],
  beside: readonly DiagramLine[],
): Message {
  const speed = betaText(length(observer.u));
  const names = listedShort(namesOf(lines));
  const seen = events.filter((event) => event.seen).length;
  const where =
    frame === 'world'
      ? msg`Time against place in the frame of the world, about the observer’s event. The observer moves with β = ${speed}.`
      : msg`Time against place in the rest frame of the observer, about the observer’s event. The world moves with β = ${speed}.`;
  const what = msg`World lines: ${names}. Of ${seen} of ${events.length} the observer sees light.`;
  if (beside.length === 0) return msg`${where} ${what}`;
  const off = listedShort(namesOf(beside));
  return msg`${where} ${what} Beside the axis, so that their events lie within the drawn cone: ${off}.`;
}

function listedShort(names: readonly string[]): LocalizedText {
  if (names.length === 0) return msg`none`;
  const more = names.length - NAMED;
  return listed([...names.slice(0, NAMED), ...(more > 0 ? [msg`${more} more`] : [])]);
}

/** The world's separation of an event of the chart: the boost back. */
function worldSeparation({ u, axes: [e, f] }: ChartFrame, [ct, x, y]: ChartEvent): { ct: number; x: Vec3 } {
  const place = addScaled(scale(e, x), f, y);
  const event = inverseBoost(fourVector(ct, place), u);
  return { ct: event[0], x: spatial(event) };
}
