/** What of the light between things a picture takes into account. Plain data, so that a worker can be told. */
export interface LightOptions {
  /** 0: suns and lamps light surfaces; 1: so do the sky and what glows; 2: so do surfaces lit by these; and so on. */
  readonly bounces: number;
  /** Surfaces mirror what is around them, smooth ones sharply; else they mirror only the sky and what glows, once. */
  readonly mirrors: boolean;
  /** Closed transparent bodies refract; else what is behind them is blended in. */
  readonly glass: boolean;
}

export const DEFAULT_LIGHT: LightOptions = { bounces: 2, mirrors: true, glass: false };

/** Light may be scattered so often on its way at most. */
export const MAX_BOUNCES = 64;
/** Seeds are below. */
export const SEED_COUNT = 2 ** 32;
/** A pixel has n × n samples, n at most. */
export const MAX_SAMPLES = 16;
