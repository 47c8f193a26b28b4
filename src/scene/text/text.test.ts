import { describe, expect, it } from 'vitest';
import { eulerCharacteristic, openEdges, triangles, volume } from '../../../tests/support/meshes.ts';
import { readFont } from '../../cli/files/fonts.ts';
import { readGlyphs } from '../../formats/font/glyphs.ts';
import { cross, dot, length, normalize, sub } from '../../math/vec3.ts';
import { pointAt } from '../mesh/polygons.ts';
import { type Glyph, type Point2, twiceArea } from './contours.ts';
import { extrudeContours, extrusionTriangles } from './extrude.ts';
import { type TextStyle, textMesh } from './textMesh.ts';
import { triangulateCap } from './triangulateCap.ts';

// In 捷 earcut drops a corner that is on a line only up to rounding.
const LETTERS = 'Slowight BE8%@&ßΩЖ光速捷翱';
const letters = await readGlyphs(LETTERS, readFont);
const letter = (name: string): Glyph => letters.get(name)!;
const how = (name: string, tolerance = 1e-3) =>
  ({ scale: 1 / letter(name).capHeight, depth: 0.25, tolerance, tile: 1 }) as const;
const solidOf = (name: string, tolerance?: number) => extrudeContours(letter(name).contours, how(name, tolerance));

/** Area enclosed by the exact curves: between a parabola and its chord are two thirds of its triangle (Archimedes). */
function enclosed({ contours, capHeight }: Glyph): number {
  let twice = 0;
  for (const { start, segments } of contours) {
    let at = start;
    for (const { control, to } of segments) {
      twice += at[0] * to[1] - to[0] * at[1];
      if (control) twice += (2 / 3) * twiceArea([at, control, to]);
      at = to;
    }
  }
  return -twice / 2 / capHeight ** 2;
}
const named = [...LETTERS].filter((name) => name !== ' ');

describe('a solid letter', () => {
  it.each(named)('%s is closed and encloses the area of its curves times its depth', (name) => {
    const mesh = solidOf(name);
    expect(openEdges(mesh)).toBe(0);
    expect(Math.min(...triangles(mesh).map(([a, b, c]) => length(cross(sub(b, a), sub(c, a)))))).toBeGreaterThan(0);
    // Chords are off by the tolerance at most, and less than two letter heights of outline per contour are curved.
    const off = (tolerance: number): number =>
      Math.abs(volume(solidOf(name, tolerance)) / 0.25 - enclosed(letter(name)));
    const contours = letter(name).contours.length;
    expect(off(1e-3)).toBeLessThan(1e-3 * 4 * contours);
    expect(off(1e-5)).toBeLessThan(1e-5 * 4 * contours);
  });

  it.each([
    ['l', 2],
    ['i', 4],
    ['B', -2],
    ['8', -2],
    // A bar, and two rings.
    ['%', 2],
    ['@', 0],
  ])('%s has the correct number of holes', (name, euler) => {
    expect(eulerCharacteristic(solidOf(name))).toBe(euler);
  });

  it('has flat caps, and sides with perpendicular outward normals', () => {
    const mesh = solidOf('B');
    triangles(mesh).forEach(([a, b, c], t) => {
      const face = normalize(cross(sub(b, a), sub(c, a)));
      for (let k = 0; k < 3; k++) {
        const normal = pointAt(mesh.normals, mesh.indices[3 * t + k]);
        expect(length(normal)).toBeCloseTo(1, 6);
        // Half of the largest turn from chord to chord.
        expect(dot(normal, face)).toBeGreaterThan(0.95);
      }
    });
  });

  it('is smooth along curves, and has creases at corners', () => {
    const directions = (name: string): number => {
      const { positions, normals } = solidOf(name);
      const places = new Map<string, Set<string>>();
      for (let v = 0; v < positions.length / 3; v++) {
        const normal = pointAt(normals, v);
        if (Math.abs(normal[2]) > 0.5) continue;
        const place = pointAt(positions, v).join(' ');
        places.set(place, (places.get(place) ?? new Set()).add(normal.map((x) => x.toFixed(5)).join(' ')));
      }
      return Math.max(...[...places.values()].map((set) => set.size));
    };
    expect(directions('o')).toBe(1);
    expect(directions('l')).toBe(2);
  });

  it('has as many triangles as predicted', () => {
    for (const name of named)
      expect(solidOf(name).indices.length / 3).toBe(extrusionTriangles(letter(name).contours, how(name)));
  });
});

describe('a cap', () => {
  it('has no T-junctions where many corners are on one line', () => {
    // A comb, and a hole in line with its teeth: 13 corners lie on y = 0.
    const comb: Point2[] = [
      [0, 2],
      [6, 2],
    ];
    for (let tooth = 5; tooth >= 0; tooth--) {
      comb.push([tooth + 1, tooth % 2 ? 0 : -1], [tooth, tooth % 2 ? 0 : -1], [tooth, 0]);
    }
    const hole: Point2[] = [
      [1, 1],
      [2, 1],
      [3, 1],
      [3, 1.5],
      [1, 1.5],
    ];
    const all = [...comb, ...hole];
    const cut = triangulateCap([comb, hole]);
    const sides = new Map<string, number>();
    cut.forEach((a, i) => {
      const b = cut[i % 3 === 2 ? i - 2 : i + 1];
      sides.set(`${a} ${b}`, (sides.get(`${a} ${b}`) ?? 0) + 1);
    });
    const open = [...sides.keys()].filter((side) => !sides.has(side.split(' ').reverse().join(' ')));
    expect(open).toHaveLength(all.length);
    expect(Math.max(...sides.values())).toBe(1);
  });
});

describe('a text', () => {
  const style: TextStyle = { size: 2, depth: 0.5, align: 'left', spacing: 0, lineHeight: 1.5, tolerance: 1e-3 };
  const text = (lines: readonly string[], changes: Partial<TextStyle> = {}) =>
    textMesh(
      lines.map((line) => Array.from(line, letter)),
      { ...style, ...changes },
    );
  const range = (mesh: ReturnType<typeof text>, axis: number): readonly [number, number] => {
    const all = Array.from(mesh.positions).filter((_, i) => i % 3 === axis);
    return [Math.min(...all), Math.max(...all)];
  };

  it('stands on the ground with the given height of capitals, one line above the other', () => {
    expect(range(text(['B']), 1)).toEqual([0, expect.closeTo(2, 5)]);
    expect(range(text(['B']), 2)).toEqual([-0.25, 0.25]);
    expect(range(text(['E', 'BB', 'B']), 1)).toEqual([0, expect.closeTo(2 * 3 + 2, 5)]);
    expect(volume(text(['BE', 'B']))).toBeCloseTo(2 * volume(text(['B'])) + volume(text(['E'])), 4);
  });

  it('is aligned left, centre or right at x = 0, with additional letter spacing', () => {
    const width = (2 * letter('B').advance) / letter('B').capHeight;
    const [first] = range(text(['B']), 0);
    expect(range(text(['BB'], { align: 'right' }), 0)[0]).toBeCloseTo(first - 2 * width, 5);
    expect(range(text(['BB'], { align: 'center' }), 0)[0]).toBeCloseTo(first - width, 5);
    const [, end] = range(text(['BB']), 0);
    expect(range(text(['BB'], { spacing: 0.5 }), 0)[1]).toBeCloseTo(end + 1, 5);
    expect(range(text(['BB'], { spacing: 0.5, align: 'right' }), 0)[1]).toBeCloseTo(
      range(text(['B'], { align: 'right' }), 0)[1],
      5,
    );
  });
});
