import { scaleLinear } from 'd3-scale';
import type { ChartEvent, ChartWindow } from './chart.ts';
import { clipped } from './chart.ts';
import { figureOf } from './figure.ts';
import type { Mark, MarkRole, PixelPoint } from './marks.ts';
import { type AxisUnit, plainNumber } from './units.ts';

/** Names of the axes, and their unit. */
export interface AxisTexts {
  readonly x: string;
  readonly y: string;
  readonly ct: string;
  readonly unit: AxisUnit;
}

/** How a diagram is laid out: its window, and what lies under the world lines. */
export interface ChartLayout {
  readonly window: ChartWindow;
  readonly legendAt: PixelPoint | undefined;
  frameMarks(texts: AxisTexts): readonly Mark[];
  coneMarks(): readonly Mark[];
  /** Events ct = β·(x, y) of the drawn frame. */
  sliceMarks(beta: readonly [number, number]): readonly Mark[];
  /** A label where the ray from the origin leaves the window. */
  endLabel(direction: ChartEvent, role: MarkRole, text: string): Mark;
  /** The event at a pixel; in 2+1 that with ct = 0. */
  eventAt(pixel: PixelPoint): ChartEvent;
}

/** Height and turn of the eye of 2+1 [rad]. */
const [ELEVATION, TURN] = [0.42, 0.5];
const CIRCLE_PARTS = 96;

/** ct upwards, x to the right, in one scale. `span`: half the x axis [m]. */
export function planeLayout(width: number, height: number, span: number): ChartLayout {
  const { left, top, width: w, height: h, legendAt } = figureOf(width, height);
  const scale = w / (2 * span);
  const [centerX, centerY] = [left + w / 2, top + h / 2];
  const half = h / (2 * scale);
  const toPixel = ([ct, x]: ChartEvent): PixelPoint => [centerX + scale * x, centerY - scale * ct];
  const window: ChartWindow = { height: half, width: span, depth: Number.POSITIVE_INFINITY, toPixel };
  const segment = (from: ChartEvent, to: ChartEvent): PixelPoint[] => clipped(window, from, to)?.map(toPixel) ?? [];
  const corner = Math.min(half, span);
  return {
    window,
    legendAt,
    eventAt: ([x, y]) => [(centerY - y) / scale, (x - centerX) / scale, 0],
    frameMarks: (texts) => planeFrame(window, texts),
    coneMarks: () =>
      (['pastCone', 'futureCone'] as const).flatMap((role, k): Mark[] => {
        const ct = k === 0 ? -corner : corner;
        const far = k === 0 ? -2 * Math.max(half, span) : 2 * Math.max(half, span);
        const outline = [
          ...segment([0, 0, 0], [far, -Math.abs(far), 0]),
          ...(half > span ? [toPixel([Math.sign(ct) * half, -span, 0]), toPixel([Math.sign(ct) * half, span, 0])] : []),
          ...segment([far, Math.abs(far), 0], [0, 0, 0]),
        ];
        return [
          { kind: 'area', role, outline },
          {
            kind: 'lines',
            role,
            lines: [segment([0, 0, 0], [far, -Math.abs(far), 0]), segment([0, 0, 0], [far, Math.abs(far), 0])],
            width: role === 'pastCone' ? 2 : 1.5,
          },
        ];
      }),
    sliceMarks: ([beta]) => [
      {
        kind: 'lines',
        role: 'slice',
        lines: [segment([-beta * span, -span, 0], [beta * span, span, 0])],
        width: 1.75,
        dashed: true,
      },
    ],
    endLabel(direction, role, text) {
      const far = 4 * Math.max(half, span);
      const end = segment([0, 0, 0], [far * direction[0], far * direction[1], 0]).at(-1) ?? [centerX, centerY];
      const [ct, x] = direction;
      if (Math.abs(ct) < Math.abs(x)) {
        // On the side of an axis of places that is away from the light cone, where the axis of time has its own.
        const side = ct < 0 ? -1 : 1;
        const [alongX, alongY] = [x / Math.hypot(ct, x), -ct / Math.hypot(ct, x)];
        const middle = end[0] - LABEL_GAP * (alongX + side * alongY);
        const baseline = end[1] - LABEL_GAP * (alongY - side * alongX) + 4;
        const rightmost = centerX + w / 2 - LABEL_GAP / 2;
        return { kind: 'text', role, at: [Math.min(middle, rightmost), baseline], text, anchor: 'middle' };
      }
      return {
        kind: 'text',
        role,
        at: [Math.min(end[0] - 6, centerX + w / 2 - 6), Math.max(end[1] - 6, top - 6)],
        text,
        anchor: 'end',
      };
    },
  };
}

