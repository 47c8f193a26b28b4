import {
  abs,
  acos,
  atan,
  clamp,
  dot,
  float,
  int,
  length,
  log,
  max,
  min,
  mix,
  select,
  sign,
  sqrt,
  step,
  vec3,
  vec4,
} from 'three/tsl';
import type { Float, Int, Vec3, Vec4 } from '../../../shaders/types.ts';
import type { RestFrameMotion } from '../restFrame.ts';

/**
 * Means of a sky over the cone of this rapidity about a world axis (skyMeans.ts): of its radiance L, of L n·direction, and of L over all of the cone alike. All
 * vectors are unit vectors.
 */
export type SkyMeans = (
  axis: Vec3,
  rapidity: Float,
  direction: Vec3,
) => { readonly mean: Vec3; readonly along: Vec3; readonly even: () => Vec3 };

/** A cone max(n·axis − c, 0) of directions in the rest frame of a surface; `width` = √(1 − c), 1 for Lambert's cosine. */
export interface LobeCone {
  readonly axis: Vec3;
  readonly width: Float;
  readonly rings: keyof typeof QUADRATURES;
}

/** A cone's light as it arrives on its rings about the direction of motion. */
export interface SkyLobe {
  /** Its D; its weight in the mean of the rest frame's radiance, D⁴ times that of the world; and the latter. */
  ring(i: Int): { readonly D: Float; readonly weight: Float; readonly radiance: Vec3 };
  /** Of Lambert's cone: the weight in the mean over the lobe of roughness 1 that is seen at the cosine NV, ∝ N·L/(N·L + NV). */
  wideWeight(NV: Float): (i: Int) => Float;
}

/** Gauss–Legendre quadratures on 0 … 1, by the number of rings. */
const QUADRATURES = {
  2: { nodes: [0.2113248654051871, 0.7886751345948129, 0.5, 0.5], weights: [0.5, 0.5, 0, 0] },
  4: {
    nodes: [0.0694318442029737, 0.3300094782075719, 0.6699905217924281, 0.9305681557970263],
    weights: [0.1739274225687269, 0.3260725774312731, 0.3260725774312731, 0.1739274225687269],
  },
} as const;

/**
 * What a moving surface receives of the sky within a cone (docs/physics.md §6.8). In the world, D(n′·axis − c) is linear in n: N·n + N⁰ with the boosted
 * four-vector (−c, axis). So on a ring of one D the visible arc, and its integral for a uniform sky, are closed forms. Of other skies the means of
 * L and of L D are tabulated; over the rings radiance is taken as linear in D, with these means.
 */
