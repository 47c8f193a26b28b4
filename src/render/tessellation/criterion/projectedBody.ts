/** What is kept of a point: shown place (3), the place it is graded by (3), its weights of the triangle's second and third corner. */
export const POINT_FLOATS = 8;
/** Edges that are shown shorter are never cut [px]. */
export const MIN_EDGE_PIXELS = 6;
/** The same for curves with corners. */
export const MIN_KINKED_EDGE_PIXELS = 2;

/** What becomes of a cluster in a picture: */
export type ClusterState = typeof DRAWN | typeof TESSELLATED | typeof CULLED;
/** its triangles are drawn as they are, */
export const DRAWN = 0;
/** they are among the leaves, */
export const TESSELLATED = 1;
/** they are surely outside the picture. */
export const CULLED = 2;

/** Some triangles of one body in its batch's coordinates: a ball that holds them (at every sample, where they deform) and their longest edge [m]. */
export interface ClusterBounds {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly radius: number;
  readonly longestEdge: number;
  /** Of what deforms: its fastest vertex between samples, and the most by which a vertex's velocity changes at each [m/s]. */
  readonly maxSpeed: number;
  readonly velocityJumps?: Float64Array;
  /** How fast its velocities change between samples, at most [m/s²]. */
  readonly maxAcceleration?: number;
}

/** How the points of one body are shown in one picture, in f64. `take`, `point`, `outside` and `calm` do not allocate. */
export interface ProjectedBody {
  /** Curves have corners: velocities change suddenly. */
  readonly kinked: boolean;
  /** Conservative: DRAWN only where the criterion would cut no edge, OUTSIDE only where nothing is in the picture. */
  classify(lump: ClusterBounds): ClusterState;
  /** Chooses a triangle, by its vertices' places in the batch. */
  setTriangle(a: number, b: number, c: number): void;
  /** The chosen triangle is certainly seen from behind. */
  isBackFacing(): boolean;
  /** Fills the six coordinates of the point whose weights are at `out[at + 6 …]`; NaN where no light ever comes from it. */
  projectPoint(out: Float64Array, at: number): void;
  /** Certainly nothing of the part of the triangle between three points is in the picture, if its edges have been cut as the criterion asks. */
  isOutside(points: Float64Array, a: number, b: number, c: number): boolean;
  /** As `outside`, whatever its edges are. */
  isOutsideUncut(points: Float64Array, a: number, b: number, c: number): boolean;
  /** A triangle of which this is the longest edge needs no cutting, neither inside nor at its edges. */
  needsNoCut(points: Float64Array, a: number, b: number): boolean;
}
