import { addScaled, dot, scale, type Vec3 } from '../../math/vec3.ts';

/**
 * The direction behind a surface with the normal N (on the side that d comes from): t = ηd + (η cos − √(1 − η²(1 − cos²))) N,
 * cos = −d·N, η = n₁/n₂ of the sides. Returns undefined at total internal reflection. Source: Snell's law as a vector.
 */
export function refracted(d: Vec3, N: Vec3, eta: number): Vec3 | undefined {
  const cos = -dot(d, N);
  const rest = 1 - eta * eta * (1 - cos * cos);
  if (rest < 0) return undefined;
  return addScaled(scale(d, eta), N, eta * cos - Math.sqrt(rest));
}

/** Fresnel reflectance of unpolarised light at the incidence cosine `cos`, into a medium of the relative refractive index n. Source: Born & Wolf §1.5. */
export function dielectricFresnel(cos: number, n: number): number {
  const c = Math.min(Math.max(cos, 0), 1);
  const rest = n * n - 1 + c * c;
  if (rest <= 0) return 1;
  const g = Math.sqrt(rest);
  const s = (c - g) / (c + g);
  const p = (n * n * c - g) / (n * n * c + g);
  return (s * s + p * p) / 2;
}
