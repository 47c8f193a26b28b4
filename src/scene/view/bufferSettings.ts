/** `light-cone`: what is seen. `simultaneity`: where things are at the observer's own instant. `galilean`: c = ∞. */
export type View = 'light-cone' | 'simultaneity' | 'galilean';

export type Solver = 'exact' | 'newton';

/** `spectral`: light is spectra, and a shift is seen at their wavelengths. `approximate`: light is linear sRGB, and a shift is a tint (dopplerTint.ts). */
export type ColorMode = 'spectral' | 'approximate';

/** The settings that a G-buffer is rendered with. */
export interface BufferSettings {
  readonly view: View;
  /** Off: every point is taken at the observer's own world time, as if light were instantaneous. Light-cone view only. */
  readonly lightDelay: boolean;
  /** Off: directions are those of the world frame, not the observer's. Light-cone view only. */
  readonly aberration: boolean;
  readonly colors: ColorMode;
  /** 0 … 1: how much of log D reaches the colours. */
  readonly dopplerMix: number;
  /** 0 … 1: how much of log D⁴ reaches the brightness. */
  readonly beaming: number;
  readonly solver: Solver;
  /** Newton steps per vertex. */
  readonly iterations: number;
  /** Newton step length, 0 < k ≤ 1. */
  readonly damping: number;
  /** [m/s] */
  readonly speedOfLight: number;
}

export const BUFFER_SETTINGS = [
  'view',
  'lightDelay',
  'aberration',
  'colors',
  'dopplerMix',
  'beaming',
  'solver',
  'iterations',
  'damping',
  'speedOfLight',
] as const satisfies readonly (keyof BufferSettings)[];
