import { scaleLinear } from 'd3-scale';
import { type LocalizedText, listed, msg } from '../messages/message.ts';
import { figureOf } from './figure.ts';
import { type LegendRow, legendMarks } from './legend.ts';
import type { Diagram, Mark, PixelPoint } from './marks.ts';
import { betaText, plainNumber } from './units.ts';

/** A body that the diagram marks. */
export interface DiagramBody {
  readonly name: LocalizedText;
  /** |u| = γβ, which is well-conditioned near c. */
  readonly properSpeed: number;
}

export interface EnergyDiagramSpec {
  readonly bodies: readonly DiagramBody[];
  /** [px] */
  readonly width: number;
  /** [px] */
  readonly height: number;
}

/** The largest energy over mc², and momentum over mc, of the axis. */
const TOP = 4;
/** Points of a curve: on a picture 4000 px wide a chord is still nearer than a quarter of a pixel. */
const POINTS = 512;
const NAMED = 10;

/** The curves over u = γβ, with m = c = 1; docs/physics.md §2.1. */
const CURVES = [
  { text: msg`Kinetic energy / mc²`, of: (u: number) => (u * u) / (1 + Math.hypot(1, u)), role: 0, dashed: false },
  { text: msg`classical: β²/2`, of: (u: number) => (u * u) / (2 * (1 + u * u)), role: 0, dashed: true },
  { text: msg`Momentum / mc`, of: (u: number) => u, role: 1, dashed: false },
  { text: msg`classical: β`, of: (u: number) => u / Math.hypot(1, u), role: 1, dashed: true },
] as const;

/**
 * Kinetic energy γ − 1 and momentum γβ over β, with m = c = 1, against the classical β²/2 and β; and where bodies are.
 */
export function energyDiagram({ bodies, width, height }: EnergyDiagramSpec): Diagram {
  const plot = figureOf(width, height);
  const x = scaleLinear()
    .domain([0, 1])
    .range([plot.left, plot.left + plot.width]);
  const y = scaleLinear()
    .domain([0, TOP])
    .range([plot.top + plot.height, plot.top]);
  const [left, bottom] = [x(0), y(0)];
  const text = (at: PixelPoint, what: LocalizedText, anchor: 'start' | 'middle' | 'end'): Mark => ({
    kind: 'text',
    role: 'axis',
    at,
    text: what,
    anchor,
  });
  const [betas, values] = [x.ticks(10), y.ticks(8)];
  const grid: PixelPoint[][] = [
    ...betas.map((beta): PixelPoint[] => [
      [x(beta), bottom],
      [x(beta), y(TOP)],
    ]),
    ...values.map((value): PixelPoint[] => [
      [left, y(value)],
      [x(1), y(value)],
    ]),
  ];
  const rows: LegendRow[] = [
    ...CURVES.map(
      (curve): LegendRow => ({ text: curve.text, role: curve.role, sample: curve.dashed ? 'dashes' : 'solid' }),
    ),
    ...bodies.slice(0, NAMED).map(
      ({ name, properSpeed }, n): LegendRow => ({
        text: msg`${name}: β = ${betaText(properSpeed)}`,
        role: n + 2,
        sample: 'filled',
      }),
    ),
    ...(bodies.length > NAMED
      ? [{ text: msg`${bodies.length - NAMED} more`, role: 'axis', sample: 'none' } as const]
      : []),
  ];
  return {
    width,
    height,
    title: msg`Energy and momentum over β`,
    description:
      bodies.length === 0
        ? msg`Relativistic kinetic energy and momentum grow without bound towards β = 1; the classical ones reach 1/2 and 1.`
        : msg`Relativistic kinetic energy and momentum grow without bound towards β = 1; the classical ones reach 1/2 and 1. Bodies: ${listed(bodies.slice(0, NAMED).map(({ name, properSpeed }) => msg`${name}: β = ${betaText(properSpeed)}`))}.`,
    marks: [
      { kind: 'lines', role: 'frame', lines: grid, width: 0.75 },
      {
        kind: 'lines',
        role: 'axis',
        lines: [
          [
            [left, y(TOP)],
            [left, bottom],
            [x(1), bottom],
          ],
        ],
        width: 1,
      },
      ...betas.map((beta) => text([x(beta), bottom + 17], plainNumber(beta), 'middle')),
      ...values.map((value) => text([left - 6, y(value) + 4], plainNumber(value), 'end')),
      text([x(1), bottom + 35], 'β', 'end'),
      ...CURVES.map(
        ({ of, role, dashed }): Mark => ({
          kind: 'lines',
          role,
          lines: [curvePoints(of).map(([beta, value]) => [x(beta), y(value)])],
          width: 2,
          dashed,
        }),
      ),
      ...bodies.flatMap(({ name, properSpeed: u }, n): Mark[] => {
        const beta = u / Math.hypot(1, u);
        const line: PixelPoint[] = [
          [x(beta), bottom],
          [x(beta), y(TOP)],
        ];
        const dots = CURVES.flatMap(({ of, dashed }): Mark[] =>
          of(u) <= TOP ? [{ kind: 'dot', role: n + 2, at: [x(beta), y(of(u))], filled: !dashed, title: name }] : [],
        );
        return [{ kind: 'lines', role: n + 2, lines: [line], width: 1 }, ...dots];
      }),
      ...legendMarks(rows, plot.legendAt, height),
    ],
  };
}

/** (β, value) up to the top of the axis, at equal steps of the rapidity, which are denser where the curves are steep. */
function curvePoints(of: (u: number) => number): readonly (readonly [number, number])[] {
  const end = Math.asinh(1e4);
  const points: [number, number][] = [];
  let last = 0;
  for (let i = 0; i <= POINTS; i++) {
    const zeta = (i / POINTS) ** 2 * end;
    const value = of(Math.sinh(zeta));
    if (value > TOP) {
      // The last piece ends on the axis' top.
      const s = (TOP - of(Math.sinh(last))) / (value - of(Math.sinh(last)));
      points.push([Math.tanh(last + s * (zeta - last)), TOP]);
      break;
    }
    points.push([Math.tanh(zeta), value]);
    last = zeta;
  }
  return points;
}
