// Transformation of light under a Doppler factor D = ν_observed / ν_emitted, from the invariance of L_ν/ν³ (the number of photons per
// quantum state). docs/physics.md §6.1; Rybicki & Lightman, Radiative Processes in Astrophysics, §4.9.

/** Observed frequency ν′ = D ν [Hz]. */
export const observedFrequency = (nu: number, D: number): number => D * nu;
/** Observed wavelength λ′ = λ/D [m]. */
export const observedWavelength = (lambda: number, D: number): number => lambda / D;

/** L_ν′(ν) = D³ L_ν(ν/D) [W/(m² sr Hz)], of an emitted spectrum L_ν. */
export const radiancePerFrequency = (emitted: (nu: number) => number, nu: number, D: number): number =>
  D ** 3 * emitted(nu / D);

/** L_λ′(λ) = D⁵ L_λ(D λ) [W/(m² sr m)], of an emitted spectrum L_λ. */
export const radiancePerWavelength = (emitted: (lambda: number) => number, lambda: number, D: number): number =>
  D ** 5 * emitted(D * lambda);

/** Radiance integrated over all wavelengths: L′ = D⁴ L [W/(m² sr)]. */
export const bolometricRadiance = (L: number, D: number): number => D ** 4 * L;

/** Solid angle of a small piece of the sky: dΩ′ = dΩ/D² [sr]. */
export const observedSolidAngle = (omega: number, D: number): number => omega / (D * D);

/** The temperature D T of the blackbody that a blackbody at T looks like [K]. */
export const blackbodyTemperature = (T: number, D: number): number => D * T;
