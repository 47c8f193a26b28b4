import { clamp, dot, exp, Fn, float, If, int, Loop, max, mix, pow, smoothstep, vec3 } from 'three/tsl';
import { observerDoppler } from '../shaders/observerDoppler.ts';
import type { Float, Vec3 } from '../shaders/types.ts';
import { unaberrate } from '../shaders/unaberrate.ts';
import type { Environment } from './environment.ts';
import { seen } from './radiance.ts';
import type { Uniforms } from './uniforms.ts';

/** Radiance of the sky in the world direction `n`: from the horizon to the zenith, and a ground that only closes the sphere. */
export function skyRadiance(environment: Environment, n: Vec3, zenith: Vec3): Vec3 {
  if (environment.image) return environment.image(n);
  const { zenithColor, horizonColor, groundColor } = environment.uniforms;
  const height = dot(n, zenith).toVar();
  const above = mix(horizonColor, zenithColor, pow(clamp(height, 0, 1), 0.45));
  const below = mix(horizonColor.mul(0.8), groundColor, smoothstep(0, 0.35, height.negate()));
  return mix(below, above, smoothstep(-0.015, 0.015, height));
}

/** Irradiance/π of the whole sky on a surface whose normal is `n`: between the mean of the lower and of the upper half. */
export function skyLight({ uniforms }: Environment, n: Vec3, zenith: Vec3): Vec3 {
  return mix(uniforms.lowerMean, uniforms.upperMean, dot(n, zenith).mul(0.5).add(0.5));
}

/** The discs of distant lights, a little larger and far dimmer than a real sun, with a faint glow. */
function suns(environment: Environment, n: Vec3, count: Uniforms['lightCount']): Vec3 {
  const sum = vec3(0).toVar();
  Loop({ start: int(0), end: count, type: 'int', condition: '<' }, ({ i }) => {
    const { place, color } = environment.light(int(i));
    If(place.w.lessThan(0.5), () => {
      const away = max(float(1).sub(dot(n, place.xyz)), 0).toVar();
      const disc = smoothstep(3.4e-5, 4.2e-5, away).oneMinus().mul(20);
      const glow = exp(away.mul(-900))
        .mul(0.25)
        .add(exp(away.mul(-40)).mul(0.05));
      sum.addAssign(color.mul(disc.add(glow)));
    });
  });
  return sum;
}

/** What is behind everything, in the direction `nPrime` of the observer's frame (unit, on the world axes that the boost carries). */
export const background = (environment: Environment, uniforms: Uniforms, nPrime: Vec3): Vec3 =>
  Fn(() => {
    const { u, gamma, boosted, zenith, lightCount } = uniforms;
    const n = mix(nPrime, unaberrate(nPrime, u, gamma), boosted)
      .normalize()
      .toVar();
    const D: Float = observerDoppler(n, u, gamma).toVar();
    const light = skyRadiance(environment, n, zenith)
      .add(suns(environment, n, lightCount))
      .toVar();
    return seen(light, D, uniforms);
  })();
