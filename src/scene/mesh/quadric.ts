import { determinant } from '../../math/mat3.ts';
import { linearPart, type Mat4, multiply } from '../../math/mat4.ts';
import type { Vec3 } from '../../math/vec3.ts';
import type { Mesh, SceneObject } from '../types.ts';
import type { Quadric, QuadricShape } from './quadricTypes.ts';

/** With fewer segments than this a primitive is meant as the prism that its polygons are. */
export const ROUND_SEGMENTS = 20;

/** The round solid as which an object is seen; undefined if its polygons are, e.g. because they deform. */
export const quadricOf = ({ mesh, motion }: Pick<SceneObject, 'mesh' | 'motion'>): Quadric | undefined =>
  motion.kind === 'sampled-points' ? undefined : mesh.quadric;

/** The solid after x → M x of its mesh; a degenerate M leaves none. */
export function transformedQuadric(quadric: Quadric | undefined, m: Mat4): Pick<Mesh, 'quadric'> {
  if (!quadric) return {};
  const toMesh = multiply(m, quadric.toMesh);
  const size = Math.abs(determinant(linearPart(toMesh)));
  return size > 0 && Number.isFinite(size) ? { quadric: { ...quadric, toMesh } } : {};
}

/** The mesh as polygons alone, for changes after which it is no longer a round solid. */
export function withoutQuadric(mesh: Mesh): Mesh {
  const { quadric: _, ...polygons } = mesh;
  return polygons;
}

/** A band of faces between two circles, as in `revolve`, seen in the half plane of the axis. */
interface FacetBand {
  /** The first of its triangles. */
  readonly first: number;
  /** Which of its circles is a pole. */
  readonly pole: 'from' | 'to' | undefined;
  /** Place between its two circles, 0 … 1, and around the axis in faces. */
  readonly across: number;
}

/** Where a point is on the polygons: a triangle and the weights of its second and third corner. */
export interface QuadricFacet {
  /** Index of the triangle's first corner in `Mesh.indices`. */
  readonly corner: number;
  readonly v: number;
  readonly w: number;
}

/**
 * The triangle that stands for a point y of the solid's surface, and the point's place in it: polygons divide angle, latitude and height evenly. So uvs
 * and colours on the solid are those of its polygons. `part`: for cylinders and cones the side (0), the bottom (1) or the top (2).
 */
export function facetAt({ shape, segments, rings, toMesh }: Quadric, y: Vec3, part: number): QuadricFacet {
  const { first, pole, across } = bandAt(shape, y, part, segments, rings);
  const turns = Math.atan2(y[1], y[0]) / (2 * Math.PI);
  const around = (turns < 0 ? turns + 1 : turns) * segments;
  const face = Math.min(segments - 1, Math.floor(around));
  const aside = Math.min(1, around - face);
  const mirrored = determinant(linearPart(toMesh)) < 0;
  const at = (triangle: number, v: number, w: number): QuadricFacet => ({
    corner: 3 * (first + triangle),
    v: mirrored ? w : v,
    w: mirrored ? v : w,
  });
  // Faces have the corners (0, 0), (1, 0), (1, 1), (0, 1) of (aside, across), and those of a circle that is a pole are one.
  if (pole === 'from') return at(face, across * aside, across * (1 - aside));
  if (pole === 'to') return at(face, (1 - across) * aside, across);
  return across <= aside ? at(2 * face, aside - across, across) : at(2 * face + 1, aside, across - aside);
}

function bandAt(shape: QuadricShape, [x, y, z]: Vec3, part: number, segments: number, rings: number): FacetBand {
  const radial = Math.hypot(x, y);
  const clamped = (t: number) => Math.min(1, Math.max(0, t));
  const isPoint = shape.kind === 'cone';
  switch (shape.kind) {
    case 'sphere':
      return arcBand((rings * (Math.atan2(z, radial) + Math.PI / 2)) / Math.PI, rings, segments, 0, true, true);
    case 'cylinder':
    case 'cone': {
      if (part === 1) return { first: 0, pole: 'from', across: clamped(radial / shape.radius) };
      const up = clamped(z / shape.height + 0.5);
      if (part === 0) return { first: segments, pole: isPoint ? 'to' : undefined, across: up };
      return { first: 3 * segments, pole: 'to', across: 1 - clamped(radial / shape.radius) };
    }
    case 'capsule': {
      const half = shape.height / 2;
      const below = segments * (2 * rings - 1);
      const between = half > 0 ? 2 * segments : 0;
      if (half > 0 && Math.abs(z) < half)
        return { first: below, pole: undefined, across: clamped(z / shape.height + 0.5) };
      const latitude = Math.atan2(Math.abs(z) - half, radial) / (Math.PI / 2);
      return z > 0
        ? arcBand(rings * latitude, rings, segments, below + between, false, true)
        : arcBand(rings * (1 - latitude), rings, segments, 0, true, false);
    }
  }
}

/** The band of an arc divided into `rings`, whose ends may be poles; its triangles start at `first`. */
function arcBand(
  at: number,
  rings: number,
  segments: number,
  first: number,
  poleAtStart: boolean,
  poleAtEnd: boolean,
): FacetBand {
  const ring = Math.min(rings - 1, Math.max(0, Math.floor(at)));
  const before = first + segments * (2 * ring - (poleAtStart && ring > 0 ? 1 : 0));
  const pole = poleAtStart && ring === 0 ? 'from' : poleAtEnd && ring === rings - 1 ? 'to' : undefined;
  return { first: before, pole, across: Math.min(1, Math.max(0, at - ring)) };
}
