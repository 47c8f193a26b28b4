import { makeMesh } from '../mesh/makeMesh.ts';
import type { Mesh } from '../types.ts';
import { type Contour, type FlattenedContour, flattenContour, type Point2, twiceArea } from './contours.ts';
import { triangulateCap } from './triangulateCap.ts';

/** How outlines become a solid. */
export interface ExtrusionOptions {
  /** [m] per unit of the outlines. */
  readonly scale: number;
  /** [m], half of it before the plane of the letter and half behind. */
  readonly depth: number;
  /** How far a side may be from its curve [m]. */
  readonly tolerance: number;
  /** So many metres are 1 in texture coordinates. */
  readonly tile: number;
}

/** How many triangles `solid` makes: two for each side, and of each cap two less than corners for an island, two more for a hole. */
export function extrusionTriangles(contours: readonly Contour[], how: ExtrusionOptions): number {
  return flattenContours(contours, how).reduce((sum, { corners }) => {
    const cap = corners.length + (twiceArea(corners) < 0 ? -2 : 2);
    return sum + 2 * corners.length + 2 * cap;
  }, 0);
}

const flattenContours = (contours: readonly Contour[], { scale, tolerance }: ExtrusionOptions): FlattenedContour[] =>
  contours.map((contour) => flattenContour(contour, tolerance / scale)).filter(({ corners }) => corners.length > 2);

/**
 * A letter as a closed solid that stands in the plane z = 0 and faces +z. Caps are flat; sides have the normals of the curves, smooth
 * but where those have corners. Texture coordinates: x and y on the caps, the way along the outline and z on the sides.
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
      // Seen from behind, letters are mirrored, and so are their textures.
      this.corner(place, back, [0, 0, back ? -1 : 1], [(x * scale) / tile, (y * scale) / tile]);
    }
    this.faceCounts.push(3);
  }

  /** The sides of an outline whose corners begin at `first`. */
  sides({ corners, sides }: FlattenedContour, first: number): void {
    const { scale, depth, tile } = this.how;
    let along = 0;
    corners.forEach(([x, y], i) => {
      const next = (i + 1) % corners.length;
      const [nx, ny] = corners[next];
      const end = along + (Math.hypot(nx - x, ny - y) * scale) / tile;
      const { from, to } = sides[i];
      // Clockwise seen from the front: the way along the front's edge is backwards for who sees the side.
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