export function skyLobe({ axis, width, rings }: LobeCone, { u, gamma }: RestFrameMotion, means: SkyMeans): SkyLobe {
  const speed = length(u).toVar();
  const direction = u.div(speed).toVar();
  const beta = speed.div(gamma).toVar();
  // 1 − β, also where that is tiny.
  const m = gamma.mul(gamma.add(speed)).reciprocal().toVar();
  const spread = width.mul(width).toVar();
  const c = spread.oneMinus().toVar();
  const along = clamp(dot(axis, direction), -1, 1).toVar();
  const across = sqrt(max(along.mul(along).oneMinus(), 0)).toVar();

  // The range of the rest frame's cosines to the direction of motion, as 1 + cosine in the world.
  const [near, far] = [along.mul(c).toVar(), across.mul(sqrt(max(c.mul(c).oneMinus(), 0))).toVar()];
  const inWorld = (cosine: Float): Float => m.mul(cosine.add(1)).div(cosine.oneMinus().add(cosine.mul(m)));
  const first = inWorld(select(along.lessThan(c.negate()), float(-1), near.sub(far)).toVar()).toVar();
  const range = inWorld(select(along.greaterThan(c), float(1), near.add(far)).toVar())
    .sub(first)
    .toVar();

  // Steps even in √D.
  const root = sqrt(m.add(beta.mul(first))).toVar();
  const sum = root.add(sqrt(m.add(beta.mul(first.add(range))))).toVar();
  const stride = beta.mul(range).div(sum).toVar();
  const nodes = vec4(...QUADRATURES[rings].nodes);
  const s = nodes
    .mul(nodes.mul(stride).add(root.mul(2)))
    .mul(range.div(sum))
    .add(first)
    .toVar();
  const ds = nodes
    .mul(stride)
    .add(root)
    .mul(vec4(...QUADRATURES[rings].weights))
    .mul(range.mul(2).div(sum))
    .toVar();
  const D = s.mul(beta).add(m).mul(gamma).toVar();
  // (N·n + N⁰) on a ring is A + B cos φ, above 0 within ±φ.
  const A = s
    .mul(along.sub(beta.mul(c)))
    .sub(m.mul(c.add(along)))
    .mul(gamma)
    .toVar();
  const B = max(sqrt(max(s.mul(s.negate().add(2)), 0)).mul(across), 1e-12).toVar();
  const cosine = clamp(A.div(B).negate(), -1, 1).toVar();
  const angle = acos(cosine).toVar();
  const visible = max(A.mul(angle).add(B.mul(sqrt(cosine.mul(cosine).oneMinus()))), 0);
  const shares: Vec4 = visible.mul(ds).mul(2).toVar();

  // The cone in the world: N² − N⁰² is that of the rest frame.
  const square = spread.mul(spread.negate().add(2)).toVar();
  const time = gamma.mul(beta.mul(along).sub(c)).toVar();
  const size = sqrt(time.mul(time).add(square)).toVar();
  const worldAxis = along.mul(speed).div(gamma.add(1)).sub(c).mul(u).add(axis).div(size).toVar();
  const rapidity = sign(time).mul(log(size.add(abs(time))).sub(log(square).mul(0.5)));
  const seen = means(worldAxis, rapidity, direction);
  const mean = seen.mean.toVar();
  // The mean of D, over that of a uniform sky, whose mean n is (2 − N⁰/N)/3 along the axis.
  const uniform = time.div(size).negate().add(2).div(3).mul(dot(worldAxis, direction)).mul(beta).add(1);
  const shift = seen.along.mul(beta).add(mean).div(max(uniform, 1e-6));

  const whole = max(dot(shares, vec4(1)), 1e-20).toVar();
  const middle = dot(shares, D).div(whole).toVar();
  const off = D.sub(middle).toVar();
  const variance = max(dot(shares, off.mul(off)).div(whole), 1e-12);
  const slope = shift.div(max(mean, 1e-9)).sub(1).mul(middle.div(variance)).toVar();
  const tilt = (distance: Float): Vec3 => max(slope.mul(distance).add(1), 0);
  const tilted = [off.x, off.y, off.z, off.w].reduce<Vec3>(
    (all, distance, i) => all.add(tilt(distance).mul([shares.x, shares.y, shares.z, shares.w][i])),
    vec3(0),
  );
  const level = mean.mul(whole).div(max(tilted, 1e-20)).toVar();
  // The shares of a uniform sky add up to ∫ max(N·n + N⁰, 0) dΩ = π (N + N⁰)²/N.
  const large = size.add(abs(time)).toVar();
  const opening = select(time.greaterThan(0), large, square.div(large)).div(spread).toVar();
  const perShare = opening.mul(opening).div(size.mul(whole)).toVar();

  return {
    wideWeight: (NV) => {
      // ∫ N·L/(N·L + NV) dφ = 2φ − NV D ∫ dφ/(P + B cos φ)
      const P = D.mul(NV).add(A).toVar();
      const whole = log(NV.reciprocal().add(1)).mul(NV).oneMinus();
      const t2 = cosine
        .oneMinus()
        .div(max(cosine.add(1), 1e-7))
        .toVar();
      const z = P.sub(B).div(P.add(B)).mul(t2).toVar();
      const root = sqrt(max(abs(z), 1e-8)).toVar();
      const narrow = clamp(root, 0, 1 - 1e-6);
      const hyperbolic = log(narrow.add(1).div(narrow.oneMinus())).mul(0.5);
      const inverse = sqrt(t2)
        .mul(4)
        .div(P.add(B))
        .div(root)
        .mul(selectEach(z, atan(root), hyperbolic));
      const arc: Vec4 = max(angle.mul(2).sub(D.mul(NV).mul(inverse)), 0);
      const weights: Vec4 = arc
        .mul(ds)
        .div(D.mul(D))
        .div(whole.mul(2 * Math.PI))
        .toVar();
      // The lobe's mean cosine lies between those of an even hemisphere, 1/2, and of Lambert's cosine, 2/3.
      const meanCosine = whole.reciprocal().mul(0.5).sub(NV);
      const lambert = clamp(meanCosine.sub(0.5).mul(6), 0, 1);
      const rings = angle.mul(ds).toVar();
      const onRings = [0, 1, 2, 3].reduce<Vec3>(
        (all, i) => all.add(level.mul(tilt(component(D, int(i)).sub(middle))).mul(component(rings, int(i)))),
        vec3(0),
      );
      const even = luminance(seen.even())
        .mul(dot(rings, vec4(1)))
        .div(max(luminance(onRings), 1e-20));
      const factor = mix(min(even, MAX_EVEN), 1, lambert).toVar();
      return (i) => component(weights, i).mul(factor);
    },
    ring: (i) => {
      const own = component(D, i).toVar();
      return {
        D: own,
        weight: component(shares, i).mul(perShare).div(own.mul(own).mul(own)),
        radiance: level.mul(tilt(own.sub(middle))),
      };
    },
  };
}

/** Bound of the light from all of a hemisphere alike over that of its rings, which may be dark. */
const MAX_EVEN = 10;

const luminance = (rgb: Vec3): Float => dot(rgb, vec3(0.2126, 0.7152, 0.0722));

/** By component: `a` where `sign` is positive, else `b`. */
const selectEach = (sign: Vec4, a: Vec4, b: Vec4): Vec4 => mix(b, a, step(vec4(0), sign));

/** The component of a vector by its number. */
const component = (v: Vec4, i: Int): Float =>
  select(i.lessThan(2), select(i.equal(0), v.x, v.y), select(i.equal(2), v.z, v.w));
