import { abs, clamp, dot, float, length, max, min, round, select, sign, sqrt, uint } from 'three/tsl';
import type { Float, Vec3 } from '../../shaders/types.ts';
import { type Bitmask, countBits } from './bitCount.ts';

/** Sectors into which the light of a half circle is divided, one bit each. */
const SECTORS = 32;

/**
 * A plane through the view direction V and the direction T, in which a surface is lit from angles θ, from V towards T (docs/physics.md §9.5). Its part of the
 * hemisphere's light is |n| ∫ cos(θ − ν) |sin θ| dθ for the normal's projection n at the angle ν: between 0 and θ that is a(θ) = ¼(cos ν − cos(2θ − ν) + 2θ
 * sin ν). Source: Jimenez, Wu, Pesce, Jarabo 2016, "Practical real-time strategies for accurate indirect occlusion", eq. 7.
 */
export class OcclusionSlice {
  readonly V: Vec3;
  private readonly cos: Float;
  private readonly sin: Float;
  private readonly projection: Float;
  private readonly irradianceBefore: Float;
  private readonly totalIrradiance: Float;
  private readonly occludedSectors: Bitmask = uint(0).toVar();

  /** `axis` = T × V; all unit vectors. */
  constructor(V: Vec3, T: Vec3, axis: Vec3, normal: Vec3) {
    this.V = V;
    const projected = normal.sub(axis.mul(dot(normal, axis))).toVar();
    this.projection = max(length(projected), 1e-4).toVar();
    this.cos = clamp(dot(projected, V).div(this.projection), 0, 1).toVar();
    this.sin = sqrt(this.cos.mul(this.cos).oneMinus())
      .mul(sign(dot(projected, T)))
      .toVar();
    const nu = acosApproximation(this.cos).mul(sign(this.sin));
    this.totalIrradiance = this.cos.add(nu.mul(this.sin)).toVar();
    this.irradianceBefore = this.irradianceUntil(this.sin, -1).toVar();
  }

  /**
   * Marks the angles between two directions on one side of V as occluded, if `exists` is 1. Source of the bitmask: Therrien, Levesque, Gilet 2023, "Screen
   * space indirect lighting with visibility bitmask".
   */
  occlude(front: Vec3, back: Vec3, side: 1 | -1, exists: Float): void {
    const [p, q] = [front, back].map((direction) => this.sectorOf(direction, side).toVar());
    const first = min(p, q).toVar();
    const count = max(p, q).sub(first).mul(exists).toVar();
    const bits = uint(0xffffffff)
      .shiftRight(uint(float(SECTORS).sub(max(count, 1))))
      .shiftLeft(uint(min(first, SECTORS - 1)));
    this.occludedSectors.assign(select(count.greaterThan(0.5), this.occludedSectors.bitOr(bits), this.occludedSectors));
  }

  /** Occluded fraction of the hemisphere's light, if all slices were like this one. */
  get occludedShare(): Float {
    return countBits(this.occludedSectors).mul(this.totalIrradiance.mul(this.projection).div(SECTORS));
  }

  /** The sector in which a direction is: the light from before it, in units of SECTORS. Directions below the horizon are clamped to it. */
  private sectorOf(direction: Vec3, side: 1 | -1): Float {
    const cosine = dot(direction, this.V).div(max(length(direction), 1e-20));
    const light = this.irradianceUntil(max(cosine, this.sin.mul(-side)).toVar(), side);
    return round(clamp(this.irradianceBefore.add(light.mul(side)).div(this.totalIrradiance), 0, 1).mul(SECTORS));
  }

  /** a(θ) for the angle θ on one side of V. */
  private irradianceUntil(cosine: Float, side: 1 | -1): Float {
    const c = clamp(cosine, -1, 1).toVar();
    const s = sqrt(c.mul(c).oneMinus()).mul(side);
    const cosDifference = c.mul(c).mul(2).sub(1).mul(this.cos).add(s.mul(c).mul(2).mul(this.sin));
    return this.cos
      .sub(cosDifference)
      .add(
        acosApproximation(c)
          .mul(2 * side)
          .mul(this.sin),
      )
      .mul(0.25);
  }
}

/** Accurate to 7e-5, at a third of the cost on a software GPU. Source: Abramowitz and Stegun 1964, 4.4.45. */
function acosApproximation(x: Float): Float {
  const y = abs(x).toVar();
  const positive = y
    .mul(-0.0187293)
    .add(0.074261)
    .mul(y)
    .sub(0.2121144)
    .mul(y)
    .add(1.5707288)
    .mul(sqrt(y.oneMinus()))
    .toVar();
  return select(x.lessThan(0), positive.negate().add(Math.PI), positive);
}
