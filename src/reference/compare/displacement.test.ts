import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { add, dot, scale, type Vec3 } from '../../math/vec3.ts';
import type { VisiblePoints } from './channels.ts';
import { displacement, LOST } from './displacement.ts';

const [width, height] = [20, 16];
const every = Array.from({ length: width * height }, (_, i) => i);

/** The object and world point shown at x, y of the picture [px]; undefined for the background. */
type World = (x: number, y: number) => { readonly object: number; readonly at: Vec3 } | undefined;

/** A picture of `world`, shifted by dx, dy to the right and down. */
function shown(world: World, dx = 0, dy = 0): VisiblePoints {
  const pixels = every.map((i) => world((i % width) - dx, Math.floor(i / width) - dy));
  const axis = (k: number) => Float32Array.from(pixels, (pixel) => pixel?.at[k] ?? 0);
  return { object: pixels.map((pixel) => pixel?.object ?? 0), position: [axis(0), axis(1), axis(2)] };
}
const moved = (world: World, dx: number, dy: number) => displacement(shown(world, dx, dy), shown(world), width, height);

/** The plane n · X = d seen by a pinhole camera at the origin, focal length 30 px, horizon at the row `horizon`. */
function plane(n: Vec3, d: number, horizon: number): World {
  return (x, y) => {
    const ray: Vec3 = [(x - width / 2) / 30, (horizon - y) / 30, -1];
    const t = d / dot(n, ray);
    return t > 0 ? { object: 1, at: scale(ray, t) } : undefined;
  };
}
const wall: World = (x, y) => ({ object: 1, at: [0.1 * x, -0.1 * y, -3] });

describe('a shifted picture', () => {
  it('of a wall: every pixel is displaced by the shift', () => {
    const pixels = fc.double({ min: -6, max: 6, noNaN: true });
    fc.assert(
      fc.property(pixels, pixels, (dx, dy) => {
        const found = moved(wall, dx, dy);
        expect([found.measured, found.lost]).toEqual([width * height, 0]);
        for (const value of found.pixels) expect(value).toBeCloseTo(Math.hypot(dx, dy), 3);
      }),
      { numRuns: 40 },
    );
  });

  it.each([0, 0.1, 0.5, 1])('of a slanting floor in perspective, by %d px', (shift) => {
    const { pixels, measured } = moved(plane([0.2, 1, 0], -2, -20), 0.6 * shift, 0.8 * shift);
    expect(measured).toBe(width * height);
    // First order only: the metres per pixel grow by some percent from pixel to pixel.
    for (const value of pixels) expect(Math.abs(value - shift)).toBeLessThan(1e-4 + 0.06 * shift);
  });

  it('of two faces of one object that meet in an edge', () => {
    const [left, right] = [plane([0.8, 0, -1], 4, 8), plane([-1.5, 0, -1], 4, 8)];
    const corner: World = (x, y) => {
      const [p, q] = [left(x, y), right(x, y)];
      return p && q && dot(p.at, p.at) < dot(q.at, q.at) ? p : q;
    };
    const { pixels, lost } = moved(corner, 0.2, 0);
    expect(lost).toBe(0);
    // In the two columns beside the edge the central difference mixes both faces.
    pixels.forEach((value, i) => {
      const beside = Math.abs((i % width) - width / 2) <= 1;
      expect(Math.abs(value - 0.2)).toBeLessThan(beside ? 0.1 : 0.02);
    });
  });
});

describe('outlines', () => {
  const square: World = (x, y) => (x > 5.2 && x < 12.2 && y > 4.2 && y < 11.2 ? wall(x, y) : undefined);

  it('a pixel where only A shows the object is measured from its neighbour', () => {
    const { pixels, lost } = moved(square, 1, 0);
    expect(lost).toBe(0);
    for (const value of pixels.filter(Number.isFinite)) expect(value).toBeCloseTo(1, 3);
    expect(pixels.filter(Number.isFinite)).toHaveLength(49);
  });

  it('an object or background that B does not show within a pixel is lost', () => {
    const { pixels, lost } = moved(square, 3, 0);
    // Two columns of the object are too far in the background; two of the background too far in the object, except for their ends.
    expect(lost).toBe(2 * 7 + 2 * 5);
    expect(pixels[8 * width + 15]).toBe(LOST);
    expect(pixels[8 * width + 7]).toBe(LOST);
    expect(pixels[8 * width + 10]).toBeCloseTo(3, 3);
  });

  it('another object at the same points is lost', () => {
    const other: World = (x, y) => ({ object: 2, at: wall(x, y)?.at ?? [0, 0, 0] });
    expect(displacement(shown(other), shown(wall), width, height).lost).toBe(width * height);
  });

  it('an object of one pixel in B has no displacement', () => {
    const dot: World = (x, y) => (x === 7 && y === 7 ? wall(x, y) : undefined);
    expect(moved(dot, 0, 0)).toMatchObject({ measured: 0, lost: 0 });
  });

  it('near and far parts of one object that overlaps itself are distinguished', () => {
    const far: World = (x, y) => {
      const near = wall(x, y);
      return near && x > 9.5 ? { object: 1, at: add(near.at, [0, 0, -40]) } : near;
    };
    for (const value of moved(far, 0.3, 0).pixels) expect(value).toBeCloseTo(0.3, 3);
  });
});

it('an error in depth alone does not displace a wall seen head-on', () => {
  const nearer: World = (x, y) => {
    const there = wall(x, y);
    return there && { object: 1, at: add(there.at, [0, 0, 1]) };
  };
  for (const value of displacement(shown(nearer), shown(wall), width, height).pixels) expect(value).toBeCloseTo(0, 6);
});
