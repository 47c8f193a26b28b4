import type { Random } from '../../math/random.ts';
import { type Vec3, ZERO } from '../../math/vec3.ts';
import { inverseBoost, properVelocity } from '../../physics/lorentz/boost.ts';
import type { Hypersurface } from '../../physics/worldLines/hypersurface.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { VIEWS } from '../../scene/views/views.ts';
import type { SpacetimeRay } from '../acceleration/ray.ts';
import type { TracedScene } from '../intersection/tracedScene.ts';
import { type RestFrame, restFrame } from '../spectral/restFrame.ts';
import type { SampledRadiance } from '../spectral/sampledRadiance.ts';
import type { SourceSpectrum } from '../spectral/sourceSpectrum.ts';
import type { SpectralContext } from '../spectral/spectralContext.ts';
import type { SkySampler } from './kinds/skySampler.ts';
import type { LightOptions } from './lightOptions.ts';

/** Light that arrives at a surface from one direction, or its sample from a small cone. */
export interface IncidentLight {
  /** Surface → where it was sent out [m, world]; of distant lights only the direction. */
  readonly dx: Vec3;
  /** The same for the ray that tells whether it arrives. */
  readonly rayDirection: Vec3;
  /** Part of dx that is free of the light itself. */
  readonly end: number;
  /** What sends it out, at rest in that frame: `weight` times its light is the irradiance there of a surface that faces it. */
  readonly sourceSpectrum: SourceSpectrum;
  readonly sourceFrame: RestFrame;
  readonly weight: number;
}

/** A light as rays find it: each kind has those ways in which it is found (kinds/). */
export interface TracedLight {
  /** Light of it that arrives at an event, sampled; undefined: none does. Absent of what surfaces find only by their own directions. */
  sample?(lighting: LightingContext, at: RayOrigin): IncidentLight | undefined;
  /** Radiance from world directions n (unit) where nothing is in the way. */
  radiance?(n: Vec3, context: SpectralContext): SampledRadiance;
  /** Where its radiance is great. */
  readonly sampler?: SkySampler;
  /** What the camera alone sees of it in the sky, as a factor of its light from the unit direction n: as a light it has no size. */
  readonly disc?: { readonly sourceSpectrum: SourceSpectrum; factor(n: Vec3): number };
}

/** What is behind everything, for an observer at rest in the world. */
export interface Sky {
  radiance(n: Vec3, context: SpectralContext): SampledRadiance;
  /** The discs of distant lights and their glow. */
  sunDiscs(n: Vec3, context: SpectralContext): SampledRadiance;
  readonly sampler?: SkySampler;
}

/** Everything that one sample of a picture asks for while it follows its light back. */
export interface LightingContext {
  readonly scene: TracedScene;
  readonly settings: RenderSettings;
  readonly options: LightOptions;
  readonly random: Random;
  readonly sky: Sky;
  /** Those that surfaces sample. */
  readonly directLights: readonly TracedLight[];
  /** Which events light each other. */
  readonly propagation: LightPropagation;
}

/** Light that takes its time; or, where the picture is of one moment (a slice of u's own time; the world's for u = 0), none. */
export interface LightPropagation {
  readonly hypersurface: Hypersurface;
  /** The observer's γβ. */
  readonly u: Vec3;
}

/** The rest frame of a velocity [c]; in the views that show no light everything is as at rest. */
export const restFrameOf = ({ settings }: LightingContext, velocity: Vec3): RestFrame =>
  restFrame(VIEWS[settings.view].luminous ? properVelocity(velocity) : ZERO);

/** An event, and how much of a ray that leaves it does not count [m]: what rounding may put between it and its own surface. */
export interface RayOrigin {
  readonly t: number;
  readonly x: Vec3;
  readonly clearance: number;
}

/** The ray from an event to where light from the direction dx [m, world] came from. */
export function rayBack({ propagation }: LightingContext, { t, x }: RayOrigin, dx: Vec3): SpacetimeRay {
  return { t, x, dt: propagation.hypersurface.timeAt(dx, propagation.u), dx };
}

/** The same inside a body of refractive index n that moves with u, for a unit direction of its rest frame: light goes at c/n there. */
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
