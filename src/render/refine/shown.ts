/** What is kept of a point: shown place (3), the place it is graded by (3), its weights of the triangle's second and third corner. */
export const POINT = 8;
/** Edges that are shown shorter are never cut [px]. */
export const SHORTEST = 6;
/** The same for curves with corners. */
export const SHORTEST_KINKED = 2;

/** What becomes of a cluster in a picture: */
export type Fate = typeof DRAWN | typeof REFINED | typeof OUTSIDE;
/** its triangles are drawn as they are, */
export const DRAWN = 0;
/** they are among the leaves, */
export const REFINED = 1;
/** they are surely outside the picture. */
export const OUTSIDE = 2;

/** Some triangles of one body in its batch's coordinates: a ball that holds them (at every sample, where they deform) and their longest edge [m]. */
export interface Lump {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly radius: number;
  readonly longest: number;
  /** Of what deforms: its fastest vertex between samples, and the most by which a vertex's velocity changes at each [m/s]. */
  readonly speed: number;
  readonly jolts?: Float64Array;
  /** How fast its velocities change between samples, at most [m/s²]. */
  readonly rate?: number;
}

/** How the points of one body are shown in one picture, in f64. `take`, `point`, `outside` and `calm` do not allocate. */
export interface Shown {
  /** Curves have corners: velocities change suddenly. */
  readonly kinked: boolean;
  /** Conservative: DRAWN only where the criterion would cut no edge, OUTSIDE only where nothing is in the picture. */
  fate(lump: Lump): Fate;
  /** Chooses a triangle, by its vertices' places in the batch. */
  take(a: number, b: number, c: number): void;
  /** The chosen triangle is certainly seen from behind. */
  turnedAway(): boolean;
  /** Fills the six coordinates of the point whose weights are at `out[at + 6 …]`; NaN where no light ever comes from it. */
  point(out: Float64Array, at: number): void;
  /** Certainly nothing of the part of the triangle between three points is in the picture, if its edges have been cut as the criterion asks. */
  outside(points: Float64Array, a: number, b: number, c: number): boolean;
  /** As `outside`, whatever its edges are. */
  surelyOutside(points: Float64Array, a: number, b: number, c: number): boolean;
  /** A triangle of which this is the longest edge needs no cutting, neither inside nor at its edges. */
  calm(points: Float64Array, a: number, b: number): boolean;
}
