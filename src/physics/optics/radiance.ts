// Transformation of light under a Doppler factor D = ν_observed / ν_emitted, from the invariance of L_ν/ν³ (the number of photons per
// quantum state). docs/physics.md §6.1; Rybicki & Lightman, Radiative Processes in Astrophysics, §4.9.

/**
 * Observed frequency ν′ = D ν [Hz].
 * @example
 * observedFrequency(5e14, 2); // 10e14 Hz
 */
export const observedFrequency = (nu: number, D: number): number => D * nu;
/**
 * Observed wavelength λ′ = λ/D [m].
 * @example
 * observedWavelength(589.3e-9, 0.9); // 654.8e-9 m: sodium's yellow, seen red
 */
export const observedWavelength = (lambda: number, D: number): number => lambda / D;

/**
 * L_ν′(ν) = D³ L_ν(ν/D) [W/(m² sr Hz)], of an emitted spectrum L_ν.
 * @example
 * // A flat spectrum is D³ times as bright.
 * radiancePerFrequency(() => 1, 5e14, 2); // 8
 */
export const radiancePerFrequency = (emitted: (nu: number) => number, nu: number, D: number): number =>
  D ** 3 * emitted(nu / D);

/**
 * L_λ′(λ) = D⁵ L_λ(D λ) [W/(m² sr m)], of an emitted spectrum L_λ.
 * @example
 * radiancePerWavelength(() => 1, 500e-9, 2); // 32
 */
export const radiancePerWavelength = (emitted: (lambda: number) => number, lambda: number, D: number): number =>
  D ** 5 * emitted(D * lambda);

/**
 * Radiance integrated over all wavelengths: L′ = D⁴ L [W/(m² sr)].
 * @example
 * bolometricRadiance(1, 2); // 16
 */
export const bolometricRadiance = (L: number, D: number): number => D ** 4 * L;

/**
 * Solid angle of a small piece of the sky: dΩ′ = dΩ/D² [sr].
 * @example
 * observedSolidAngle(1, 2); // 0.25 sr
 */
export const observedSolidAngle = (omega: number, D: number): number => omega / (D * D);

/**
 * The temperature D T of the blackbody that a blackbody at T looks like [K].
 * @example
 * blackbodyTemperature(2900, 2); // 5800 K: a lamp looks like the sun
 */
export const blackbodyTemperature = (T: number, D: number): number => D * T;
