import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { lerp, type Vec3, ZERO } from '../math/vec3.ts';
import { inEnglish } from '../messages/message.ts';
import { properVelocity } from '../physics/lorentz/boost.ts';
import type { HyperbolicLine } from '../physics/worldLines/kinds/hyperbolicLine.ts';
import type { WorldLine } from '../physics/worldLines/worldLine.ts';
import type { DiagramLine } from './diagramLines.ts';
import type { Mark, PixelPoint } from './marks.ts';
import { type SpacetimeDiagram, type SpacetimeDiagramSpec, spacetimeDiagram } from './spacetimeDiagram.ts';
import { diagramSvg } from './svg.ts';

const c = 10;
const ALWAYS = { birth: Number.NEGATIVE_INFINITY, death: Number.POSITIVE_INFINITY };
const named = (line: WorldLine, lifetime = ALWAYS): DiagramLine => ({ name: '/Thing', line, lifetime });
const moving = (beta: number, x = 0): DiagramLine =>
  named({ kind: 'uniform', position: [x, 0, 0], velocity: [beta * c, 0, 0] });
const drawn = (spec: Partial<SpacetimeDiagramSpec>): SpacetimeDiagram =>
  spacetimeDiagram({
    observer: { t: 0, position: ZERO, u: ZERO },
    speedOfLight: c,
    lines: [],
    frame: 'world',
    axis: [1, 0, 0],
    span: 10,
    // Without a legend.
    width: 500,
    height: 600,
    ...spec,
  });
const withBeta = (beta: number, t = 0, position: Vec3 = ZERO) => ({ t, position, u: properVelocity([beta, 0, 0]) });

type Lines = Extract<Mark, { kind: 'lines' }>;
type Dot = Extract<Mark, { kind: 'dot' }>;
const linesOf = ({ marks }: SpacetimeDiagram, role: Mark['role'], width: number): readonly (readonly PixelPoint[])[] =>
  marks
    .filter((mark): mark is Lines => mark.kind === 'lines' && mark.role === role && mark.width === width)
    .flatMap(({ lines }) => lines);
const dotsOf = ({ marks }: SpacetimeDiagram, filled: boolean): readonly PixelPoint[] =>
  marks
    .filter((mark): mark is Dot => mark.kind === 'dot' && typeof mark.role === 'number' && mark.filled === filled)
    .map(({ at }) => at);
const middle = ([a, b]: readonly PixelPoint[]): PixelPoint => [(a![0] + b![0]) / 2, (a![1] + b![1]) / 2];
/** (ct, x) relative to the observer's event, world [m]. */
const read = (diagram: SpacetimeDiagram, at: PixelPoint): readonly [number, number] => {
  const { ct, x } = diagram.eventAtPixel(at);
  return [ct, x[0]];
};

