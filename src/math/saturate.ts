/** The nearest number in 0 … 1, as shaders name it. */
export const saturate = (x: number): number => Math.min(Math.max(x, 0), 1);
