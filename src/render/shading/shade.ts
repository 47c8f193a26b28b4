import { Fn, normalize } from 'three/tsl';
import type { Float, Vec3, Vec4 } from '../../shaders/types.ts';
import { brdfOf } from '../brdf/brdf.ts';
import type { ColorPipeline } from '../color/radiance.ts';
import type { Surface } from '../gbuffer/surface.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import type { Environment } from '../lights/environment.ts';
import type { SurfaceVisibility } from '../lights/kinds/litSurface.ts';
import { restFrame, WORLD_FRAME } from '../lights/restFrame.ts';
import type { LightVisibility } from '../shadows/distant/parallelReceiver.ts';

/**
 * The inputs of shading: `normal` is a unit vector in the rest frame, `dx` observer → event [m], `velocity` (v, 1 − v²), or undefined if nothing in the scene
 * moves, which saves a third of the cost.
 */
export type ShadedSurface = Omit<Surface, 'velocity' | 'object' | 'distance'> & {
  readonly velocity: Vec4 | undefined;
  /** Unoccluded fraction of the sky, weighted by the cosine (occlusion/); all of it if absent. */
  readonly openness?: Float;
};

/** What lights a surface at its emission event, in its rest frame; call it inside a `Fn`. */
export function beginShading(
  surface: ShadedSurface,
  uniforms: FrameUniforms,
  pipeline: ColorPipeline,
  shadows?: LightVisibility,
) {
  const rest = surface.velocity ? restFrame(surface.velocity, uniforms) : WORLD_FRAME;
  const N = surface.normal.toVar();
  const V = rest.into(normalize(surface.dx)).negate().toVar();
  const accumulator = pipeline(surface.D, uniforms);
  const albedo = accumulator.filter(surface.color.rgb, surface.invisible).toVar();
  const { dx, time, occlusion, openness } = surface;
  const receiver = { dx, time, normal: N, velocity: surface.velocity };
  const visibility: SurfaceVisibility | undefined = shadows && {
    ofDistantLight: (index) => shadows.ofDistantLight(index, receiver),
    ofLocalLight: (slot, light, emitter) => shadows.ofLocalLight(slot, receiver, { ...light, ...emitter }),
  };
  const lit = { dx, time, rest, occlusion, uniforms, ...(openness && { openness }), ...(visibility && { visibility }) };
  return { rest, N, V, accumulator, albedo, lit };
}

/**
 * Radiance that reaches the observer. Shading is in the rest frame of the surface at the emission event: the normal is given there, the directions to lights
 * and observer are aberrated into it, and light arrives with E′ = D_in² E (docs/physics.md §6.2). Lambert and GGX with Schlick's Fresnel; sky light is
 * multiplied by the unoccluded fraction.
 */
export const shade = (
  surface: ShadedSurface,
  environment: Environment,
  uniforms: FrameUniforms,
  pipeline: ColorPipeline,
  shadows?: LightVisibility,
): Vec3 =>
  Fn(() => {
    const { N, V, accumulator, albedo, lit } = beginShading(surface, uniforms, pipeline, shadows);
    environment.addReflected({ ...lit, brdf: brdfOf(albedo, surface, N, V, environment.lobes) }, accumulator);
    accumulator.addEmitted(surface.emission.rgb);
    accumulator.addGlow(surface.emission);
    return accumulator.total();
  })();
