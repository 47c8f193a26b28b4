import { clamp, dot, exp, float, max, min, mix, normalize, pow, select, vec4 } from 'three/tsl';
import { MIN_SHEEN_ROUGHNESS, SHEEN_FITS } from '../../scene/materials/sheenLobe.ts';
import type { Float, Vec3 } from '../../shaders/types.ts';
import type { BrdfNodes } from '../brdf/brdf.ts';
import type { LobeTable } from '../brdf/lobeTable.ts';
import type { RadianceAccumulator } from '../color/radiance.ts';

/** Fuzz at a fragment: linear sRGB, and roughness. */
export interface FuzzNodes {
  readonly color: Vec3;
  readonly roughness: Float;
}

/** What fibres reflect as a BRDF, and the share of light that passes them. Light from all round is reflected as by the roughest surface, about their own mean direction. */
export function fuzzOf(
  { color, roughness }: FuzzNodes,
  N: Vec3,
  V: Vec3,
  lobes: LobeTable,
  filter: RadianceAccumulator['filter'],
): { readonly brdf: BrdfNodes; readonly passed: Float } {
  const NV = max(dot(N, V), 1e-3).toVar();
  const clamped = clamp(roughness, MIN_SHEEN_ROUGHNESS, 1).toVar();
  const { share, cosine, gain } = lobes.sheen(NV, clamped);
  const reflected = filter(color).toVar();
  const alpha = clamped.mul(clamped).toVar();
  const hidden = sheenLambda(NV, alpha).add(1).toVar();
  const strength = reflected.mul(gain).toVar();
  const brdf: BrdfNodes = {
    diffuse: vec4(0),
    F0: reflected,
    F90: float(0),
    roughness: float(1),
    N,
    V,
    NV,
    lobe: { scale: share.toVar(), bias: float(0), cosine: cosine.toVar() },
    lobes,
    multiple: vec4(1),
    specular: (L, NL) => strength.mul(sheenTerm(max(NL, 1e-4), NV, dot(N, normalize(L.add(V))), alpha, hidden)),
  };
  const most = min(max(color.x, max(color.y, color.z)), 1);
  return { brdf, passed: most.mul(share).oneMinus().toVar() };
}

/** As `sheenTerm` of scene/materials/sheenLobe.ts; `hidden` is 1 + Λ(N·V). */
function sheenTerm(NL: Float, NV: Float, NH: Float, alpha: Float, hidden: Float): Float {
  const sine2 = max(NH.mul(NH).oneMinus(), 1e-7);
  const distribution = pow(sine2, alpha.reciprocal().mul(0.5)).mul(
    alpha
      .reciprocal()
      .add(2)
      .div(2 * Math.PI),
  );
  return distribution.div(hidden.add(sheenLambda(NL, alpha)).mul(NL).mul(NV).mul(4));
}

function sheenLambda(cosine: Float, alpha: Float): Float {
  const t = alpha.oneMinus().mul(alpha.oneMinus()).toVar();
  const [a, b, c, d, e] = SHEEN_FITS.rough.map((rough, i) => mix(rough, SHEEN_FITS.smooth[i], t).toVar());
  const fitted = (x: Float): Float => a.div(pow(x, c).mul(b).add(1)).add(d.mul(x)).add(e).toVar();
  const isLow = cosine.lessThan(0.5);
  const there = fitted(max(select(isLow, cosine, cosine.oneMinus()), 1e-6));
  return exp(select(isLow, there, fitted(float(0.5)).mul(2).sub(there)));
}
