import { mergeMeshes, transformMesh } from '../mesh/meshOps.ts';
import type { Mesh } from '../types.ts';
import type { Glyph } from './contours.ts';
import { type ExtrusionOptions, extrudeContours, extrusionTriangles } from './extrude.ts';

export interface TextStyle {
  /** Height of capital letters [m]. */
  readonly size: number;
  /** [m] */
  readonly depth: number;
  readonly align: 'left' | 'center' | 'right';
  /** What is added between letters, as a share of the size. */
  readonly spacing: number;
  /** From line to line, as a share of the size. */
  readonly lineHeight: number;
  /** How far the straight pieces may be from the curves, as a share of the size. */
  readonly tolerance: number;
}

/** Most triangles that a text may be of. */
export const MAX_TEXT_TRIANGLES = 1_000_000;

export function textTriangles(lines: readonly (readonly Glyph[])[], style: TextStyle): number {
  const known = new Map<Glyph, number>();
  return lines.flat().reduce((sum, letter) => {
    const count = known.get(letter) ?? extrusionTriangles(letter.contours, extrusionOf(letter, style));
    known.set(letter, count);
    return sum + count;
  }, 0);
}

/** Letters as solids in the plane z = 0, facing +z; the last line stands on y = 0, lines begin, have their middle or end at x = 0. */
export function textMesh(lines: readonly (readonly Glyph[])[], style: TextStyle): Mesh {
  const solids = new Map<Glyph, Mesh>();
  const parts = lines.flatMap((letters, line) => {
    const y = (lines.length - 1 - line) * style.lineHeight * style.size;
    const { xs, width } = layoutLine(letters, style);
    const start = { left: 0, center: -width / 2, right: -width }[style.align];
    return letters.flatMap((letter, i) => {
      if (letter.contours.length === 0) return [];
      const mesh = solids.get(letter) ?? extrudeContours(letter.contours, extrusionOf(letter, style));
      solids.set(letter, mesh);
      return [transformMesh(mesh, [1, 0, 0, start + xs[i], 0, 1, 0, y, 0, 0, 1, 0, 0, 0, 0, 1])];
    });
  });
  return mergeMeshes(parts);
}

/** Where the letters of a line stand, from its beginning, and how long it is [m]. */
function layoutLine(letters: readonly Glyph[], { size, spacing }: TextStyle) {
  let x = 0;
  const xs = letters.map(({ advance, capHeight }) => {
    const here = x;
    x += (advance / capHeight + spacing) * size;
    return here;
  });
  return { xs, width: Math.max(0, x - spacing * size) };
}

const extrusionOf = ({ capHeight }: Glyph, { size, depth, tolerance }: TextStyle): ExtrusionOptions => ({
  scale: size / capHeight,
  depth,
  tolerance: tolerance * size,
  tile: size,
});
