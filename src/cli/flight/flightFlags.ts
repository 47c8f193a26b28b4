import type { Vec3 } from '../../math/vec3.ts';

/** Flags of `slowlight flight trip`. */
export interface TripFlags {
  readonly output: string;
  readonly from: Vec3;
  readonly to: Vec3;
  readonly acceleration: number;
  readonly c: number;
  readonly start: number;
  readonly maxSpeed?: number;
  readonly return?: boolean;
  readonly json?: boolean;
}

/** Flags of `slowlight flight cut`. */
export interface CutFlags {
  readonly output: string;
  readonly from?: number;
  readonly to?: number;
}
