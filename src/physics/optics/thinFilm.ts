/**
 * Reflectance of a film of refractive index n and thickness d between vacuum and a medium of index `below`, for unpolarised light of wavelength λ that falls
 * in at the cosine c: |r₁₂ + r₂₃ e^{iφ}|²/|1 + r₁₂ r₂₃ e^{iφ}|², φ = 4π n d cos θ₂/λ, with Fresnel's amplitudes of both polarisations (Airy 1833).
 * `thickness` and `wavelength` in the same unit. docs/physics.md §6.7. Source: Born & Wolf §1.6.4.
 */
export function thinFilmReflectance(
  c: number,
  n: number,
  below: number,
  thickness: number,
  wavelength: number,
): number {
  const sin2 = 1 - Math.min(Math.max(c, 0), 1) ** 2;
  const [rest2, rest3] = [1 - sin2 / n ** 2, 1 - sin2 / below ** 2];
  if (rest2 <= 0) return 1;
  const [c1, c2, c3] = [Math.sqrt(1 - sin2), Math.sqrt(rest2), Math.sqrt(Math.max(rest3, 0))];
  const cosPhi = Math.cos((4 * Math.PI * n * thickness * c2) / wavelength);
  const s = interfering((c1 - n * c2) / (c1 + n * c2), (n * c2 - below * c3) / (n * c2 + below * c3), cosPhi);
  const p = interfering((n * c1 - c2) / (n * c1 + c2), (below * c2 - n * c3) / (below * c2 + n * c3), cosPhi);
  return (s + p) / 2;
}

/** |a + b e^{iφ}|²/|1 + a b e^{iφ}|² */
function interfering(a: number, b: number, cosPhi: number): number {
  const cross = 2 * a * b * cosPhi;
  return (a * a + b * b + cross) / (1 + a * a * b * b + cross);
}
