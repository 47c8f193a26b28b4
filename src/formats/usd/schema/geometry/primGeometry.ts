import type { StoredSample } from '../../../../scene/streaming/storedNumbers.ts';
import type { Mesh, SampledMotion, SampledPointsMotion, StaticMotion } from '../../../../scene/types.ts';
import type { StageTransform } from '../transforms/stageTransform.ts';

/** A mesh in its prim's own axes and stage units, and how its points change with time in there. */
export interface PrimGeometry {
  /** At the stage's start. */
  readonly mesh: Mesh;
  readonly deformation?: Deformation;
  /** Where it is, if not where its prim is: a skeleton carries it. */
  readonly transform?: StageTransform;
}

export interface Deformation {
  readonly times: Float64Array;
  /** New arrays each time. */
  at(time: number): DeformedPoints;
  /** As the file gives them [units per second], 3 per vertex, in a new array; absent where it does not, or not at all times. */
  velocitiesAt?(time: number): Float32Array;
  /** Where all of it is stored, if it was left in its file. */
  readonly stored?: StoredDeformation;
  /** Where its points do not move along chords between the times: some of them, 3 numbers each, that stand for all. */
  readonly probe?: { readonly cost: number; pointsAt(time: number): ArrayLike<number> };
}

export interface StoredDeformation {
  readonly pointOfVertex: Uint32Array;
  readonly points: (time: number) => StoredSample;
  readonly normals: ((time: number) => StoredSample) | undefined;
}

export interface DeformedPoints {
  /** 3 per vertex of the mesh. */
  readonly positions: Float32Array;
  /** Absent where normals have to be computed. */
  readonly normals?: Float32Array;
}

export interface PlacedMesh {
  readonly mesh: Mesh;
  readonly motion: StaticMotion | SampledMotion | SampledPointsMotion;
}
