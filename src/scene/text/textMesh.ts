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
  /** Letter spacing, relative to the size. */
  readonly spacing: number;
  /** Line height, relative to the size. */
  readonly lineHeight: number;
  /** Maximum distance of segments from the curves, relative to the size. */
  readonly tolerance: number;
}

/** Maximum number of triangles of a text. */
export const MAX_TEXT_TRIANGLES = 1_000_000;

export function textTriangles(lines: readonly (readonly Glyph[])[], style: TextStyle): number {
  const known = new Map<Glyph, number>();
  return lines.flat().reduce((sum, letter) => {
    const count = known.get(letter) ?? extrusionTriangles(letter.contours, extrusionOf(letter, style));
    known.set(letter, count);
    return sum + count;
  }, 0);
}

/** Text as solids in the plane z = 0, facing +z; the last line's baseline is y = 0, lines are aligned at x = 0 by their start, middle or end. */
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

/** Positions of a line's letters from its start, and its length [m]. */
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
