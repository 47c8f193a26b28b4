import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { dot, length, normalize, type Vec3 } from '../../../math/vec3.ts';
import { coveredFaces } from './coveredFaces.ts';
import { CUBE_FACES, cubeFaceOf, nearestCosine } from './cubeFaces.ts';
import { domeLens } from './fisheyeLens.ts';
import { type Lens, lensDirection, lensPixel, pixelSolidAngle, pixelsPerRadian } from './lenses.ts';
import { perspective } from './perspectiveLens.ts';

const SIZE = { width: 240, height: 120 };
const LENSES: readonly (readonly [string, Lens, solidAngle: number])[] = [
  ['perspective', perspective(1), 4 * Math.asin(Math.sin(Math.atan(2 * Math.tan(0.5))) * Math.sin(0.5))],
  ['equirectangular', { kind: 'equirectangular' }, 4 * Math.PI],
  ['fisheye of 180°', { kind: 'fisheye', aperture: Math.PI, elevation: 0 }, 2 * Math.PI],
  [
    'fisheye of 300°',
    { kind: 'fisheye', aperture: (5 / 3) * Math.PI, elevation: 0.4 },
    2 * Math.PI * (1 - Math.cos((5 / 6) * Math.PI)),
  ],
  ['cube', { kind: 'cube', layout: '3x2' }, 4 * Math.PI],
  ['row of faces', { kind: 'cube', layout: '6x1' }, 4 * Math.PI],
  ['stereo', { kind: 'stereo', separation: 0.063 }, 8 * Math.PI],
];
const inPicture = fc.tuple(fc.double({ min: 0, max: 1, noNaN: true }), fc.double({ min: 0, max: 1, noNaN: true }));
const directions = fc
  .tuple(...([0, 1, 2] as const).map(() => fc.double({ min: -1, max: 1, noNaN: true })))
  .filter((v) => length(v as unknown as Vec3) > 0.1)
  .map((v) => normalize(v as unknown as Vec3));

describe.each(LENSES)('a lens: %s', (_, lens, solidAngle) => {
  it('shows a direction where it is looked for', () => {
    fc.assert(
      fc.property(inPicture, ([right, down]) => {
        // Pixels' centres: on an edge between faces a direction has several places.
        const [x, y] = [Math.floor(right * (SIZE.width - 1)) + 0.5, Math.floor(down * (SIZE.height - 1)) + 0.5];
        const direction = lensDirection(lens, x, y, SIZE);
        if (!direction) return;
        expect(length(direction)).toBeCloseTo(1, 12);
        const [px, py] = lensPixel(lens, direction, SIZE)!;
        // Of two eyes the left one's.
        if (lens.kind === 'stereo' && y > SIZE.height / 2) return;
        expect(Math.hypot(px - x, py - y)).toBeLessThan(1e-9);
      }),
    );
  });

  it('covers its solid angle', () => {
    const sum = (n: number): number => {
      let total = 0;
      const size = { width: 2 * n, height: n };
      for (let y = 0; y < size.height; y++)
        for (let x = 0; x < size.width; x++) total += pixelSolidAngle(lens, x + 0.5, y + 0.5, size);
      return total;
    };
    expect(Math.abs(sum(240) / solidAngle - 1)).toBeLessThan(0.005);
  });

  it('has pixels that are the derivative of their directions', () => {
    fc.assert(
      fc.property(inPicture, ([right, down]) => {
        const [x, y, h] = [right * (SIZE.width - 2) + 1, down * (SIZE.height - 2) + 1, 1e-4];
        const around = [
          [x - h, y],
          [x + h, y],
          [x, y - h],
          [x, y + h],
        ].map(([px, py]) => lensDirection(lens, px!, py!, SIZE));
        const [a, b, c, d] = around;
        if (!a || !b || !c || !d || new Set(around.map((n) => cubeFaceOf(n!).face)).size > 1) return;
        const cross = (p: Vec3, q: Vec3) =>
          Math.hypot(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]);
        const along = (p: Vec3, q: Vec3): Vec3 => [0, 1, 2].map((k) => (q[k]! - p[k]!) / (2 * h)) as unknown as Vec3;
        const area = cross(along(a, b), along(c, d));
        const told = pixelSolidAngle(lens, x, y, SIZE);
        expect(Math.abs(area - told)).toBeLessThan(1e-5 * told + 1e-9);
      }),
    );
  });
});

