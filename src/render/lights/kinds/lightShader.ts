import type { LocalLight } from '../../../scene/types.ts';
import type { Float, Vec3 } from '../../../shaders/types.ts';
import type { LightAtEmission } from '../lightAtEmission.ts';
import type { LightTexels } from '../lightTexels.ts';
import type { LitSurface } from './litSurface.ts';
import type { AddReflected } from './surfaceInLightFrame.ts';

/** How the rasterizer shades a shape of local light (docs/adr/0024-light-kinds.md): its extents in the table, its BRDF integral, its silhouette. */
export interface LightShader<L extends LocalLight> {
  /** Up to this number the loop is unrolled: a software GPU runs the body of a loop once more than needed. */
  readonly maxUnrolled: number;
  /** Whether its axes are uploaded even without shaping. */
  readonly needsAxes: boolean;
  extents(light: L): LightExtents;
  /** Occluders nearer than this to its centre may be its own bulb, and cast no shadow [m]. */
  bulbRadius(light: L): number;
  /** Passes what a surface reflects of its light, unoccluded, to `add`. */
  addReflected(receiver: LitSurface, light: LightTexels, emitter: LightAtEmission, add: AddReflected): void;
  /** Half axes of its silhouette, world axes [m]; they determine the width of penumbrae. */
  silhouette(light: LightSilhouette): readonly [Vec3, Vec3];
  /** Whether the silhouette is the parallelogram of these half axes, else their ellipse. */
  readonly isParallelogram: boolean;
}

/** Half sizes along X and Y, radius [m], and the factor from the light's colour to its radiance, or a point's intensity. */
export interface LightExtents {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
  readonly gain: number;
}

/** `offset`: surface → light [m]. */
export interface LightSilhouette extends Pick<LightAtEmission, 'offset' | 'shape'> {
  readonly radius: Float;
}
