import { Fn, normalize, reflect } from 'three/tsl';
import type { Float, Vec3, Vec4 } from '../../shaders/types.ts';
import {
  type ColorPipeline,
  IRRADIANCE_POWER,
  RADIANCE_POWER,
  type RadianceAccumulator,
  type SpectralFilter,
} from '../color/radiance.ts';
import type { Surface } from '../gbuffer/surface.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import type { Environment } from '../lights/environment.ts';
import { incidentSpectrumBetween, type RestFrame, restFrame, WORLD_FRAME } from '../lights/restFrame.ts';
import { skyReflectance } from '../occlusion/skyReflectance.ts';
import type { LightVisibility } from '../shadows/distant/parallelReceiver.ts';
import { type Brdf, brdfOf, evaluateBrdf } from './brdf.ts';
import { addLocalLight, type LocalLightVisibility } from './localLight.ts';
import { diffuseSky, specularSky } from './sky.ts';

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
    const eye = pipeline(surface.D, uniforms);
    const albedo = eye.filter(surface.color.rgb, surface.invisible).toVar();
    const look = brdfOf(albedo, surface, N, V);
    const { dx, time } = surface;
    const here = { dx, time, normal: N, velocity: surface.velocity };
    environment.forEachDistantLight(({ direction, color, source, colored }, index) => {
      const passage = {
        ...incidentSpectrumBetween(direction, rest, WORLD_FRAME),
        ...(source && { source }),
        ...(colored !== undefined && { colored }),
      };
      const share = shadows?.ofDistantLight(index, here);
      eye.addReflected(
        share ? color.mul(share) : color,
        evaluateBrdf(look, rest.into(direction)),
        passage,
        IRRADIANCE_POWER,
      );
    });
    environment.localLights.forEach((lamp, slot) => {
      const shelter: LocalLightVisibility = (of, seen) => shadows?.ofLocalLight(slot, here, { ...of, ...seen });
      addLocalLight({ brdf: look, dx, time, rest, uniforms }, lamp, eye, shelter);
    });
    skyReflection(look, surface, rest, environment, uniforms, eye);
    eye.addEmitted(surface.emission.rgb);
    eye.addGlow(surface.emission);
    return eye.total();
  })();

/** Sky light, and its mirror image; of both, what neighbours and the surface's own small shape leave. */
function skyReflection(
  look: Brdf,
  { occlusion, openness }: ShadedSurface,
  rest: RestFrame,
  environment: Environment,
  uniforms: FrameUniforms,
  eye: RadianceAccumulator,
): void {
  const { diffuse, specular } = skyReflectance(look, openness);
  const { zenith } = uniforms;
  const { N, V } = look;
  const soft = (n: Vec3) => diffuseSky(environment, n, zenith);
  const sharp = (n: Vec3) => specularSky(environment, n, zenith, look.roughness);
  const reflected = (nPrime: Vec3, radiance: (n: Vec3) => Vec3, share: SpectralFilter): void => {
    const n = rest.out(nPrime);
    const passage = {
      ...incidentSpectrumBetween(n, rest, WORLD_FRAME),
      source: environment.skySource,
      colored: 'picture',
    } as const;
    eye.addReflected(radiance(n), share.mul(occlusion), passage, RADIANCE_POWER);
  };
  reflected(N, soft, diffuse);
  reflected(normalize(reflect(V.negate(), N)).toVar(), sharp, specular);
}
