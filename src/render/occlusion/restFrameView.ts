import { dot, float, inverseSqrt, length, max, min, select, sqrt, vec3 } from 'three/tsl';
import type { Float, Vec3, Vec4 } from '../../shaders/types.ts';
import type { SpacetimeProjection } from '../geometry/vertexStage.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';

/** A point of a surface as seen in the picture: (Δx, c(t − t_o)) relative to the observer [m], and (v, 1 − v²), absent if nothing in the scene moves. */
export interface GBufferPoint {
  readonly event: Vec4;
  readonly velocity?: Vec4;
}

/**
 * The view of an observer at the camera's event who is at rest relative to a point that is seen (docs/physics.md §9.5). In it the surroundings of the point
 * are an ordinary picture: what moves with the point has its own shape, and straight lines are straight. Vectors are in the point's rest frame [m].
 * A camera that has stepped aside is where a point that is seen there would be.
 */
export interface RestFrameView {
  /** From the camera to the point. */
  readonly position: Vec3;
  /** From the point to a neighbour that moves with it. */
  comovingOffset(neighbour: Vec4): Vec3;
  /** From the point to a surface that is seen elsewhere, at the event where the light that now meets the point passed it. */
  retardedOffset(other: GBufferPoint): Vec3;
  /** The direction in the camera's picture of the point + ρ·across, a unit vector: on the world axes carried by the boost, of any length. */
  projectAlong(across: Vec3): (rho: Float) => Vec3;
}

/**
 * Everything is linear in places and their distances, so little is left to compute per neighbour. Cancellation close to c costs digits that ambient occlusion
 * does not need; shaders/ has the forms that keep them.
 */
export function restFrameViewOf(
  { event, velocity }: GBufferPoint,
  projection: SpacetimeProjection['place'],
  uniforms: FrameUniforms,
): RestFrameView {
  const rest = velocity ? restFrameBoostOf(velocity, uniforms) : undefined;
  const atRest = (x: Vec3): Vec3 => (rest ? boosted(x, length(x), rest) : x);
  const place = atRest(event.xyz).toVar();
  const distance2 = dot(place, place).toVar();
  const observer = placingObserver(event.xyz, uniforms);
  const { vantage } = uniforms;
  const camera = atRest(UNPLACED[projection](vantage, observer)).toVar();
  const projectPlace = (x: Vec3, distance: Float): Vec3 => {
    if (!rest) return PLACED[projection](x, distance, observer);
    const back = { u: rest.u.negate(), gamma: rest.gamma };
    return PLACED[projection](boosted(x, distance, back), rest.gamma.mul(distance).sub(dot(rest.u, x)), observer);
  };
  return {
    position: place.sub(camera),
    comovingOffset: (neighbour) => {
      const separation = neighbour.sub(event).toVar();
      return rest ? boosted(separation.xyz, separation.w.negate(), rest) : separation.xyz;
    },
    retardedOffset: (other) => {
      const separation = other.event.sub(event).toVar();
      if (!rest || !other.velocity) return separation.xyz;
      const crossing = onLightConeOf(separation, other.velocity);
      const retarded = select(uniforms.lightTravels.greaterThan(0.5), crossing, separation.xyz).toVar();
      return boosted(retarded, length(retarded), rest);
    },
    projectAlong: (across) => {
      const [from, step, far] = [
        projectPlace(place, float(0)),
        projectPlace(across, float(0)),
        projectPlace(vec3(0), float(1)),
      ].map((x) => x.toVar());
      const along = dot(place, across).mul(2).toVar();
      const square = (rho: Float): Float => max(rho.add(along).mul(rho).add(distance2), 0);
      return (rho) =>
        from
          .sub(vantage)
          .add(step.mul(rho))
          .add(far.mul(sqrt(square(rho))));
    },
  };
}

interface RestFrameBoost {
  /** γβ and γ in the world. */
  readonly u: Vec3;
  readonly gamma: Float;
}

/** The world itself in views without aberration and Doppler shift. */
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

/** The observer, and how places in the world are to those of the slowed world (docs/physics.md §5.8). */
interface PlacingObserver extends Pick<FrameUniforms, 'u' | 'gamma' | 'slowedU' | 'slowedGamma'> {
  /** Y = x − c (c·x). */
  readonly contraction: Vec3;
  /** |Y|/|x| of the point that is seen. */
  readonly nearness: Float;
}

function placingObserver(x: Vec3, { u, gamma, slowedU, slowedGamma }: FrameUniforms): PlacingObserver {
  const share = max(float(1).sub(slowedGamma.div(gamma)), 0);
  const contraction = u
    .div(max(length(u), 1e-20))
    .mul(sqrt(share))
    .toVar();
  const along = dot(contraction, x);
  const nearness = length(x.sub(contraction.mul(along)))
    .div(max(length(x), 1e-20))
    .toVar();
  return { u, gamma, slowedU, slowedGamma, contraction, nearness };
}

/**
 * The observer position of a place in the world at a distance, linear in both (docs/physics.md §3.3, §5.5; `PLACES` of vertexStage.ts takes the distance
 * from the place).
 */
const PLACED: Readonly<
  Record<SpacetimeProjection['place'], (x: Vec3, distance: Float, observer: PlacingObserver) => Vec3>
> = {
  apparent: (x, distance, { u, gamma }) => boosted(x, distance, { u, gamma }),
  contracted: (x, _, { u, gamma }) => x.sub(u.mul(dot(u, x).div(gamma.mul(gamma.add(1))))),
  shallow: (x, distance, { slowedU, slowedGamma, contraction, nearness }) =>
    boosted(x.sub(contraction.mul(dot(contraction, x))), distance.mul(nearness), { u: slowedU, gamma: slowedGamma }),
  plain: (x) => x,
};

/** The inverse of `PLACED` at its own distance. */
const UNPLACED: Readonly<Record<SpacetimeProjection['place'], (x: Vec3, observer: PlacingObserver) => Vec3>> = {
  apparent: (x, { u, gamma }) => boosted(x, length(x).negate(), { u, gamma }),
  contracted: (x, { u, gamma }) => boosted(x, float(0), { u, gamma }),
  shallow(x, { slowedU, slowedGamma, contraction }) {
    const Y = boosted(x, length(x).negate(), { u: slowedU, gamma: slowedGamma }).toVar();
    return Y.add(contraction.mul(dot(contraction, Y).div(float(1).sub(dot(contraction, contraction)))));
  },
  plain: (x) => x,
};

/**
 * Where a neighbour crosses the past light cone of a point, from which its seen event is separated by `apart`: as in shaders/emission/ontoLightCone.ts, but
 * also for later events.
 */
function onLightConeOf(separation: Vec4, velocity: Vec4): Vec3 {
  const { xyz: x, w: time } = separation;
  const q = max(dot(x, x).sub(time.mul(time)), 0).toVar();
  const b = time.sub(dot(x, velocity.xyz)).toVar();
  const later = q.div(min(b.sub(sqrt(b.mul(b).add(velocity.w.mul(q)))), -1e-20));
  return x.add(velocity.xyz.mul(later));
}
