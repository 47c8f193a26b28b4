import type { Mat4 } from '../../math/mat4.ts';
import type { StoredSample } from './storedNumbers.ts';

/**
 * The samples of a deforming mesh that stay in their files: how to read each of them, and statistics of all. Plain data, so that other threads can read samples
 * themselves.
 */
export interface StreamedPoints {
  readonly samples: readonly StreamedSample[];
  /** By vertex of the mesh: index of its point in the file. */
  readonly pointOfVertex: Uint32Array;
  readonly shading: StreamedShading;
  /** 1 for each vertex that is not finite at some sample, and is therefore kept at the file's origin. Absent if there are none. */
  readonly nonFiniteVertices?: Uint8Array;
  readonly statistics: PointStatistics;
}

export interface StreamedSample {
  readonly points: StoredSample;
  /** From the file's axes and units to the world's, relative to the motion's origin. */
  readonly matrix: Mat4;
}

/** Source of normals: samples in the file, or computed from the faces within smoothing groups (normals.ts). */
export type StreamedShading =
  | { readonly kind: 'stored'; readonly normals: readonly StoredSample[] }
  | { readonly kind: 'faces'; readonly indices: Uint32Array; readonly groups: Uint32Array };

/** Statistics of all samples, kept so that they need not be read again. Positions are relative to the motion's origin [m]. */
export interface PointStatistics {
  /** By sample: its bounding box, min x y z, max x y z. */
  readonly boxes: Float64Array;
  /** By sample: radius of the bounding sphere around the centre of its box. */
  readonly radii: Float64Array;
  /** By piece between samples: the longest displacement of a vertex [m], or an upper bound, and the index of that vertex. */
  readonly displacements: Float64Array;
  readonly fastest: Uint32Array;
  /** The first sample with a coordinate that is not finite; −1 if there is none. */
  readonly firstNonFinite: number;
  /** 1 for each vertex that is not finite at some sample; absent if there is none. */
  readonly nonFiniteVertices?: Uint8Array;
}

/** How to read samples, before their statistics are computed. */
export type PointRecipe = Omit<StreamedPoints, 'statistics'>;
