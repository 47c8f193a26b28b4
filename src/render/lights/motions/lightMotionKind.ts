import { length, vec4 } from 'three/tsl';
import type { RigidMotion } from '../../../scene/types.ts';
import type { Bool, Float, Vec3, Vec4 } from '../../../shaders/types.ts';
import type { Observation, RelativeEvent } from '../../geometry/observation.ts';
import type { TablePart, Texels } from '../../gpu/floatTable.ts';

/** What the tables of local lights hold of a kind of motion, and how shaders find the emission event (docs/adr/0022-motion-kinds.md). */
export interface LightMotionKind<M extends RigidMotion> {
  /** Texels reserved for its samples. */
  sampleTexels(motion: M): number;
  /** Its values at the light's anchor; writes its samples from texel `used` of `samples` on. */
  write(motion: M, anchor: RelativeEvent, observation: Observation, samples: TablePart, used: number): WrittenMotion;
  /** As `lightEmissionEvent`; undefined of lights at rest, which emit at their anchor. */
  readonly emission: ((moving: MovingTexels, d: Vec3, lag: Float) => LightEmissionEvent) | undefined;
}

/** The anchor as solvers of the light cone take it: (d, |d|), `d` from the surface [m]. */
export const relativeAnchor = (d: Vec3): Vec4 => vec4(d, length(d)).toVar();

export interface WrittenMotion {
  /** Uniform: (v, 1 − v²); hyperbolic: (axis, a/c² [1/m]); sampled: (first texel of its samples, count, 0, 0). */
  readonly motion: readonly number[];
  /** e^φ of hyperbolic motion at the anchor, else 1. */
  readonly w: number;
  /** Texels of samples that were written. */
  readonly used: number;
}

/** The same on the GPU. */
export interface MovingTexels {
  readonly motion: Vec4;
  readonly w: Float;
  readonly samples: Texels;
}

/** The event at which a light emits the light that reaches a surface event. */
export interface LightEmissionEvent {
  /** Surface → light [m]. */
  readonly offset: Vec3;
  /** Time after the anchor [m of light]; absent of lights that rest and always shine. */
  readonly elapsed?: Float;
  /** (v, 1 − v²); absent at rest. */
  readonly velocity?: Vec4;
  /** Orientation of its axes; absent where the table's axes are those of the world. */
  readonly orientation?: Vec4;
  /** Whether there is such an event; absent where there always is. */
  readonly exists?: Bool;
}