describe('a spacetime diagram of 1+1 dimensions', () => {
  it('shows light at 45° in both frames', () => {
    for (const frame of ['world', 'observer'] as const) {
      const cone = linesOf(drawn({ frame, observer: withBeta(0.8) }), 'pastCone', 2);
      expect(cone).toHaveLength(2);
      for (const [a, b] of cone) expect(Math.abs((b![0] - a![0]) / (b![1] - a![1]))).toBeCloseTo(1, 12);
    }
  });

  it('has numbers below its axis that do not touch, however narrow it is', () => {
    for (const width of [200, 230, 270, 320, 500])
      for (const span of [0.35, 10, 99, 1000]) {
        const { marks } = drawn({ width, span });
        const texts = marks.filter((mark) => mark.kind === 'text' && mark.anchor === 'middle' && mark.role === 'axis');
        const numbers = texts as Extract<Mark, { kind: 'text' }>[];
        expect(numbers.length).toBeGreaterThan(1);
        for (const [i, { at, text }] of numbers.entries()) {
          const before = numbers[i - 1];
          // A digit of 12 px is 7.5 px wide.
          const halves = before ? (7.5 * (inEnglish(text).length + inEnglish(before.text).length)) / 2 : 0;
          if (before) expect(at[0] - before.at[0]).toBeGreaterThan(halves);
        }
      }
  });

  it('has names of the other frame’s axes that do not touch, in the picture, however near to c it is', () => {
    for (const frame of ['world', 'observer'] as const)
      for (const beta of [0.1, 0.6, 0.9, 0.99, 0.999999, -0.1, -0.6, -0.99, -0.999999])
        for (const size of [
          { width: 500, height: 600 },
          { width: 1200, height: 800 },
          { width: 270, height: 300 },
        ]) {
          const { marks } = drawn({ frame, observer: withBeta(beta), ...size });
          const texts = marks.filter((mark) => mark.kind === 'text' && mark.role === 'otherAxis');
          const [ct, x] = (texts as Extract<Mark, { kind: 'text' }>[]).map(({ at, text, anchor }) => {
            // 12 px high, and no letter is wider than 7 px.
            const width = 7 * inEnglish(text).length;
            const left = at[0] - width * { start: 0, middle: 0.5, end: 1 }[anchor];
            return { left, right: left + width, top: at[1] - 10, bottom: at[1] + 2 };
          });
          const apart = ct!.right < x!.left || x!.right < ct!.left || ct!.bottom < x!.top || x!.bottom < ct!.top;
          expect(apart).toBe(true);
          for (const { left, right, top, bottom } of [ct!, x!]) {
            expect(Math.min(left, top)).toBeGreaterThan(0);
            expect(right).toBeLessThan(size.width);
            expect(bottom).toBeLessThan(size.height);
          }
        }
  });

  it('has the axes of the observer at the angle arctan β to those of the world', () => {
    const diagram = drawn({ observer: withBeta(0.6) });
    const [clock] = linesOf(diagram, 'observer', 2.5);
    const [now] = linesOf(diagram, 'slice', 1.75);
    expect((clock![1]![0] - clock![0]![0]) / (clock![0]![1] - clock![1]![1])).toBeCloseTo(0.6, 12);
    expect((now![0]![1] - now![1]![1]) / (now![1]![0] - now![0]![0])).toBeCloseTo(0.6, 12);
  });

  it('has the ticks of all uniform movers from one event on the hyperbolae c²t² − x² = (k cΔτ)²', () => {
    fc.assert(
      fc.property(fc.double({ min: -0.95, max: 0.95, noNaN: true }), (beta) => {
        const diagram = drawn({ lines: [moving(beta)] });
        const rest = linesOf(drawn({ lines: [moving(0)] }), 0, 1.25).map((tick) => read(diagram, middle(tick))[0]);
        const step = Math.abs(rest[1]! - rest[0]!);
        for (const tick of linesOf(diagram, 0, 1.25)) {
          const [ct, x] = read(diagram, middle(tick));
          const own = Math.sign(ct) * Math.sqrt((ct - x) * (ct + x));
          expect(own / step).toBeCloseTo(Math.round(own / step), 9);
        }
      }),
    );
  });

  it('has the ticks of a hyperbolic line at x = (c²/a)(cosh(aτ/c) − 1)', () => {
    const a = 20;
    const line: HyperbolicLine = { kind: 'hyperbolic', position: ZERO, properAcceleration: [a, 0, 0], t0: 0 };
    const diagram = drawn({ lines: [named(line)] });
    const ticks = linesOf(diagram, 0, 1.25).map((tick) => read(diagram, middle(tick)));
    expect(ticks.length).toBeGreaterThan(4);
    for (const [ct, x] of ticks) {
      const zeta = Math.asinh((ct * a) / (c * c));
      expect((c * c * (Math.cosh(zeta) - 1)) / a).toBeCloseTo(x, 9);
    }
    const own = ticks.map(([ct]) => (c / a) * Math.asinh((ct * a) / (c * c)));
    for (let k = 2; k < own.length; k++) expect(own[k]! - own[k - 1]!).toBeCloseTo(own[1]! - own[0]!, 9);
  });

  it('keeps the chords of curves within a quarter of a pixel, in both frames', () => {
    fc.assert(
      fc.property(
        fc.double({ min: -0.9, max: 0.9, noNaN: true }),
        fc.double({ min: 1, max: 2000, noNaN: true }),
        fc.double({ min: -1, max: 1, noNaN: true }),
        fc.constantFrom('world', 'observer'),
        (beta, a, t0, frame) => {
          const line: HyperbolicLine = { kind: 'hyperbolic', position: ZERO, properAcceleration: [a, 0, 0], t0 };
          const diagram = drawn({ lines: [named(line)], observer: withBeta(beta), frame });
          for (const points of linesOf(diagram, 0, 2)) {
            for (let i = 1; i < points.length; i++) {
              for (const s of [0, 0.3, 0.5, 0.8]) {
                const [x, y] = lerp([...points[i - 1]!, 0], [...points[i]!, 0], s);
                expect(distanceToHyperbola(diagram, [x, y], line)).toBeLessThan(0.25);
              }
            }
          }
        },
      ),
      { numRuns: 60 },
    );
  });

  it('draws a twin whose clock counts 4 steps while that at home counts 5', () => {
    const away = {
      kind: 'polyline',
      times: Float64Array.of(-5, 0, 5),
      positions: Float64Array.of(0, 0, 0, 30, 0, 0, 0, 0, 0),
    } as const;
    const life = { birth: -5, death: 5.000001 };
    const twins = [named(away, life), { ...named({ kind: 'static', position: ZERO }, life), name: '/Home' }];
    const diagram = drawn({ lines: twins, span: 80 });
    const ticks = [0, 1].map((role) => linesOf(diagram, role, 1.25).length);
    expect(ticks).toEqual([5, 6]);
  });

  it('receives the flashes of an approaching clock by the Bondi factor k = √((1 + β)/(1 − β)) faster', () => {
    // The light of the tick at −τ of one who comes to the origin arrives there at −τ/k, k = 2 at 0.6 c.
    const beta = 0.6;
    const diagram = drawn({ lines: [moving(beta)] });
    for (const tick of linesOf(diagram, 0, 1.25)) {
      const [ct, x] = read(diagram, middle(tick));
      if (ct >= 0) continue;
      const own = -Math.sqrt((ct - x) * (ct + x));
      expect((ct + Math.abs(x)) / own).toBeCloseTo(0.5, 9);
    }
  });

  it('has what is seen on the past light cone and what is now on the slice, in both frames', () => {
    fc.assert(
      fc.property(
        fc.double({ min: -0.95, max: 0.95, noNaN: true }),
        fc.double({ min: -0.95, max: 0.95, noNaN: true }),
        fc.double({ min: -3, max: 3, noNaN: true }),
        fc.constantFrom('world', 'observer'),
        (beta, own, place, frame) => {
          const observer = withBeta(own, 7, [2, 0, 0]);
          const line = moving(beta, place + 2 - 7 * beta * c);
          const diagram = drawn({ lines: [line], observer, frame, span: 1000 });
          for (const at of dotsOf(diagram, true)) {
            const [ct, x] = read(diagram, at);
            expect(ct + Math.abs(x)).toBeCloseTo(0, 8);
          }
          const [now] = dotsOf(diagram, false);
          const [ct, x] = read(diagram, now!);
          expect(ct - own * x).toBeCloseTo(0, 8);
          expect(dotsOf(diagram, true)).toHaveLength(1);
        },
      ),
    );
  });

  it('shows nothing of what has not been born or has died', () => {
    const line: WorldLine = { kind: 'static', position: [4, 0, 0] };
    const born = drawn({ lines: [named(line, { birth: -0.2, death: 0.3 })] });
    expect(dotsOf(born, true)).toHaveLength(0);
    expect(dotsOf(born, false)).toHaveLength(1);
    const [path] = linesOf(born, 0, 2);
    expect(path!.map((at) => read(born, at)[0])).toEqual([expect.closeTo(-2, 9), expect.closeTo(3, 9)]);
    expect(linesOf(drawn({ lines: [named(line, { birth: 99, death: 100 })] }), 0, 2)).toEqual([]);
  });

  it('stays within its window', () => {
    const spec = { lines: [moving(0.99, 3), moving(-0.3, -8)], observer: withBeta(-0.9) };
    for (const frame of ['world', 'observer'] as const) {
      const points = [0, 1].flatMap((role) => linesOf(drawn({ ...spec, frame }), role, 2).flat());
      for (const [x, y] of points) {
        expect(x).toBeGreaterThan(57.9);
        expect(x).toBeLessThan(484.1);
        expect(y).toBeGreaterThan(23.9);
        expect(y).toBeLessThan(556.1);
      }
    }
  });

  it('tells of lines beside the axis, whose events lie within the cone', () => {
    const text = (y: number) =>
      inEnglish(drawn({ lines: [named({ kind: 'static', position: [3, y, 0] })] }).description);
    expect(text(4)).toContain('Beside the axis');
    expect(text(0)).not.toContain('Beside the axis');
  });
});

