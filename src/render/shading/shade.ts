import { Fn, normalize, reflect } from 'three/tsl';
import type { Float, Vec3, Vec4 } from '../../shaders/types.ts';
import { type BrdfNodes, brdfOf } from '../brdf/brdf.ts';
import { skyReflectance } from '../brdf/skyReflectance.ts';
import {
  type ColorPipeline,
  RADIANCE_POWER,
  type RadianceAccumulator,
  type SpectralFilterNodes,
} from '../color/radiance.ts';
import type { Surface } from '../gbuffer/surface.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import type { Environment } from '../lights/environment.ts';
import { addDistantLight } from '../lights/kinds/distantLight.ts';
import type { DomeSky } from '../lights/kinds/domeLight.ts';
import { incidentSpectrumBetween, type RestFrameNodes, restFrame, WORLD_FRAME } from '../lights/restFrame.ts';
import type { LightVisibility } from '../shadows/distant/parallelReceiver.ts';
import { addLocalLight, type LocalLightVisibility } from './localLight.ts';

/**
 * The inputs of shading: `normal` is a unit vector in the rest frame, `dx` observer → event [m], `velocity` (v, 1 − v²), or undefined if nothing in the scene
 * moves, which saves a third of the cost.
 */
export type ShadedSurface = Omit<Surface, 'velocity' | 'object' | 'distance'> & {
  readonly velocity: Vec4 | undefined;
  /** Unoccluded fraction of the sky, weighted by the cosine (occlusion/); all of it if absent. */
  readonly openness?: Float;
};

/**
 * Radiance that reaches the observer. Shading is in the rest frame of the surface at the emission event: the normal is given there, the directions to lights
 * and observer are aberrated into it, and light arrives with E′ = D_in² E (docs/physics.md §6.2). Lambert and GGX with Schlick's Fresnel; sky light is
 * evaluated along the normal and the mirrored ray alone, times the unoccluded fraction.
 */
export const shade = (
  surface: ShadedSurface,
  environment: Environment,
  uniforms: FrameUniforms,
  pipeline: ColorPipeline,
  shadows?: LightVisibility,
): Vec3 =>
  Fn(() => {
    const rest = surface.velocity ? restFrame(surface.velocity, uniforms) : WORLD_FRAME;
    const N = surface.normal.toVar();
    const V = rest.into(normalize(surface.dx)).negate().toVar();
    const accumulator = pipeline(surface.D, uniforms);
    const albedo = accumulator.filter(surface.color.rgb, surface.invisible).toVar();
    const brdf = brdfOf(albedo, surface, N, V);
    const { dx, time } = surface;
    const receiver = { dx, time, normal: N, velocity: surface.velocity };
    environment.distantLights.forEach((light, index) => {
      addDistantLight({ brdf, rest }, light, accumulator, () => shadows?.ofDistantLight(index, receiver));
    });
    environment.localLights.forEach((light, slot) => {
      const visibility: LocalLightVisibility = (texels, emitter) =>
        shadows?.ofLocalLight(slot, receiver, { ...texels, ...emitter });
      addLocalLight({ brdf, dx, time, rest, uniforms }, light, accumulator, visibility);
    });
    skyReflection(brdf, surface, rest, environment.sky, uniforms, accumulator);
    accumulator.addEmitted(surface.emission.rgb);
    accumulator.addGlow(surface.emission);
    return accumulator.total();
  })();

/** Diffuse and specular reflection of the sky, times ambient occlusion and the material's own occlusion. */
function skyReflection(
  brdf: BrdfNodes,
  { occlusion, openness }: ShadedSurface,
  rest: RestFrameNodes,
  sky: DomeSky,
  uniforms: FrameUniforms,
  accumulator: RadianceAccumulator,
): void {
  const { diffuse, specular } = skyReflectance(brdf, openness);
  const { zenith } = uniforms;
  const { N, V } = brdf;
  const diffuseRadiance = (n: Vec3) => sky.irradiance(n, zenith);
  const specularRadiance = (n: Vec3) => sky.specular(n, zenith, brdf.roughness);
  const addReflection = (nPrime: Vec3, radiance: (n: Vec3) => Vec3, reflectance: SpectralFilterNodes): void => {
    const n = rest.out(nPrime);
    const spectrum = {
      ...incidentSpectrumBetween(n, rest, WORLD_FRAME),
      source: sky.source,
      colored: 'picture',
    } as const;
    accumulator.addReflected(radiance(n), reflectance.mul(occlusion), spectrum, RADIANCE_POWER);
  };
  addReflection(N, diffuseRadiance, diffuse);
  addReflection(normalize(reflect(V.negate(), N)).toVar(), specularRadiance, specular);
}
