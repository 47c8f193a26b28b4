import type { StoredSample } from '../../../../scene/streaming/storedNumbers.ts';
import type { Mesh, SampledMotion, SampledPointsMotion, StaticMotion } from '../../../../scene/types.ts';
import type { StageTransform } from '../transforms/stageTransform.ts';

/** A mesh in its prim's axes and stage units, with its deformation there. */
export interface PrimGeometry {
  /** At the stage's start time. */
  readonly mesh: Mesh;
  readonly deformation?: Deformation;
  /** Transform that replaces the prim's own if a skeleton moves the mesh. */
  readonly transform?: StageTransform;
}

export interface Deformation {
  readonly times: Float64Array;
  /** Returns new arrays. */
  at(time: number): DeformedPoints;
  /** Authored velocities [units per second], 3 per vertex, in a new array; absent unless authored at all times. */
  velocitiesAt?(time: number): Float32Array;
  /** Present if the samples stay in the file. */
  readonly stored?: StoredDeformation;
  /** Present if points do not move along chords between the times: some representative points, 3 numbers each. */
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
  /** Absent if normals have to be computed. */
  readonly normals?: Float32Array;
}

export interface PlacedMesh {
  readonly mesh: Mesh;
  readonly motion: StaticMotion | SampledMotion | SampledPointsMotion;
}
