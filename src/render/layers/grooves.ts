import { clamp, mix, normalize, pow, select, vec3 } from 'three/tsl';
import { MIN_LOBE_ROUGHNESS } from '../../scene/materials/specularLobe.ts';
import type { Float, Vec2, Vec3 } from '../../shaders/types.ts';
import type { GrooveNodes } from '../brdf/brdf.ts';
import { tangentFrame, type UvDirections } from '../gbuffer/normalMap.ts';

/** Grooves at a fragment: their direction along u and v, of any length, and how much they widen its reflection, 0 … 1. */
export interface GroovesHere {
  readonly uv: UvDirections;
  readonly direction: Vec2;
  readonly strength: Float;
}

/** Microfacets in grooves; `mean`: roughness of an even surface that reflects nearly the same share of light from all round, whose α² is the mean of theirs. */
export function groovesOf(
  { uv, direction, strength }: GroovesHere,
  roughness: Float,
  N: Vec3,
): GrooveNodes & { readonly mean: Float } {
  const { T: alongU, B: alongV, exists } = tangentFrame(N, uv);
  const even = clamp(roughness, MIN_LOBE_ROUGHNESS, 1).toVar();
  const b = even.mul(even).toVar();
  const s = clamp(strength, 0, 1);
  const a = select(exists, mix(b, 1, s.mul(s)), b).toVar();
  // Any direction serves where there is none.
  const across = normalize(select(N.z.abs().lessThan(0.9), vec3(N.y, N.x.negate(), 0), vec3(0, N.z, N.y.negate())));
  const T = select(exists, normalize(alongU.mul(direction.x).add(alongV.mul(direction.y))), across).toVar();
  return { T, B: N.cross(T).toVar(), a, b, mean: pow(a.mul(a).add(b.mul(b)).mul(0.5), 0.25).toVar() };
}
