import { clamp, dot, float, length, max, min, mix, normalize, select, vec3, vec4 } from 'three/tsl';
import { MIN_LOBE_ROUGHNESS } from '../../scene/materials/specularLobe.ts';
import type { Float, Vec3, Vec4 } from '../../shaders/types.ts';
import type { SpectralFilterNodes } from '../color/radiance.ts';
import type { SpecularParameters } from '../gbuffer/surfacePacking.ts';
import type { LobeNodes, LobeTable } from './lobeTable.ts';

// Lambert and GGX with Schlick's Fresnel, all in the surface's rest frame; N, V, L are unit vectors away from the surface (docs/physics.md §6.7).

/** A surface's BRDF for the direction V to the observer. */
export interface BrdfNodes {
  readonly diffuse: SpectralFilterNodes;
  /** Specular reflectance at normal and at grazing incidence. */
  readonly F0: SpectralFilterNodes;
  readonly F90: Float;
  readonly roughness: Float;
  /** Its microfacets, if they have a direction; `roughness` is then a mean, for light from all round. */
  readonly grooves?: GrooveNodes;
  readonly N: Vec3;
  readonly V: Vec3;
  readonly NV: Float;
  /** Of its specular part; `lobes` for more of it. */
  readonly lobe: LobeNodes;
  readonly lobes: LobeTable;
  /** What scattering several times between microfacets multiplies the specular part by (Turquin 2019; docs/physics.md §6.7). */
  readonly multiple: SpectralFilterNodes;
  /** Specular reflectance at the cosine V·H, if it does not go from F₀ to F₉₀ as Schlick has it. */
  readonly fresnel?: (VH: Float) => SpectralFilterNodes;
  /** The specular part for light from L, of the cosine NL, if it is not GGX. */
  readonly specular?: (L: Vec3, NL: Float) => SpectralFilterNodes;
}

/** Unit directions in the surface, along which the widths of the distribution of normals are `a` and `b`. */
export interface GrooveNodes {
  readonly T: Vec3;
  readonly B: Vec3;
  readonly a: Float;
  readonly b: Float;
}

interface ReflectionParameters extends SpecularParameters {
  readonly roughness: Float;
  /** Of its non-metallic part; absent: F₀ without colour, and F₉₀ = 1. */
  readonly tinted?: { readonly F0: SpectralFilterNodes; readonly F90: Float };
}

export function brdfOf(
  albedo: SpectralFilterNodes,
  { metallic, F0, roughness, tinted }: ReflectionParameters,
  N: Vec3,
  V: Vec3,
  lobes: LobeTable,
): BrdfNodes {
  const NV = max(dot(N, V), 1e-3).toVar();
  const clamped = clamp(roughness, MIN_LOBE_ROUGHNESS, 1).toVar();
  const lobe = lobes.at(NV, clamped);
  const reflectance = mix(tinted?.F0 ?? vec4(F0), albedo, metallic).toVar();
  const lost = lobe.scale.add(lobe.bias).reciprocal().sub(1);
  return {
    diffuse: albedo.mul(metallic.oneMinus()).toVar(),
    F0: reflectance,
    // A surface with the refractive index of its surroundings reflects nothing, not even at grazing incidence.
    F90: (tinted ? mix(tinted.F90, 1, metallic) : select(F0.greaterThan(0), float(1), metallic)).toVar(),
    roughness: clamped,
    N,
    V,
    NV,
    lobe,
    lobes,
    multiple: reflectance.mul(lost).add(1).toVar(),
  };
}

/** BRDF · cos for light from L. */
export function evaluateBrdf(brdf: BrdfNodes, L: Vec3): SpectralFilterNodes {
  const NL = clamp(dot(brdf.N, L), 0, 1).toVar();
  return brdf.diffuse
    .mul(1 / Math.PI)
    .add(specularTerm(brdf, L, NL))
    .mul(NL);
}

