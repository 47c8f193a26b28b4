import { dot, float, inverseSqrt, length, max, min, select, sqrt, vec3 } from 'three/tsl';
import type { Float, Vec3, Vec4 } from '../../shaders/types.ts';
import type { SpacetimeProjection } from '../geometry/vertexStage.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';

/** A point of a surface, as the picture shows it: (Δx, c(t − t_o)) from the observer [m], and (v, 1 − v²) where not all things rest. */
export interface GBufferPoint {
  readonly event: Vec4;
  readonly velocity?: Vec4;
}

/**
 * Somebody who is where the observer is, but rests with a point that is seen. To him what is around the point is an ordinary picture: what moves with
 * the point has its own shape, and straight lines are straight. Vectors are of the point's rest frame [m].
 */
export interface RestFrameView {
  /** From him to the point. */
  readonly position: Vec3;
  /** From the point to a neighbour that moves with it. */
  comovingOffset(neighbour: Vec4): Vec3;
  /** From the point to what is shown elsewhere: to where that was when the light passed it that now meets the point. */
  retardedOffset(other: GBufferPoint): Vec3;
  /** Where the observer's picture has what he sees at place + ρ·across, `across` ⊥ place: on the world axes that the boost carries, any length. */
  projectAlong(across: Vec3): (rho: Float) => Vec3;
}

/**
 * All of it is linear in places and their distances, so that little is left to be done for each neighbour. Cancellation close to c costs digits that a
 * hidden share of the sky does not need: shaders/ has the forms that keep them.
 */
export function restFrameViewOf(
  { event, velocity }: GBufferPoint,
  projection: SpacetimeProjection['place'],
  uniforms: FrameUniforms,
): RestFrameView {
  const rest = velocity ? restFrameBoostOf(velocity, uniforms) : undefined;
  const place = (rest ? boosted(event.xyz, length(event.xyz), rest) : event.xyz).toVar();
  const distance2 = dot(place, place).toVar();
  const pictured = (x: Vec3, distance: Float): Vec3 => {
    if (!rest) return projected(x, distance, projection, uniforms);
    const back = { u: rest.u.negate(), gamma: rest.gamma };
    return projected(boosted(x, distance, back), rest.gamma.mul(distance).sub(dot(rest.u, x)), projection, uniforms);
  };
  return {
    position: place,
    comovingOffset: (neighbour) => {
      const apart = neighbour.sub(event).toVar();
      return rest ? boosted(apart.xyz, apart.w.negate(), rest) : apart.xyz;
    },
    retardedOffset: (other) => {
      const apart = other.event.sub(event).toVar();
      if (!rest || !other.velocity) return apart.xyz;
      const met = onLightConeOf(apart, other.velocity);
      const there = select(uniforms.lightTravels.greaterThan(0.5), met, apart.xyz).toVar();
      return boosted(there, length(there), rest);
    },
    projectAlong: (across) => {
      const [from, step, far] = [
        pictured(place, float(0)),
        pictured(across, float(0)),
        pictured(vec3(0), float(1)),
      ].map((x) => x.toVar());
      return (rho) => from.add(step.mul(rho)).add(far.mul(sqrt(rho.mul(rho).add(distance2))));
    },
  };
}

interface RestFrameBoost {
  /** γβ and γ in the world. */
  readonly u: Vec3;
  readonly gamma: Float;
}

/** The world itself in the views that show no light. */
function restFrameBoostOf(velocity: Vec4, { boostLight }: FrameUniforms): RestFrameBoost {
  const u = velocity.xyz
    .mul(inverseSqrt(max(velocity.w, 1e-12)))
    .mul(boostLight)
    .toVar();
  return { u, gamma: sqrt(dot(u, u).add(1)).toVar() };
}

/** The place of an event in another frame, `ago` before the origin: x + [u·x/(γ + 1) + ago] u. On the past light cone `ago` = |x|. */
const boosted = (x: Vec3, ago: Float, { u, gamma }: RestFrameBoost): Vec3 =>
  x.add(u.mul(dot(u, x).div(gamma.add(1)).add(ago)));

/** Where the picture has a place of the world at a distance (shaders/kinematics/apparentPosition.ts, simultaneousPosition.ts). */
function projected(x: Vec3, distance: Float, shown: SpacetimeProjection['place'], { u, gamma }: FrameUniforms): Vec3 {
  if (shown === 'plain') return x;
  if (shown === 'apparent') return boosted(x, distance, { u, gamma });
  return x.sub(u.mul(dot(u, x).div(gamma.mul(gamma.add(1)))));
}

/** Where a neighbour crosses the past light cone of a point, from which its shown event is `apart`: as shaders/emission/ontoLightCone.ts, for what may be later, too. */
function onLightConeOf(apart: Vec4, velocity: Vec4): Vec3 {
  const { xyz: x, w: time } = apart;
  const q = max(dot(x, x).sub(time.mul(time)), 0).toVar();
  const b = time.sub(dot(x, velocity.xyz)).toVar();
  const later = q.div(min(b.sub(sqrt(b.mul(b).add(velocity.w.mul(q)))), -1e-20));
  return x.add(velocity.xyz.mul(later));
}