describe('a spacetime diagram of 2+1 dimensions', () => {
  const plane = { secondAxis: [0, 1, 0] as const };

  it('reads the place under a pixel back', () => {
    const diagram = drawn({ ...plane, lines: [named({ kind: 'static', position: [3, 4, 0] })] });
    // A resting thing is now where it always is.
    const [now] = dotsOf(diagram, false);
    const { ct, x } = diagram.eventAtPixel(now!);
    expect([ct, ...x].map((value) => Math.round(value * 1e9) / 1e9 + 0)).toEqual([0, 3, 4, 0]);
  });

  it('has the emission of what is 5 m away 5 m of light earlier, straight below', () => {
    const diagram = drawn({ ...plane, lines: [named({ kind: 'static', position: [3, 4, 0] })] });
    const [[x0, y0], [x1, y1]] = [dotsOf(diagram, false)[0]!, dotsOf(diagram, true)[0]!];
    expect(x1).toBeCloseTo(x0, 9);
    const clock = linesOf(diagram, 'observer', 2.5)[0]!;
    const perMetre = (clock[0]![1] - clock[1]![1]) / 20;
    expect((y1 - y0) / perMetre).toBeCloseTo(5, 9);
  });

  it('has cone outlines that touch the circles: nothing of a circle is beyond them', () => {
    const cone = linesOf(drawn(plane), 'futureCone', 1.5);
    const [ring, , left, right] = cone;
    for (const [apex, edge] of [left!, right!]) {
      const side = (p: PixelPoint) =>
        (edge![0] - apex![0]) * (p[1] - apex![1]) - (edge![1] - apex![1]) * (p[0] - apex![0]);
      const sides = ring!.map(side);
      const scale = Math.max(...sides.map(Math.abs));
      expect(Math.min(Math.max(...sides), -Math.min(...sides)) / scale).toBeLessThan(1e-3);
    }
  });
});

