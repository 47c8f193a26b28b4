import type { LocalLight } from '../../../scene/types.ts';
import type { Float, Vec3 } from '../../../shaders/types.ts';
import type { LightAtEmission } from '../lightAtEmission.ts';
import type { LightTexels } from '../lightTexels.ts';
import type { LitSurface } from './litSurface.ts';
import type { AddReflected } from './surfaceInLightFrame.ts';

/** What the rasterizer knows of a shape of local light (docs/adr/0024-light-kinds.md): its row in the table, its integral, its silhouette. */
export interface LightShader<L extends LocalLight> {
  /** So many are written out one by one: a software GPU runs the body of a loop once more than needed. */
  readonly maxUnrolled: number;
  /** Whether shading asks for its axes even where its light is not shaped. */
  readonly needsAxes: boolean;
  extents(light: L): LightExtents;
  /** Occluders nearer than this to its middle may be its own bulb, and cast no shadow [m]. */
  bulbRadius(light: L): number;
  /** Adds what a surface reflects of its light, unoccluded. */
  addReflected(receiver: LitSurface, light: LightTexels, emitter: LightAtEmission, add: AddReflected): void;
  /** Half axes of its silhouette, in the world [m]: how wide the penumbra of its shadows is. */
  silhouette(light: LightSilhouette): readonly [Vec3, Vec3];
  /** Whether it fills the parallelogram of those, or else the ellipse. */
  readonly isParallelogram: boolean;
}

/** Half sizes along X and Y and the radius [m], and the factor that makes of the colour a radiance, or of a point an intensity. */
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
