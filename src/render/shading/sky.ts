import { clamp, dot, exp, Fn, float, max, mix, pow, smoothstep } from 'three/tsl';
import { SUN_DISC } from '../../scene/lights/sceneLights.ts';
import { SKY_SHAPE } from '../../scene/lights/skyGradient.ts';
import { COSMIC_TEMPERATURE, DAYLIGHT_LUMINANCE } from '../../scene/stars/cosmicBackground.ts';
import { observerDoppler } from '../../shaders/kinematics/observerDoppler.ts';
import { unaberrate } from '../../shaders/kinematics/unaberrate.ts';
import type { Float, Vec3 } from '../../shaders/types.ts';
import type { ColorPipeline, RadianceAccumulator } from '../color/radiance.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import type { Environment } from '../lights/environment.ts';

/** Radiance of the sky in the world direction `n` (skyGradient.ts). */
export function skyRadiance(environment: Environment, n: Vec3, zenith: Vec3): Vec3 {
  if (environment.domeTexture) return environment.domeTexture.radiance(n);
  const { zenithColor, horizonColor, groundColor } = environment.uniforms;
  if (!environment.hasGradient) return zenithColor.rgb;
  const { curve, dim, haze, seam } = SKY_SHAPE;
  const height = dot(n, zenith).toVar();
  const above = mix(horizonColor, zenithColor, pow(clamp(height, 0, 1), curve));
  const below = mix(horizonColor.mul(dim), groundColor, smoothstep(0, haze, height.negate()));
  return mix(below, above, smoothstep(-seam, seam, height));
}

/** Irradiance/π of the whole sky on a surface whose normal is `n`. */
export function diffuseSky({ domeTexture: picture, hasGradient, uniforms }: Environment, n: Vec3, zenith: Vec3): Vec3 {
  if (picture) return picture.irradiance(n);
  const { zenithColor, skyLevel, skyRise, skyBend } = uniforms;
  if (!hasGradient) return zenithColor.rgb;
  const height = dot(n, zenith).toVar();
  return skyBend.rgb.mul(height).add(skyRise).mul(height).add(skyLevel);
}

/** What a surface of a roughness mirrors of the sky from about `n`. */
export function specularSky(environment: Environment, n: Vec3, zenith: Vec3, roughness: Float): Vec3 {
  const { domeTexture: picture } = environment;
  if (picture) return picture.specular(n, roughness);
  return mix(skyRadiance(environment, n, zenith), diffuseSky(environment, n, zenith), roughness.sqrt());
}

/** The discs of distant lights, with their glow. */
const addSunDiscs = (environment: Environment, n: Vec3, eye: RadianceAccumulator): void =>
  environment.forEachDistantLight(({ direction, color, source }) => {
    const away = max(float(1).sub(dot(n, direction)), 0).toVar();
    const disc = smoothstep(...SUN_DISC.rim, away)
      .oneMinus()
      .mul(SUN_DISC.radiance);
    const [near, far] = SUN_DISC.glows.map(([strength, rate]) => exp(away.mul(-rate)).mul(strength));
    eye.addEmitted(color.mul(disc.add(near).add(far)), source);
  });

/** What is behind everything, in the direction `nPrime` of the observer's frame (unit, on the world axes that the boost carries). */
export const backgroundRadiance = (
  environment: Environment,
  uniforms: FrameUniforms,
  pipeline: ColorPipeline,
  nPrime: Vec3,
): Vec3 =>
  Fn(() => {
    const { u, gamma, boosted, zenith } = uniforms;
    const n = mix(nPrime, unaberrate(nPrime, u, gamma), boosted)
      .normalize()
      .toVar();
    const D: Float = observerDoppler(n, u, gamma).toVar();
    const eye = pipeline(D, uniforms);
    eye.addEmitted(skyRadiance(environment, n, zenith), environment.skySource);
    addSunDiscs(environment, n, eye);
    if (environment.nightSky)
      eye.addBlackbody(COSMIC_TEMPERATURE, float(environment.nightSky.gain * DAYLIGHT_LUMINANCE));
    return eye.total();
  })();
