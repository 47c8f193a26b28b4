import { cross, dFdx, dFdy, dot, inverseSqrt, normalize, select, sign, vec3 } from 'three/tsl';
import type { DataTexture } from 'three/webgpu';
import type { Vec2, Vec3, Vec4 } from '../../shaders/types.ts';
import { sampled } from '../gpu/textures.ts';

/** The surface that a normal map is applied to. */
export interface NormalMapSurface {
  /** Unit normal in the rest frame, on the mesh's front side. */
  readonly normal: Vec3;
  /** Observer → event [m] and c(t − t_o). */
  readonly event: Vec4;
  /** (v, 1 − v²) */
  readonly velocity: Vec4;
  /** v downwards. */
  readonly uv: Vec2;
}

/** Below this squared length a vector has no direction. */
const MIN_LENGTH2 = 1e-30;

/**
 * The normal from a normal map, in the rest frame (scene/types.ts, NormalTexture). The tangent frame is found from the screen derivatives of events and uvs:
 * the separation of two events of a surface, boosted to its rest frame, lies in the surface whatever their times are (docs/physics.md §6.3).
 */
export function mappedNormal(
  map: DataTexture,
  strength: Vec2,
  { normal: N, event, velocity, uv }: NormalMapSurface,
): Vec3 {
  const { T, B, exists } = tangentFrame(N, uvDirections({ event, velocity, uv }));
  const texel = sampled(map, uv).xyz.mul(2).sub(1).toVar();
  const slope = texel.xy.mul(strength).toVar();
  const mapped = T.mul(slope.x).add(B.mul(slope.y)).add(N.mul(texel.z)).toVar();
  return select(exists.and(dot(mapped, mapped).greaterThan(MIN_LENGTH2)), normalize(mapped), N);
}

/** Directions of increasing u, and of increasing v upwards, in the rest frame, of any length. */
export interface UvDirections {
  readonly alongU: Vec3;
  readonly alongV: Vec3;
}

/** By differences between neighbouring fragments, so call it before any discard. */
export function uvDirections({ event, velocity, uv }: Omit<NormalMapSurface, 'normal'>): UvDirections {
  const [right, down] = [dFdx, dFdy].map((d) => restOffset(d(event).toVar(), velocity).toVar());
  const [uvRight, uvDown] = [dFdx, dFdy].map((d) => d(uv).toVar());
  const side = sign(uvRight.x.mul(uvDown.y).sub(uvRight.y.mul(uvDown.x))).toVar();
  return {
    alongU: right.mul(uvDown.y).sub(down.mul(uvRight.y)).mul(side).toVar(),
    alongV: right.mul(uvDown.x).sub(down.mul(uvRight.x)).mul(side).toVar(),
  };
}

/** Unit vectors across N, along u and towards v; `exists`: whether there are any. */
export function tangentFrame(N: Vec3, { alongU, alongV }: UvDirections) {
  const across = alongU.sub(N.mul(dot(N, alongU))).toVar();
  const T = across.mul(inverseSqrt(dot(across, across).max(MIN_LENGTH2))).toVar();
  const third = cross(N, T).toVar();
  const B = third.mul(sign(dot(third, alongV))).toVar();
  return { T, B, exists: dot(across, across).greaterThan(MIN_LENGTH2) };
}

/** The spatial part, in the frame that moves with `velocity`, of the separation of two events in the world. */
function restOffset(separation: Vec4, velocity: Vec4): Vec3 {
  const gamma = inverseSqrt(velocity.w.clamp(1e-20, 1)).toVar();
  const u = vec3(velocity.xyz).mul(gamma).toVar();
  return separation.xyz.add(u.mul(dot(u, separation.xyz).div(gamma.add(1)).sub(separation.w)));
}
