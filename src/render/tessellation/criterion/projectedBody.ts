/** Floats per point: its observer position (3), the place that it is graded by (3), its weights of the triangle's second and third corner (2). */
export const POINT_FLOATS = 8;
/** Edges that appear shorter are never split [px]. */
export const MIN_EDGE_PIXELS = 6;
/** The same for edges of round solids: an edge of ℓ pixels that turns by θ is off by ℓθ/8. */
export const MIN_ROUND_EDGE_PIXELS = 3;
/** The same for curves with kinks. */
export const MIN_KINKED_EDGE_PIXELS = 2;

/**
 * Second differences of round solids count this many times: their outlines run through the middles of patches, which are up to this many times as far off as
 * the patches' edges.
 */
export const ROUND_STRICTNESS = 2.5;

/** What a view does with a cluster. */
export type ClusterState = typeof DRAWN | typeof TESSELLATED | typeof CULLED;
/** Its triangles are drawn as they are. */
export const DRAWN = 0;
/** Its triangles are drawn as patches. */
export const TESSELLATED = 1;
/** Its triangles are certainly outside the picture. */
export const CULLED = 2;

/** Bounds of some triangles of one body in its batch's coordinates: a sphere that holds them (at every sample, if they deform) and their longest edge [m]. */
export interface ClusterBounds {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly radius: number;
  readonly longestEdge: number;
  /** How far a round solid's surface is from these triangles and their edges; the sphere holds it too. */
  readonly bulge?: number;
  /** Of deforming bodies: the speed of the fastest vertex between samples, and the largest change of a vertex's velocity at each sample [m/s]. */
  readonly maxSpeed: number;
  readonly velocityJumps?: Float64Array;
  /** Largest acceleration between samples [m/s²]. */
  readonly maxAcceleration?: number;
}

/** How the points of one body appear in one view, in f64. `setTriangle`, `projectPoint`, `isOutside` and `needsNoCut` do not allocate. */
export interface ProjectedBody {
  /** Whether curves have kinks, because velocities change suddenly. */
  readonly kinked: boolean;
  /** Whether its triangles stand for a round solid: then second differences count `ROUND_STRICTNESS` times. */
  readonly isRound: boolean;
  /** Conservative: DRAWN only if the criterion would split no edge, CULLED only if nothing is in the picture. */
  classify(cluster: ClusterBounds): ClusterState;
  /** Selects a triangle by the indices of its vertices in the batch. */
  setTriangle(a: number, b: number, c: number): void;
  /** Whether the selected triangle certainly faces away from the observer. */
  isBackFacing(): boolean;
  /** Writes the six coordinates of the point whose weights are at `out[at + 6 …]`; NaN if no light ever reaches the observer from it. */
  projectPoint(out: Float64Array, at: number): void;
  /** Whether the part of the triangle between three points is certainly outside the picture, if its edges are as short as the criterion demands. */
  isOutside(points: Float64Array, a: number, b: number, c: number): boolean;
  /** As `isOutside`, for edges of any length. */
  isOutsideUncut(points: Float64Array, a: number, b: number, c: number): boolean;
  /** Whether a triangle of which this is the longest edge needs no subdivision, neither inside nor at its edges. */
  needsNoCut(points: Float64Array, a: number, b: number): boolean;
}
