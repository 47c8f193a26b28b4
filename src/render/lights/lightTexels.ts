import type { LocalLight } from '../../scene/types.ts';
import type * as gpu from '../../shaders/types.ts';
import type { SpectralSource } from '../color/radiance.ts';
import type { LightMotion } from './lightMotions.ts';

/** The shapes that shaders distinguish: a sphere of radius 0 is a point. */
export type LocalLightShape = LocalLight['kind'] | 'point';

/** A local light on the GPU, relative to its anchor: the event on its world line that the observer sees (`lightAnchor`). */
export interface LightTexels {
  readonly kind: LocalLightShape;
  readonly motion: LightMotion;
  /** Observer → anchor [m]. */
  readonly place: gpu.Vec3;
  readonly radius: gpu.Float;
  /** The filter of its radiance, or of a point's intensity. */
  readonly color: gpu.Vec3;
  /** Absent of a light that shines equally in all directions. */
  readonly shape?: LightShape;
  /** Times of birth, death and anchor after the observer's [m of light]; absent of lights that rest and always shine. */
  readonly life?: gpu.Vec3;
  /** Absent for daylight. */
  readonly source?: SpectralSource;
  /** As of `IncidentSpectrum`. */
  readonly colored?: number;
}

export interface LightShape {
  /** Half axes [m]; those of a sphere, and Y of a cylinder, have length 1. World axes, or its own if its motion has no fixed orientation. */
  readonly X: gpu.Vec3;
  readonly Y: gpu.Vec3;
  readonly inner: gpu.Float;
  readonly outer: gpu.Float;
  readonly focus: gpu.Float;
}
