import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { add, distance, scale, type Vec3 } from '../../math/vec3.ts';
import type { HypersurfaceName } from '../../physics/worldLines/hypersurface.ts';
import type { PolylineLine } from '../../physics/worldLines/kinds/polylineLine.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import { intersect, type Observation, sampleWindow, worldTubeSection } from './observation.ts';

const C = 2;
const number = (max: number) => fc.double({ min: -max, max, noNaN: true });
const vector = (max: number) => fc.tuple(number(max), number(max), number(max));
/** Shorter than 1. */
const short = vector(0.57);

/** The kinds of the world lines of bodies. */
type BodyLine = Extract<WorldLine, { readonly kind: 'static' | 'uniform' | 'hyperbolic' | 'polyline' }>;

const polyline = fc.array(short, { minLength: 2, maxLength: 12 }).map((velocities): PolylineLine => {
  const times = Float64Array.from(velocities, (_, k) => k - 9);
  const positions = new Float64Array(3 * velocities.length);
  let at: Vec3 = [0.3, 2, -4];
  velocities.forEach((v, k) => {
    positions.set(at, 3 * k);
    at = add(at, scale(v, C));
  });
  return { kind: 'polyline', times, positions };
});
const line: fc.Arbitrary<BodyLine> = fc.oneof(
  vector(9).map((position): BodyLine => ({ kind: 'static', position })),
  fc.tuple(vector(9), short).map(([position, v]): BodyLine => ({ kind: 'uniform', position, velocity: scale(v, C) })),
  fc
    .tuple(vector(9), vector(2), number(3))
    .map(([position, properAcceleration, t0]): BodyLine => ({ kind: 'hyperbolic', position, properAcceleration, t0 })),
  polyline,
);
const hypersurfaceName = fc.constantFrom<HypersurfaceName>('past-light-cone', 'shallow-cone', 'slice', 'now');
const observation = fc
  .tuple(number(9), vector(9), vector(3), hypersurfaceName)
  .map(([t, position, u, hypersurface]): Observation => ({ t, position, u, c: C, hypersurface, coneSlope: 0.6 }));

/** The same line, shifted. */
function shifted(worldLine: BodyLine, by: Vec3): BodyLine {
  if ('position' in worldLine) return { ...worldLine, position: add(worldLine.position, by) };
  return { ...worldLine, positions: worldLine.positions.map((x, i) => x + by[i % 3]) };
}

describe('the section of a world tube', () => {
  it('contains the event of every line that stays within its radius', () => {
    fc.assert(
      fc.property(line, short, observation, number(3), (center, shift, observed, size) => {
        const radius = Math.abs(size);
        const event = intersect(shifted(center, scale(shift, radius)), observed);
        const section = worldTubeSection(center, radius, observed);
        if (!event) return;
        expect(section).toBeDefined();
        const slack = 1e-6 * (1 + Math.abs(event.ahead));
        expect(event.ahead).toBeGreaterThanOrEqual(section!.from - slack);
        expect(event.ahead).toBeLessThanOrEqual(section!.to + slack);
        expect(distance(event.offset, section!.sphere.center)).toBeLessThanOrEqual(section!.sphere.radius + slack);
      }),
      { numRuns: 1000 },
    );
  });

  it('is enclosed by the samples of its window', () => {
    fc.assert(
      fc.property(polyline, observation, (center, observed) => {
        const section = worldTubeSection(center, 0.5, observed)!;
        const [first, count] = sampleWindow(center, section, observed, 4096);
        const ahead = (k: number) => C * (center.times[k] - observed.t);
        const last = first + count - 1;
        expect(count).toBeGreaterThanOrEqual(2);
        expect(last).toBeLessThan(center.times.length);
        if (first > 0) expect(ahead(first)).toBeLessThanOrEqual(section.from);
        if (last < center.times.length - 1) expect(ahead(last)).toBeGreaterThanOrEqual(section.to);
      }),
    );
  });
});
