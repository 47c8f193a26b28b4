import type { LocalLight } from '../../scene/types.ts';
import type * as gpu from '../../shaders/types.ts';
import type { SpectralSource } from '../color/radiance.ts';
import type { LightMotion } from './lightEvent.ts';

/** What shaders tell apart: a sphere without a size is a point. */
export type LocalLightShape = LocalLight['kind'] | 'point';

/** A local light on the GPU, relative to one event of it, its anchor: where the observer sees it, if he does. */
export interface LightTexels {
  readonly kind: LocalLightShape;
  readonly motion: LightMotion;
  /** Observer → anchor [m]. */
  readonly place: gpu.Vec3;
  readonly radius: gpu.Float;
  /** The filter of its radiance; of a point that of its intensity. */
  readonly color: gpu.Vec3;
  /** Absent of a light that shines alike to all sides. */
  readonly shape?: LightShape;
  /** Birth, death and the anchor's time after the observer's [m of light]; absent where it rests and always shines. */
  readonly life?: gpu.Vec3;
  /** Absent of daylight. */
  readonly source?: SpectralSource;
  /** As of `IncidentSpectrum`. */
  readonly colored?: number;
}

export interface LightShape {
  /** Half axes, of a sphere of length 1; of a cylinder X is one, and Y of length 1. Where the light turns, in its own axes. */
  readonly X: gpu.Vec3;
  readonly Y: gpu.Vec3;
  readonly inner: gpu.Float;
  readonly outer: gpu.Float;
  readonly focus: gpu.Float;
}
