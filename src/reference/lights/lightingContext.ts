import type { Random } from '../../math/random.ts';
import { type Vec3, ZERO } from '../../math/vec3.ts';
import { inverseBoost, properVelocity } from '../../physics/lorentz/boost.ts';
import type { Hypersurface } from '../../physics/worldLines/lightSurfaces.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { isLuminous } from '../../scene/views/views.ts';
import type { SpacetimeRay } from '../acceleration/ray.ts';
import type { TracedScene } from '../intersection/tracedScene.ts';
import { type RestFrame, restFrame } from '../spectral/restFrame.ts';
import type { SampledRadiance } from '../spectral/sampledRadiance.ts';
import type { SourceSpectrum } from '../spectral/sourceSpectrum.ts';
import type { SpectralContext } from '../spectral/spectralContext.ts';
import type { SkySampler } from './kinds/skySampler.ts';
import type { LightOptions } from './lightOptions.ts';

/** Light that arrives at a surface from one direction; of a distant light with a radius, the ray is sampled within its cone. */
export interface IncidentLight {
  /** From the surface to the emission event [m, world]; of distant lights only a direction. */
  readonly dx: Vec3;
  /** The same for the shadow ray. */
  readonly rayDirection: Vec3;
  /** End of the shadow ray, as a multiple of `rayDirection`; it excludes the light itself. */
  readonly end: number;
  /** The source, at rest in `sourceFrame`: `weight` times its light is the irradiance in that frame of a surface that faces it. */
  readonly sourceSpectrum: SourceSpectrum;
  readonly sourceFrame: RestFrame;
  readonly weight: number;
}

/** A light as rays find it; which of these members it has depends on its kind (kinds/). */
export interface TracedLight {
  /** Samples its light that arrives at an event; returns undefined if none does. Absent for lights that only BRDF samples of surfaces find. */
  sample?(lighting: LightingContext, at: RayOrigin): IncidentLight | undefined;
  /** Radiance from the unit world direction n, unoccluded. */
  radiance?(n: Vec3, context: SpectralContext): SampledRadiance;
  /** Importance sampler of its bright directions. */
  readonly sampler?: SkySampler;
  /** Its disc in the sky, seen by the camera only, as a factor of its light from the unit direction n. */
  readonly disc?: { readonly sourceSpectrum: SourceSpectrum; factor(n: Vec3): number };
}

/** The background, for an observer at rest in the world. */
export interface Sky {
  radiance(n: Vec3, context: SpectralContext): SampledRadiance;
  /** Whether the camera sees `radiance`; stars are drawn as points instead. */
  readonly isSeen: boolean;
  /** The discs of distant lights and the glow around them. */
  sunDiscs(n: Vec3, context: SpectralContext): SampledRadiance;
  readonly sampler?: SkySampler;
}

/** Everything needed to trace one sample of a picture. */
export interface LightingContext {
  readonly scene: TracedScene;
  readonly settings: RenderSettings;
  readonly options: LightOptions;
  readonly random: Random;
  readonly sky: Sky;
  /** The lights that surfaces sample. */
  readonly directLights: readonly TracedLight[];
  /** Determines which events light each other. */
  readonly propagation: LightPropagation;
}

/** Light travels on the past light cone, or, in views of one moment, within a slice of constant time in the frame of u (of the world for u = 0). */
export interface LightPropagation {
  readonly hypersurface: Hypersurface;
  /** The observer's γβ. */
  readonly u: Vec3;
}

/** The rest frame of a velocity [c]; in views without light everything counts as at rest. */
export const restFrameOf = ({ settings }: LightingContext, velocity: Vec3): RestFrame =>
  restFrame(isLuminous(settings) ? properVelocity(velocity) : ZERO);

/** The event at which a ray begins, and the length at its beginning in which hits are ignored [m], because rounding can put them on the ray's own surface. */
export interface RayOrigin {
  readonly t: number;
  readonly x: Vec3;
  readonly clearance: number;
}

/** The ray back along the light that arrives at an event from the direction dx [m, world]. */
export function rayBack({ propagation }: LightingContext, { t, x }: RayOrigin, dx: Vec3): SpacetimeRay {
  return { t, x, dt: propagation.hypersurface.timeAt(dx, propagation.u), dx };
}

/** The same inside a body of refractive index n, for a unit direction in its rest frame, where light moves at c/n. */
export function rayBackInside(
  lighting: LightingContext,
  { t, x, clearance }: RayOrigin,
  direction: Vec3,
  frame: RestFrame,
  n: number,
): SpacetimeRay {
  if (!lighting.propagation.hypersurface.isLightCone)
    return rayBack(lighting, { t, x, clearance }, frame.toWorld(direction));
  const [dt, ...dx] = inverseBoost([-n, ...direction], frame.u);
  return { t, x, dt, dx };
}
