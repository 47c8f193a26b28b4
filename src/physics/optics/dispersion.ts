/** Wavelengths of the Fraunhofer lines F, d and C [m]. */
const [F, d, C] = [486.1e-9, 587.6e-9, 656.3e-9];

/**
 * The refractive index at a wavelength [m], by Cauchy's equation n = A + B/λ² with n(d) = `ior` and the Abbe number V = 20/`dispersion` = (n_d − 1)/(n_F − n_C).
 * At least 1. docs/physics.md §6.7. Source: KHR_materials_dispersion.
 */
export function dispersedIndex(ior: number, dispersion: number, wavelength: number): number {
  const B = ((ior - 1) * dispersion) / (20 * (F ** -2 - C ** -2));
  return Math.max(1, ior + B * (wavelength ** -2 - d ** -2));
}
