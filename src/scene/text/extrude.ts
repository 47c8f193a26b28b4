import { makeMesh } from '../mesh/makeMesh.ts';
import type { Mesh } from '../types.ts';
import { type Contour, type FlattenedContour, flattenContour, type Point2, twiceArea } from './contours.ts';
import { triangulateCap } from './triangulateCap.ts';

/** Options of an extrusion. */
export interface ExtrusionOptions {
  /** [m] per unit of the outlines. */
  readonly scale: number;
  /** Depth [m], centred on the plane of the glyph. */
  readonly depth: number;
  /** Maximum distance of a segment from its curve [m]. */
  readonly tolerance: number;
  /** Metres per texture coordinate unit. */
  readonly tile: number;
}

/** Number of triangles of `solid`: two per segment, and per cap two fewer than corners for an island, two more for a hole. */
export function extrusionTriangles(contours: readonly Contour[], how: ExtrusionOptions): number {
  return flattenContours(contours, how).reduce((sum, { corners }) => {
    const cap = corners.length + (twiceArea(corners) < 0 ? -2 : 2);
    return sum + 2 * corners.length + 2 * cap;
  }, 0);
}

const flattenContours = (contours: readonly Contour[], { scale, tolerance }: ExtrusionOptions): FlattenedContour[] =>
  contours.map((contour) => flattenContour(contour, tolerance / scale)).filter(({ corners }) => corners.length > 2);

/**
 * A glyph as a closed solid in the plane z = 0, facing +z. Caps are flat; sides have the normals of the curves,
 * smooth except at corners. Texture coordinates: x and y on the caps, arc length and z on the sides.
 */
export function extrudeContours(contours: readonly Contour[], how: ExtrusionOptions): Mesh {
  const outlines = flattenContours(contours, how);
  const corners = outlines.flatMap((outline) => outline.corners);
  const builder = new ExtrusionBuilder(corners, how);
  builder.caps(triangulateCap(outlines.map((outline) => outline.corners)));
  let first = 0;
  for (const outline of outlines) {
    builder.sides(outline, first);
    first += outline.corners.length;
  }
  return builder.mesh();
}

/** Points, front ones before back ones, and the corners of faces with their normals and texture coordinates. */
class ExtrusionBuilder {
  private readonly corners: readonly Point2[];
  private readonly how: ExtrusionOptions;
  private readonly faceCounts: number[] = [];
  private readonly faceIndices: number[] = [];
  private readonly normals: number[] = [];
  private readonly uvs: number[] = [];

  constructor(corners: readonly Point2[], how: ExtrusionOptions) {
    this.corners = corners;
    this.how = how;
  }

  caps(triangles: readonly number[]): void {
    for (let i = 0; i < triangles.length; i += 3) {
      const [a, b, c] = [triangles[i], triangles[i + 1], triangles[i + 2]];
      this.capFace([a, b, c], 0);
      this.capFace([a, c, b], 1);
    }
  }

  private capFace(places: readonly number[], back: 0 | 1): void {
    const { scale, tile } = this.how;
    for (const place of places) {
      const [x, y] = this.corners[place];
      // From behind, glyphs and their textures are mirrored.
      this.corner(place, back, [0, 0, back ? -1 : 1], [(x * scale) / tile, (y * scale) / tile]);
    }
    this.faceCounts.push(3);
  }

  /** The sides of an outline; `first`: index of its first corner. */
  sides({ corners, sides }: FlattenedContour, first: number): void {
    const { scale, depth, tile } = this.how;
    let along = 0;
    corners.forEach(([x, y], i) => {
      const next = (i + 1) % corners.length;
      const [nx, ny] = corners[next];
      const end = along + (Math.hypot(nx - x, ny - y) * scale) / tile;
      const { from, to } = sides[i];
      // Clockwise from the front, so the front edge runs backwards seen from the side's outside.
      this.corner(first + i, 0, [from[0], from[1], 0], [along, depth / tile]);
      this.corner(first + next, 0, [to[0], to[1], 0], [end, depth / tile]);
      this.corner(first + next, 1, [to[0], to[1], 0], [end, 0]);
      this.corner(first + i, 1, [from[0], from[1], 0], [along, 0]);
      this.faceCounts.push(4);
      along = end;
    });
  }

  private corner(place: number, back: 0 | 1, normal: readonly number[], uv: Point2): void {
    this.faceIndices.push(place + back * this.corners.length);
    this.normals.push(...normal);
    this.uvs.push(...uv);
  }

  mesh(): Mesh {
    const { scale, depth } = this.how;
    const at = (z: number): number[] => this.corners.flatMap(([x, y]) => [x * scale, y * scale, z]);
    const { faceCounts, faceIndices, normals, uvs } = this;
    return makeMesh({
      points: [...at(depth / 2), ...at(-depth / 2)],
      faceCounts,
      faceIndices,
      normals: { per: 'corner', values: normals },
      uvs: { per: 'corner', values: uvs },
    }).mesh;
  }
}
