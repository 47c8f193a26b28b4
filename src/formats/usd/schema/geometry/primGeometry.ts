import type { StretchedMesh } from '../../../../scene/mesh/stretch.ts';
import type { JointPoses } from '../../../../scene/streaming/blendedPoints.ts';
import type { StoredSample } from '../../../../scene/streaming/storedNumbers.ts';
import type { Mesh, SampledMotion, SampledPointsMotion, StaticMotion } from '../../../../scene/types.ts';
import type { SkinnedShape } from '../../../read/blendedSkin.ts';
import type { StageTransform } from '../transforms/stageTransform.ts';

/** A mesh in its prim's axes and stage units, with its deformation there. */
export interface PrimGeometry {
  /** At the stage's start time; of a linear blend, at rest. */
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
  /** Present if its joints can be kept instead of its points. */
  readonly blend?: LinearBlend;
  /** Present if points do not move along chords between the times: some representative points, 3 numbers each. */
  readonly probe?: { readonly cost: number; pointsAt(time: number): ArrayLike<number> };
}

/** Points that are linear blends of what joints make of a rest shape, in the joints' space. */
export interface LinearBlend extends Pick<SkinnedShape, 'rest' | 'shapes' | 'skin' | 'binds'> {
  /** A weight for each shape at a time code. */
  shapeWeightsAt(time: number): ArrayLike<number>;
  /** Its joints in a frame [m], at times that all meshes with the same joints share. */
  gridIn(path: string, frame: StageTransform): PoseGrid;
}

/** Joints at the nodes of a time grid. */
export interface PoseGrid {
  /** Time codes. */
  readonly times: Float64Array;
  readonly poses: JointPoses;
  /** The frame moves, and the poses are in the stage's axes [m]; if not, they are in it. */
  readonly isInWorld: boolean;
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

export interface PlacedMesh extends StretchedMesh {
  readonly motion: StaticMotion | SampledMotion | SampledPointsMotion;
}