const specularTerm = (brdf: BrdfNodes, L: Vec3, NL: Float): SpectralFilterNodes =>
  brdf.specular ? brdf.specular(L, NL) : ggx(brdf, L, NL);

/** The specular term for a light with a size, which widens a = roughness² in both directions; the peak is lowered as it is broadened. */
export function areaSpecular(brdf: BrdfNodes, L: Vec3, breadth: Float, depth: Float): SpectralFilterNodes {
  const NL = clamp(dot(brdf.N, L), 0, 1).toVar();
  if (brdf.specular) return brdf.specular(L, NL).mul(NL);
  const even = brdf.roughness.mul(brdf.roughness).toVar();
  const { a, b } = brdf.grooves ?? { a: even, b: even };
  const height = a.mul(b).div(a.add(breadth).mul(b.add(depth)));
  return ggx(brdf, L, NL).mul(height.mul(NL));
}

/** Cook–Torrance with GGX and the height-correlated Smith term (Heitz 2014, eq. 99). */
function ggx(brdf: BrdfNodes, L: Vec3, NL: Float): Vec4 {
  const { F0, F90, V, multiple, fresnel, grooves } = brdf;
  const H = normalize(L.add(V)).toVar();
  const VH = clamp(dot(V, H), 0, 1);
  const F = fresnel ? fresnel(VH.toVar()) : schlick(F0, F90, VH);
  return F.mul(multiple).mul(min(grooves ? grooved(brdf, grooves, L, H, NL) : even(brdf, H, NL), 1e4));
}

/** Distribution times visibility. */
function even({ roughness, N, NV }: BrdfNodes, H: Vec3, NL: Float): Float {
  const a = roughness.mul(roughness).toVar();
  const a2 = a.mul(a).toVar();
  const NH = clamp(dot(N, H), 0, 1).toVar();
  const spread = NH.mul(NH).mul(a2.sub(1)).add(1).toVar();
  const distribution = a2.div(spread.mul(spread).mul(Math.PI));
  const smith = (x: Float, y: Float): Float => x.mul(y.mul(y).mul(a2.oneMinus()).add(a2).sqrt());
  const visibility = max(smith(NL, NV).add(smith(NV, NL)), 1e-4)
    .reciprocal()
    .mul(0.5);
  return distribution.mul(visibility);
}

/** The same with grooves, as of KHR_materials_anisotropy. */
function grooved({ N, V, NV }: BrdfNodes, { T, B, a, b }: GrooveNodes, L: Vec3, H: Vec3, NL: Float): Float {
  const stretched = vec3(dot(T, H).div(a), dot(B, H).div(b), clamp(dot(N, H), 0, 1)).toVar();
  const spread = dot(stretched, stretched).toVar();
  const distribution = a.mul(b).mul(spread).mul(spread).mul(Math.PI).reciprocal();
  const smith = (X: Vec3, x: Float): Float => length(vec3(dot(T, X).mul(a), dot(B, X).mul(b), x));
  const hidden = max(NL.mul(smith(V, NV)).add(NV.mul(smith(L, NL))), 1e-4);
  return distribution.mul(0.5).div(hidden);
}

/** Schlick 1994. */
export function schlick(F0: SpectralFilterNodes, F90: Float, VH: Float): SpectralFilterNodes {
  const oneMinusVH = VH.oneMinus().toVar();
  const oneMinusVH2 = oneMinusVH.mul(oneMinusVH).toVar();
  return mix(F0, vec4(F90), oneMinusVH2.mul(oneMinusVH2).mul(oneMinusVH));
}

/** The specular albedo under uniform light: its split sum is tabulated (scene/materials/specularLobe.ts). */
export const environmentBrdf = ({ F0, F90, lobe, multiple }: BrdfNodes): SpectralFilterNodes =>
  F0.mul(lobe.scale).add(lobe.bias.mul(F90)).mul(multiple);
