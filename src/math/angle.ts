/** Degrees → radians. Files and the interface use degrees, formulas radians. */
export const radians = (degrees: number): number => (degrees * Math.PI) / 180;

/** Radians → degrees. */
export const degrees = (radians: number): number => (radians * 180) / Math.PI;