it('pixels per radian are the root of those per steradian where a lens resolves most', () => {
  const at = (lens: Lens, x: number, y: number) => pixelSolidAngle(lens, x, y, SIZE) ** -0.5;
  expect(pixelsPerRadian({ kind: 'equirectangular' }, SIZE)).toBeCloseTo(at({ kind: 'equirectangular' }, 120, 60), 9);
  const dome = domeLens(Math.PI, 0);
  expect(pixelsPerRadian(dome, SIZE)).toBeCloseTo(at(dome, 120, 0), 9);
});

describe('where things are', () => {
  const at = (lens: Lens, direction: Vec3, size = SIZE) => lensPixel(lens, direction, size)!.map((v) => Math.round(v));

  it('in an equirectangular picture: ahead in the middle, to the right three quarters across, up at the top', () => {
    const lens = { kind: 'equirectangular' } as const;
    expect(at(lens, [0, 0, -1])).toEqual([120, 60]);
    expect(at(lens, [1, 0, 0])).toEqual([180, 60]);
    expect(at(lens, [0, Math.SQRT1_2, -Math.SQRT1_2])).toEqual([120, 30]);
  });

  it('in a dome master: the zenith in the middle, ahead at the bottom, right at the right', () => {
    const size = { width: 200, height: 200 };
    const lens = domeLens(Math.PI, 0);
    expect(at(lens, [0, 1, 0], size)).toEqual([100, 100]);
    expect(at(lens, [0, 0, -1], size)).toEqual([100, 200]);
    expect(at(lens, [1, 0, 0], size)).toEqual([200, 100]);
    // A dome that is tilted forward by 30°: what is 60° up is its zenith.
    const tilted = domeLens(Math.PI, Math.PI / 6);
    expect(at(tilted, [0, Math.sin(Math.PI / 3), -Math.cos(Math.PI / 3)], size)).toEqual([100, 100]);
  });

  it('shows nothing outside the circle of a fisheye', () => {
    expect(lensDirection(domeLens(Math.PI, 0), 1, 1, { width: 100, height: 100 })).toBeUndefined();
    expect(pixelSolidAngle(domeLens(Math.PI, 0), 1, 1, { width: 100, height: 100 })).toBe(0);
  });
});

describe('the faces of the cube', () => {
  it('are right-handed, and each direction is on one of them', () => {
    fc.assert(
      fc.property(directions, (direction) => {
        const { face, x, y } = cubeFaceOf(direction);
        expect(Math.max(Math.abs(x), Math.abs(y))).toBeLessThanOrEqual(1 + 1e-12);
        const { forward, right, up } = CUBE_FACES[face]!;
        const rebuilt = normalize([0, 1, 2].map((k) => forward[k]! + x * right[k]! + y * up[k]!) as unknown as Vec3);
        expect(dot(rebuilt, direction)).toBeGreaterThan(1 - 1e-12);
      }),
    );
  });

  it('have the nearest direction to an axis that sampling finds', () => {
    fc.assert(
      fc.property(directions, fc.integer({ min: 0, max: 5 }), (axis, k) => {
        const face = CUBE_FACES[k]!;
        const { forward, right, up } = face;
        let most = -1;
        for (let i = 0; i <= 40; i++)
          for (let j = 0; j <= 40; j++) {
            const n = [0, 1, 2].map((c) => forward[c]! + (i / 20 - 1) * right[c]! + (j / 20 - 1) * up[c]!);
            most = Math.max(most, dot(normalize(n as unknown as Vec3), axis));
          }
        expect(nearestCosine(face, axis)).toBeGreaterThan(most - 1e-9);
        expect(nearestCosine(face, axis)).toBeLessThan(most + 2e-3);
      }),
    );
  });

  it('that a lens sees: five for an upright dome, one for a narrow fisheye, all for the whole sphere', () => {
    expect(coveredFaces(domeLens(Math.PI, 0))).toHaveLength(5);
    expect(coveredFaces({ kind: 'fisheye', aperture: 1, elevation: 0 })).toEqual([CUBE_FACES[4]]);
    expect(coveredFaces({ kind: 'equirectangular' })).toHaveLength(6);
  });
});
