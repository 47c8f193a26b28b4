import type { Random } from '../../math/random.ts';
import { add, addScaled, dot, normalize, scale, type Vec3 } from '../../math/vec3.ts';

/** Chooses the first of two branches with probability `chance`. `rest` reuses the random number of the choice, rescaled, as its first number. */
export function chooseBranch(chance: number, random: Random): { readonly isFirst: boolean; readonly rest: Random } {
  const p = random();
  const isFirst = p < chance;
  let decided: number | undefined = isFirst ? p / chance : (p - chance) / (1 - chance);
  return {
    isFirst,
    rest: () => {
      const number = decided ?? random();
      decided = undefined;
      return number;
    },
  };
}

/** r = d − 2(d·n) n */
export const reflect = (d: Vec3, n: Vec3): Vec3 => {
  const twice = 2 * dot(d, n);
  return [d[0] - twice * n[0], d[1] - twice * n[1], d[2] - twice * n[2]];
};

/** d on the side of n: reflected at the plane of n if it points below. */
export const toHemisphere = (n: Vec3, d: Vec3): Vec3 => (dot(d, n) < 0 ? reflect(d, n) : d);

/** Two unit vectors that form a right-handed orthonormal basis with the unit n. Source: Duff et al. 2017, "Building an orthonormal basis, revisited", JCGT 6(1). */
export function orthonormalBasis([x, y, z]: Vec3): readonly [Vec3, Vec3] {
  const sign = z < 0 ? -1 : 1;
  const a = -1 / (sign + z);
  const b = x * y * a;
  return [
    [1 + sign * x * x * a, sign * b, -sign * x],
    [b, sign + y * y * a, -y],
  ];
}

/** The vector with components (x, y, z) in the orthonormal basis whose third axis is n. */
export function fromLocalBasis(n: Vec3, x: number, y: number, z: number): Vec3 {
  const [s, t] = orthonormalBasis(n);
  return add(addScaled(scale(s, x), t, y), scale(n, z));
}

/** A direction of the hemisphere about the unit n, with density cos/π. */
export function cosineDirection(n: Vec3, random: Random): Vec3 {
  const r2 = random();
  const phi = 2 * Math.PI * random();
  const r = Math.sqrt(r2);
  return normalize(fromLocalBasis(n, r * Math.cos(phi), r * Math.sin(phi), Math.sqrt(1 - r2)));
}

/** A uniform direction within the cone about the unit n; `open` = 1 − cos of the cone's half angle. */
export function coneDirection(n: Vec3, open: number, random: Random): Vec3 {
  const down = open * random();
  const phi = 2 * Math.PI * random();
  const r = Math.sqrt(down * (2 - down));
  return normalize(fromLocalBasis(n, r * Math.cos(phi), r * Math.sin(phi), 1 - down));
}