/** Between an axis, and its end, and the middle of its name [px]. */
const LABEL_GAP = 16;
/** Room for a number below the axis of places [px]. */
const LABEL_WIDTH = 44;

/** Grid, axes and numbers. */
function planeFrame({ height, width, toPixel }: ChartWindow, { x, ct, unit }: AxisTexts): readonly Mark[] {
  const ticksTo = (half: number) => scaleLinear().domain([-half / unit.size, half / unit.size]);
  const at = (value: number) => value * unit.size;
  const [left, bottom] = toPixel([-height, -width, 0]);
  const [right, top] = toPixel([height, width, 0]);
  const most = Math.max(3, Math.floor((right - left) / LABEL_WIDTH));
  const [xs, cts] = [ticksTo(width).ticks(Math.min(8, most)), ticksTo(height).ticks(8)];
  const grid = [
    ...xs.map((value) => [toPixel([-height, at(value), 0]), toPixel([height, at(value), 0])]),
    ...cts.map((value) => [toPixel([at(value), -width, 0]), toPixel([at(value), width, 0])]),
  ];
  const axes = [
    [toPixel([-height, 0, 0]), toPixel([height, 0, 0])],
    [toPixel([0, -width, 0]), toPixel([0, width, 0])],
  ];
  const label = (text: string, place: PixelPoint, anchor: 'middle' | 'end' | 'start'): Mark => ({
    kind: 'text',
    role: 'axis',
    at: place,
    text,
    anchor,
  });
  return [
    { kind: 'lines', role: 'frame', lines: grid, width: 0.75 },
    { kind: 'lines', role: 'axis', lines: axes, width: 1 },
    ...xs.map((value) => label(plainNumber(value), [toPixel([0, at(value), 0])[0], bottom + 17], 'middle')),
    ...cts.map((value) => label(plainNumber(value), [left - 6, toPixel([at(value), 0, 0])[1] + 4], 'end')),
    label(`${x} [${unit.name}]`, [right, bottom + 35], 'end'),
    label(`${ct} [${unit.name}]`, [left - 6, top - 10], 'start'),
  ];
}

