/** How much of the picture is darkened where it flows fast. */
export const VIGNETTES = ['off', 'mild', 'strong'] as const;
export type VignetteStrength = (typeof VIGNETTES)[number];

/** How far a closed vignette reaches in from the corners, in parts of their distance from the middle, and how dark it is, 0 … 1. */
export const VIGNETTE_LOOKS: Readonly<Record<VignetteStrength, { readonly reach: number; readonly dark: number }>> = {
  off: { reach: 0, dark: 0 },
  mild: { reach: 0.45, dark: 0.75 },
  strong: { reach: 0.75, dark: 1 },
};

/** Flows of the picture [rad/s] at which a vignette begins to close, and is closed. */
const [CALM, FAST] = [0.25, 1.25];
/** Times in which it closes and opens to 1/e [s]: at once, and slowly, so that it does not flicker. */
const [CLOSING_TIME, OPENING_TIME] = [0.12, 0.6];

/** How far a vignette is to be closed, 0 … 1, where the picture flows by `flow` [rad/s]: smooth, and rising with it. */
export function closingFor(flow: number): number {
  const part = Math.max(0, Math.min(1, (flow - CALM) / (FAST - CALM)));
  return part * part * (3 - 2 * part);
}

/** How far a vignette is closed `dt` [s] after it was `closing`, where the picture flows by `flow` [rad/s]. Steps may be of any length. */
export function nextClosing(closing: number, flow: number, dt: number): number {
  const wanted = closingFor(flow);
  return wanted + (closing - wanted) * Math.exp(-dt / (wanted > closing ? CLOSING_TIME : OPENING_TIME));
}
