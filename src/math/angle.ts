/** Degrees as radians: people and files have the first, formulas the second. */
export const radians = (degrees: number): number => (degrees * Math.PI) / 180;

/** Radians as degrees. */
export const degrees = (radians: number): number => (radians * 180) / Math.PI;
