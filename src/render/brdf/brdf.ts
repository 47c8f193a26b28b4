import { clamp, dot, exp2, float, max, min, mix, normalize, select, vec4 } from 'three/tsl';
import type { Float, Vec3, Vec4 } from '../../shaders/types.ts';
import type { SpectralFilterNodes } from '../color/radiance.ts';
import type { SpecularParameters } from '../gbuffer/surfacePacking.ts';

// Lambert and GGX with Schlick's Fresnel, all in the surface's rest frame; N, V, L are unit vectors away from the surface (docs/physics.md §6.7).

/** A surface's BRDF for the direction V to the observer. */
export interface BrdfNodes {
  readonly diffuse: SpectralFilterNodes;
  /** Specular reflectance at normal and at grazing incidence. */
  readonly F0: SpectralFilterNodes;
  readonly F90: Float;
  readonly roughness: Float;
  readonly N: Vec3;
  readonly V: Vec3;
  readonly NV: Float;
}

interface Roughness {
  readonly roughness: Float;
}

export function brdfOf(
  albedo: SpectralFilterNodes,
  { metallic, F0, roughness }: SpecularParameters & Roughness,
  N: Vec3,
  V: Vec3,
): BrdfNodes {
  return {
    diffuse: albedo.mul(metallic.oneMinus()).toVar(),
    F0: mix(vec4(F0), albedo, metallic).toVar(),
    // A surface with the refractive index of its surroundings reflects nothing, not even at grazing incidence.
    F90: select(F0.greaterThan(0), float(1), metallic).toVar(),
    roughness: clamp(roughness, 0.05, 1).toVar(),
    N,
    V,
    NV: max(dot(N, V), 1e-3).toVar(),
  };
}

/** BRDF · cos for light from L. */
export function evaluateBrdf(brdf: BrdfNodes, L: Vec3): SpectralFilterNodes {
  const NL = clamp(dot(brdf.N, L), 0, 1).toVar();
  return brdf.diffuse
    .mul(1 / Math.PI)
    .add(ggx(brdf, L, NL))
    .mul(NL);
}

/** The specular term for a light with a size, which widens a = roughness² in both directions; the peak is lowered as it is broadened. */
export function areaSpecular(brdf: BrdfNodes, L: Vec3, breadth: Float, length: Float): SpectralFilterNodes {
  const NL = clamp(dot(brdf.N, L), 0, 1).toVar();
  const a = brdf.roughness.mul(brdf.roughness).toVar();
  const height = a.mul(a).div(a.add(breadth).mul(a.add(length)));
  return ggx(brdf, L, NL).mul(height.mul(NL));
}

/** Cook–Torrance with GGX and the height-correlated Smith term (Heitz 2014, eq. 99). */
function ggx({ F0, F90, roughness, N, V, NV }: BrdfNodes, L: Vec3, NL: Float): Vec4 {
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
  const oneMinusVH = clamp(dot(V, H), 0, 1).oneMinus().toVar();
  const oneMinusVH2 = oneMinusVH.mul(oneMinusVH).toVar();
  const F = mix(F0, vec4(F90), oneMinusVH2.mul(oneMinusVH2).mul(oneMinusVH));
  return F.mul(min(distribution.mul(visibility), 1e4));
}

/** The specular albedo under uniform light: the split-sum fit of Karis (2014, "Physically based shading on mobile"). */
export function environmentBrdf({ F0, F90, roughness, NV }: BrdfNodes): SpectralFilterNodes {
  const r = roughness.mul(-1).add(1).toVar();
  const a = min(r.mul(r), exp2(NV.mul(-9.28)))
    .mul(r)
    .add(roughness.mul(0.0225).add(0.0425))
    .toVar();
  const scaleF = a.mul(-1.04).add(roughness.mul(-0.572).add(1.04));
  const bias = a.mul(1.04).add(roughness.mul(0.022).sub(0.04));
  // A rough surface reflects a wide part of the sky, much of which its surroundings occlude; nothing else here knows of them.
  const unoccluded = roughness.mul(roughness).mul(-0.75).add(1);
  return max(F0.mul(scaleF).add(bias.mul(F90)).mul(unoccluded), 0);
}
