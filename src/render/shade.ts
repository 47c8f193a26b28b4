import { clamp, dot, exp2, Fn, float, max, min, mix, normalize, reflect, vec3 } from 'three/tsl';
import type { Float, Vec3, Vec4 } from '../shaders/types.ts';
import { areaLight } from './areaShade.ts';
import type { Environment, LightTexels } from './environment.ts';
import { seen } from './radiance.ts';
import { AT_REST, type Rest, restFrame } from './restFrame.ts';
import { shaped } from './shaping.ts';
import { skyLight, skyRadiance } from './sky.ts';
import type { Surface } from './surface.ts';
import type { Uniforms } from './uniforms.ts';

/**
 * What shading reads of a surface: `normal` unit in its rest frame, `dx` observer → event [m], `velocity` (v, 1 − v²), or undefined
 * where all things rest, which costs a third.
 */
export type ShadedSurface = Omit<Surface, 'velocity' | 'time' | 'object' | 'distance'> & {
  readonly velocity: Vec4 | undefined;
};

/**
 * Radiance that reaches the observer. Everything meets in the rest frame of the emission event: the normal is given there, the directions
 * to light and eye are aberrated into it, and the light arrives with E′ = D_in² E (physics.md, "Shading").
 * Lambert and GGX with Schlick's Fresnel; sky light is taken as if all of it came along the normal and the mirrored ray.
 */
export const shade = (surface: ShadedSurface, environment: Environment, uniforms: Uniforms): Vec3 =>
  Fn(() => {
    const rest = surface.velocity ? restFrame(surface.velocity, uniforms) : AT_REST;
    const N = surface.normal.toVar();
    const V = rest.into(normalize(surface.dx)).negate().toVar();
    const look = lookOf(surface, max(dot(N, V), 1e-3).toVar());
    const { dx } = surface;
    const direct = environment.sum('all', (light) => directLight(look, N, V, dx, rest, light)).toVar();
    if (environment.areas) {
      const mirrored = (L: Vec3, breadth: Float, length: Float) => mirroredLight(look, N, V, L, breadth, length);
      direct.addAssign(environment.areas.sum((lamp) => areaLight({ ...look, N, V, dx, rest, mirrored }, lamp)));
    }
    const reflected = skyReflection(look, N, V, rest, environment, uniforms);
    return seen(direct.add(reflected).add(surface.emission.rgb).add(surface.emission.luminance), surface.D, uniforms);
  })();

interface Look {
  readonly diffuse: Vec3;
  readonly F0: Vec3;
  readonly roughness: Float;
  readonly NV: Float;
}

function lookOf({ color, roughness, metallic, F0 }: ShadedSurface, NV: Float): Look {
  return {
    diffuse: color.rgb.mul(metallic.oneMinus()).toVar(),
    F0: mix(vec3(F0), color.rgb, metallic).toVar(),
    roughness: clamp(roughness, 0.05, 1).toVar(),
    NV,
  };
}

function directLight(look: Look, N: Vec3, V: Vec3, dx: Vec3, rest: Rest, light: LightTexels): Vec3 {
  const { place, color } = light;
  // Distant lights give their direction; sphere lights their place, and E falls with the square of the distance in the world, where they rest.
  const away = mix(place.xyz, place.xyz.sub(dx), place.w).toVar();
  const fall = mix(1, dot(away, away).max(1e-6).reciprocal(), place.w);
  const s = normalize(away).toVar();
  const open = light.shaping ? shaped(light.shaping, s.negate()) : float(1);
  const E = rest.irradiance(color, s).mul(fall).mul(open);
  const L = rest.into(s);
  const NL = clamp(dot(N, L), 0, 1).toVar();
  return E.mul(NL).mul(look.diffuse.mul(1 / Math.PI).add(ggx(look, N, V, L, NL)));
}

/** What is mirrored of light from a lamp with a size, which widens a = roughness² both ways: what the peak gains in breadth it loses in height. */
function mirroredLight(look: Look, N: Vec3, V: Vec3, L: Vec3, breadth: Float, length: Float): Vec3 {
  const NL = clamp(dot(N, L), 0, 1).toVar();
  const a = look.roughness.mul(look.roughness).toVar();
  const height = a.mul(a).div(a.add(breadth).mul(a.add(length)));
  return ggx(look, N, V, L, NL).mul(height.mul(NL));
}

/** Cook–Torrance with GGX and the height-correlated Smith term (Heitz 2014, eq. 99). */
function ggx({ F0, roughness, NV }: Look, N: Vec3, V: Vec3, L: Vec3, NL: Float): Vec3 {
  const H = normalize(L.add(V)).toVar();
  const a = roughness.mul(roughness).toVar();
  const a2 = a.mul(a).toVar();
  const NH = clamp(dot(N, H), 0, 1).toVar();
  const spread = NH.mul(NH).mul(a2.sub(1)).add(1).toVar();
  const distribution = a2.div(spread.mul(spread).mul(Math.PI));
  const smith = (x: Float, y: Float): Float => x.mul(y.mul(y).mul(a2.oneMinus()).add(a2).sqrt());
  const visibility = max(smith(NL, NV).add(smith(NV, NL)), 1e-4)
    .reciprocal()
    .mul(0.5);
  const away = clamp(dot(V, H), 0, 1).oneMinus().toVar();
  const away2 = away.mul(away).toVar();
  const F = F0.add(F0.oneMinus().mul(away2.mul(away2).mul(away)));
  return F.mul(min(distribution.mul(visibility), 1e4));
}

/** Sky light and its mirror image, through the split-sum fit of Karis (2014, "Physically based shading on mobile"). */
function skyReflection(look: Look, N: Vec3, V: Vec3, rest: Rest, environment: Environment, uniforms: Uniforms): Vec3 {
  const { F0, roughness, NV, diffuse } = look;
  const arriving = (nPrime: Vec3, radiance: (n: Vec3) => Vec3): Vec3 => {
    const n = rest.out(nPrime);
    return rest.radiance(radiance(n), n);
  };
  const soft = (n: Vec3) => skyLight(environment, n, uniforms.zenith);
  const sharp = (n: Vec3) => mix(skyRadiance(environment, n, uniforms.zenith), soft(n), roughness.sqrt());
  const mirrored = normalize(reflect(V.negate(), N)).toVar();

  const r = roughness.mul(-1).add(1).toVar();
  const a = min(r.mul(r), exp2(NV.mul(-9.28)))
    .mul(r)
    .add(roughness.mul(0.0225).add(0.0425))
    .toVar();
  const scaleF = a.mul(-1.04).add(roughness.mul(-0.572).add(1.04));
  const bias = a.mul(1.04).add(roughness.mul(0.022).sub(0.04));
  // A rough surface mirrors a wide part of the sky, of which its neighbours hide much; nothing else here knows of neighbours.
  const open = roughness.mul(roughness).mul(-0.75).add(1);
  const specular = F0.mul(scaleF).add(bias).mul(open);
  return arriving(N, soft)
    .mul(diffuse)
    .add(arriving(mirrored, sharp).mul(max(specular, 0)));
}
