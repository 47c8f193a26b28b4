import { Fn, normalize, reflect } from 'three/tsl';
import type { Float, Vec3, Vec4 } from '../shaders/types.ts';
import { type Look, lookOf, reflectance } from './brdf.ts';
import type { Environment } from './environment.ts';
import { lampLight, type Shelter } from './lampLight.ts';
import { skyShares } from './occlusion/sheltered.ts';
import { type Filter, type Gathering, IRRADIANCE, type Optics, RADIANCE } from './radiance.ts';
import { AT_REST, passageBetween, type Rest, restFrame } from './restFrame.ts';
import type { Shadowing } from './shadows/receiver.ts';
import { skyLight, skyMirrored } from './sky.ts';
import type { Surface } from './surface.ts';
import type { Uniforms } from './uniforms.ts';

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
 * to light and eye are aberrated into it, and the light arrives with E′ = D_in² E (physics.md, "Shading").
 * Lambert and GGX with Schlick's Fresnel; sky light is taken as if all of it came along the normal and the mirrored ray, less what neighbours hide.
 */
export const shade = (
  surface: ShadedSurface,
  environment: Environment,
  uniforms: Uniforms,
  optics: Optics,
  shadows?: Shadowing,
): Vec3 =>
  Fn(() => {
    const rest = surface.velocity ? restFrame(surface.velocity, uniforms) : AT_REST;
    const N = surface.normal.toVar();
    const V = rest.into(normalize(surface.dx)).negate().toVar();
    const eye = optics(surface.D, uniforms);
    const albedo = eye.filter(surface.color.rgb, surface.invisible).toVar();
    const look = lookOf(albedo, surface, N, V);
    const { dx, time } = surface;
    const here = { dx, time, normal: N, velocity: surface.velocity };
    environment.eachSun(({ direction, color, source, colored }, index) => {
      const passage = {
        ...passageBetween(direction, rest, AT_REST),
        ...(source && { source }),
        ...(colored !== undefined && { colored }),
      };
      const share = shadows?.share(index, here);
      eye.send(share ? color.mul(share) : color, reflectance(look, rest.into(direction)), passage, IRRADIANCE);
    });
    environment.lamps.each((lamp, slot) => {
      const shelter: Shelter = (of, seen) => shadows?.ofLamp(slot, here, { ...of, ...seen });
      lampLight({ look, dx, time, rest, uniforms }, lamp, eye, shelter);
    });
    skyReflection(look, surface, rest, environment, uniforms, eye);
    eye.emit(surface.emission.rgb);
    eye.glow(surface.emission);
    return eye.seen();
  })();

/** Sky light, and its mirror image; of both, what neighbours and the surface's own small shape leave. */
function skyReflection(
  look: Look,
  { occlusion, openness }: ShadedSurface,
  rest: Rest,
  environment: Environment,
  uniforms: Uniforms,
  eye: Gathering,
): void {
  const { diffuse, mirrored } = skyShares(look, openness);
  const { zenith } = uniforms;
  const { N, V } = look;
  const soft = (n: Vec3) => skyLight(environment, n, zenith);
  const sharp = (n: Vec3) => skyMirrored(environment, n, zenith, look.roughness);
  const reflected = (nPrime: Vec3, radiance: (n: Vec3) => Vec3, share: Filter): void => {
    const n = rest.out(nPrime);
    const passage = { ...passageBetween(n, rest, AT_REST), source: environment.skySource, colored: 'picture' } as const;
    eye.send(radiance(n), share.mul(occlusion), passage, RADIANCE);
  };
  reflected(N, soft, diffuse);
  reflected(normalize(reflect(V.negate(), N)).toVar(), sharp, mirrored);
}
