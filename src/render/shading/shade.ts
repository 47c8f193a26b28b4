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
 * What shading reads of a surface: `normal` unit in its rest frame, `dx` observer → event [m], `velocity` (v, 1 − v²), or undefined
 * where all things rest, which costs a third.
 */
export type ShadedSurface = Omit<Surface, 'velocity' | 'object' | 'distance'> & {
  readonly velocity: Vec4 | undefined;
  /** Share of the sky that nothing hides, weighted by the cosine (occlusion/); absent: all of it. */
  readonly openness?: Float;
};

/**
 * Radiance that reaches the observer. Everything meets in the rest frame of the emission event: the normal is given there, the directions
 * to light and eye are aberrated into it, and the light arrives with E′ = D_in² E (docs/physics.md §6.2).
 * Lambert and GGX with Schlick's Fresnel; sky light is taken as if all of it came along the normal and the mirrored ray, less what neighbours hide.
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
    const here = { dx, time, normal: N, velocity: surface.velocity };
    environment.distantLights.forEach((light, index) => {
      addDistantLight({ brdf, rest }, light, accumulator, () => shadows?.ofDistantLight(index, here));
    });
    environment.localLights.forEach((light, slot) => {
      const visibility: LocalLightVisibility = (of, emitter) =>
        shadows?.ofLocalLight(slot, here, { ...of, ...emitter });
      addLocalLight({ brdf, dx, time, rest, uniforms }, light, accumulator, visibility);
    });
    skyReflection(brdf, surface, rest, environment.sky, uniforms, accumulator);
    accumulator.addEmitted(surface.emission.rgb);
    accumulator.addGlow(surface.emission);
    return accumulator.total();
  })();

/** Sky light, and its mirror image; of both, what neighbours and the surface's own small shape leave. */
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
  const soft = (n: Vec3) => sky.irradiance(n, zenith);
  const sharp = (n: Vec3) => sky.specular(n, zenith, brdf.roughness);
  const reflected = (nPrime: Vec3, radiance: (n: Vec3) => Vec3, share: SpectralFilterNodes): void => {
    const n = rest.out(nPrime);
    const spectrum = {
      ...incidentSpectrumBetween(n, rest, WORLD_FRAME),
      source: sky.source,
      colored: 'picture',
    } as const;
    accumulator.addReflected(radiance(n), share.mul(occlusion), spectrum, RADIANCE_POWER);
  };
  reflected(N, soft, diffuse);
  reflected(normalize(reflect(V.negate(), N)).toVar(), sharp, specular);
}