/** ct upwards, the plane seen obliquely from above, without perspective. */
export function obliqueLayout(width: number, height: number, span: number): ChartLayout {
  const { left, top, width: w, height: h, legendAt } = figureOf(width, height);
  const [sinE, cosE, sinT, cosT] = [Math.sin(ELEVATION), Math.cos(ELEVATION), Math.sin(TURN), Math.cos(TURN)];
  const reach = cosT + sinT;
  const scale = Math.min(w / (2 * span * reach), h / (2 * span * (cosE + reach * sinE)));
  const [centerX, centerY] = [left + w / 2, top + h / 2];
  const toPixel = ([ct, x, y]: ChartEvent): PixelPoint => [
    centerX + scale * (x * cosT - y * sinT),
    centerY - scale * (ct * cosE + (x * sinT + y * cosT) * sinE),
  ];
  const window: ChartWindow = { height: span, width: span, depth: span, toPixel };
  const ring = (ct: number, radius: number): PixelPoint[] =>
    Array.from({ length: CIRCLE_PARTS + 1 }, (_, i) => {
      const angle = (2 * Math.PI * i) / CIRCLE_PARTS;
      return toPixel([ct, radius * Math.cos(angle), radius * Math.sin(angle)]);
    });
  // Where the outline of the cone touches its ellipse: sin φ = ∓ tan E, φ from the picture's horizontal.
  const touching = (ct: number): PixelPoint[][] =>
    [-1, 1].map((side) => {
      const sine = (-Math.sign(ct) * sinE) / cosE;
      const cosine = side * Math.sqrt(1 - sine * sine);
      const radius = Math.abs(ct);
      return [
        toPixel([0, 0, 0]),
        toPixel([ct, radius * (cosine * cosT + sine * sinT), radius * (sine * cosT - cosine * sinT)]),
      ];
    });
  return {
    window,
    legendAt,
    eventAt([x, y]) {
      const [across, up] = [(x - centerX) / scale, (centerY - y) / (scale * sinE)];
      return [0, across * cosT + up * sinT, up * cosT - across * sinT];
    },
    frameMarks: (texts) => obliqueFrame(window, texts),
    coneMarks: () =>
      (
        [
          ['pastCone', -span],
          ['futureCone', span],
        ] as const
      ).flatMap(([role, ct]): Mark[] => [
        { kind: 'area', role, outline: ring(ct, span) },
        { kind: 'lines', role, lines: [ring(ct, span), ring(ct / 2, span / 2), ...touching(ct)], width: 1.5 },
      ]),
    sliceMarks([bx, by]) {
      const half = span / Math.SQRT2;
      const outline = [
        [-half, -half],
        [half, -half],
        [half, half],
        [-half, half],
        [-half, -half],
      ].map(([x, y]) => toPixel([bx * x! + by * y!, x!, y!]));
      return [
        { kind: 'area', role: 'slice', outline },
        { kind: 'lines', role: 'slice', lines: [outline], width: 1.25, dashed: true },
      ];
    },
    endLabel(direction, role, text) {
      const far = 4 * span;
      const end = clipped(window, [0, 0, 0], [far * direction[0], far * direction[1], far * direction[2]])?.[1];
      const [x, y] = toPixel(end ?? [0, 0, 0]);
      return { kind: 'text', role, at: [x + 6, y], text, anchor: 'start' };
    },
  };
}

/** The plane of the observer's event, and axes with numbers. */
function obliqueFrame({ width: span, toPixel }: ChartWindow, { x, y, ct, unit }: AxisTexts): readonly Mark[] {
  const square = [
    [-1, -1],
    [1, -1],
    [1, 1],
    [-1, 1],
    [-1, -1],
  ].map(([a, b]) => toPixel([0, a! * span, b! * span]));
  const ticks = scaleLinear()
    .domain([-span / unit.size, span / unit.size])
    .ticks(5)
    .filter((value) => value !== 0);
  const numbered = (event: (at: number) => ChartEvent, [dx, dy]: PixelPoint): Mark[] =>
    ticks.map((value) => {
      const at = toPixel(event(value * unit.size));
      return { kind: 'text', role: 'axis', at: [at[0] + dx, at[1] + dy], text: plainNumber(value), anchor: 'middle' };
    });
  const name = (text: string, event: ChartEvent, [dx, dy]: PixelPoint): Mark => {
    const at = toPixel(event);
    return {
      kind: 'text',
      role: 'axis',
      at: [at[0] + dx, at[1] + dy],
      text: `${text} [${unit.name}]`,
      anchor: 'middle',
    };
  };
  const axes = [
    [toPixel([-span, 0, 0]), toPixel([span, 0, 0])],
    [toPixel([0, -span, 0]), toPixel([0, span, 0])],
    [toPixel([0, 0, -span]), toPixel([0, 0, span])],
  ];
  return [
    { kind: 'lines', role: 'frame', lines: [square], width: 1 },
    { kind: 'lines', role: 'axis', lines: axes, width: 1 },
    ...numbered((at) => [0, at, -span], [6, 16]),
    ...numbered((at) => [0, span, at], [20, 8]),
    ...numbered((at) => [at, 0, 0], [-14, 4]),
    name(x, [0, span, -span], [-10, 34]),
    name(y, [0, span, span], [0, -12]),
    name(ct, [span, 0, 0], [-34, 0]),
  ];
}
