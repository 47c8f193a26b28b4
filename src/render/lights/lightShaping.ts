import { acos, clamp, cross, dot, max, normalize, pow, smoothstep } from 'three/tsl';
import type { LocalLight } from '../../scene/types.ts';
import type { Float, Vec3 } from '../../shaders/types.ts';

/** `LightShaping` on the GPU; `front`: unit −Z of the light's frame. */
export interface ShapingTexels {
  readonly front: Vec3;
  readonly inner: Float;
  readonly outer: Float;
  readonly focus: Float;
}

/** Unit −Z of the axes X and Y. */
export const frontOf = ({ X, Y }: { readonly X: Vec3; readonly Y: Vec3 }): Vec3 => normalize(cross(Y, X)).toVar();

/** Twin of `shapingFactor` of scene/lights/shaping.ts. */
export function shapingFactor({ front, inner, outer, focus }: ShapingTexels, out: Vec3): Float {
  const cosine = clamp(dot(front, out), -1, 1).toVar();
  return smoothstep(inner, outer, acos(cosine))
    .oneMinus()
    .mul(pow(max(cosine, 1e-6), focus));
}

/** `smoothstep` needs two different edges [rad]. */
const MIN_CONE_BLEND = 1e-4;

/** Inner and outer angle [rad] and focus as they are uploaded; without shaping angles beyond π, which every direction is within. */
export function shapingValues({ shaping }: LocalLight): readonly [inner: number, outer: number, focus: number] {
  if (!shaping) return [4, 5, 0];
  return [Math.min(shaping.inner, shaping.outer - MIN_CONE_BLEND), shaping.outer, shaping.focus];
}
