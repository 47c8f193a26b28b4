/** Options of light transport. Plain data, so that workers can receive them. */
export interface LightOptions {
  /** 0: distant and local lights light surfaces; 1: also the sky and emissive surfaces; 2: also surfaces lit by these; and so on. */
  readonly bounces: number;
  /** Surfaces reflect their surroundings, smooth ones sharply; otherwise only the sky and emissive surfaces, once. */
  readonly mirrors: boolean;
  /** Closed transparent bodies refract; otherwise they are alpha-blended. */
  readonly glass: boolean;
}

/**
 * How light is followed if nothing else is said: two bounces, mirrors, no refraction.
 * @example
 * DEFAULT_LIGHT.bounces; // 2
 */
export const DEFAULT_LIGHT: LightOptions = { bounces: 2, mirrors: true, glass: false };

/** Upper bound of `bounces`. */
export const MAX_BOUNCES = 64;
/** Seeds are less than this. */
export const SEED_COUNT = 2 ** 32;
/** Upper bound of n, for n × n samples per pixel. */
export const MAX_SAMPLES = 16;
