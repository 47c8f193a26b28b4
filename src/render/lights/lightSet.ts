import type { LightKind } from '../../scene/lights/kinds/lightKind.ts';
import type { ColorMode } from '../../scene/settings/settings.ts';
import type { Light } from '../../scene/types.ts';
import type { Float, Vec3 } from '../../shaders/types.ts';
import type { RadianceAccumulator } from '../color/radiance.ts';
import type { Observation } from '../geometry/observation.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import type { LitSurface } from './kinds/litSurface.ts';

export type LightReach = LightKind<Light>['reach'];

/** A pixel of the sky: its world direction (unit), and the angle that it covers in the world [rad]. */
export interface SkyPixel {
  readonly n: Vec3;
  readonly angle: Float;
}

/** All lights of a scene that come from one reach, on the GPU (docs/adr/0024-light-kinds.md). */
export interface LightSet {
  /** Writes their values, once per picture. */
  update(observation: Observation, colors: ColorMode): void;
  /** Adds what a surface reflects of them. */
  addReflected(surface: LitSurface, accumulator: RadianceAccumulator): void;
  /** Adds what is seen of them behind everything. */
  addBackground(pixel: SkyPixel, uniforms: FrameUniforms, accumulator: RadianceAccumulator): void;
}
