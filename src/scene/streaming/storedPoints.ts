import type { Mat4 } from '../../math/mat4.ts';
import type { StoredSample } from './storedNumbers.ts';

/**
 * The samples of a deforming mesh, left in their files: what it takes to make any one of them, and what had to be known of
 * all. Plain data: threads that it is sent to read for themselves.
 */
export interface StreamedPoints {
  readonly samples: readonly StreamedSample[];
  /** Of the file's points, the one that each vertex of the mesh is. */
  readonly pointOfVertex: Uint32Array;
  readonly shading: StreamedShading;
  /** A 1 for each vertex that is nowhere at some sample: it is kept at the file's origin. Absent where there is none. */
  readonly nonFiniteVertices?: Uint8Array;
  readonly statistics: PointStatistics;
}

export interface StreamedSample {
  readonly points: StoredSample;
  /** From the file's axes and units to the world's, from the motion's origin. */
  readonly matrix: Mat4;
}

/** Where normals come from: the file, sample by sample, or the faces, within the smoothing groups (normals.ts). */
export type StreamedShading =
  | { readonly kind: 'stored'; readonly normals: readonly StoredSample[] }
  | { readonly kind: 'faces'; readonly indices: Uint32Array; readonly groups: Uint32Array };

/** What is known of every sample without reading it again. Places are from the motion's origin [m]. */
export interface PointStatistics {
  /** Of each sample: its box, least x y z, greatest x y z. */
  readonly boxes: Float64Array;
  /** Of each sample: of the sphere round the middle of its box. */
  readonly radii: Float64Array;
  /** Of each piece between samples: the longest way of a vertex [m], or no less, and which vertex goes it. */
  readonly displacements: Float64Array;
  readonly fastest: Uint32Array;
  /** The first sample with a number that is not finite; −1 where there is none. */
  readonly firstNonFinite: number;
  /** A 1 for each vertex that is nowhere at some sample, where there is one. */
  readonly nonFiniteVertices?: Uint8Array;
}

/** How to make samples, before anything is known of them. */
export type PointRecipe = Omit<StreamedPoints, 'statistics'>;