it('is SVG in which names of a file stay text', () => {
  const line: DiagramLine = { ...moving(0.5), name: '</title><script>&"\u0007' };
  const svg = diagramSvg(drawn({ lines: [line] }), 'light', inEnglish);
  expect(svg).not.toContain('<script');
  expect(svg).toContain('&lt;/title&gt;&lt;script&gt;&amp;&quot;\ufffd');
  expect(svg.match(/<title>/g)!.length).toBe(svg.match(/<\/title>/g)!.length);
});

/** Distance in pixels of a pixel from the path, along the pixel's own column or row, whichever is nearer. */
function distanceToHyperbola(diagram: SpacetimeDiagram, at: PixelPoint, line: HyperbolicLine): number {
  // (x + ℓ)² − c²(t − t0)² − ℓ² vanishes on it: over its gradient it is the distance, to first order.
  const l = (c * c) / line.properAcceleration[0];
  const miss = (pixel: PixelPoint): number => {
    const [ct, x] = read(diagram, pixel);
    const s = ct - c * line.t0;
    return x * (x + 2 * l) - s * s;
  };
  const h = 1e-3;
  const dx = (miss([at[0] + h, at[1]]) - miss([at[0] - h, at[1]])) / (2 * h);
  const dy = (miss([at[0], at[1] + h]) - miss([at[0], at[1] - h])) / (2 * h);
  return Math.abs(miss(at)) / Math.hypot(dx, dy);
}
