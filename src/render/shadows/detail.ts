/** How much work shadows are. */
export interface ShadowDetail {
  /** Side of a tile of what rests, for one sun or for two [texels]. */
  readonly resting: readonly [number, number];
  /** Side of a moving body's tile [texels]. */
  readonly moving: number;
  /** So many moving bodies throw shadows: those that look largest from where the observer is, in any direction. */
  readonly movers: number;
  /** Side of a tile of a lamp: of up to four that rest; of more, and of those where something moves [texels]. */
  readonly lampTiles: readonly [number, number];
  /** So many tiles are shared out among lamps for bodies that they go past. */
  readonly lampBodies: number;
  /** Side of a cell of edges.ts of suns: the filter is so wide at most, to either side [texels]. */
  readonly cell: number;
  /** Lookups of the filter. */
  readonly taps: number;
}

/** Coarse: for a software GPU that is to show a picture as it changes. */
export const DETAILS = {
  fine: { resting: [2048, 1024], moving: 512, movers: 16, lampTiles: [512, 256], lampBodies: 32, cell: 8, taps: 32 },
  coarse: { resting: [1024, 512], moving: 128, movers: 8, lampTiles: [256, 128], lampBodies: 16, cell: 4, taps: 16 },
} as const satisfies Record<string, ShadowDetail>;

export type DetailName = keyof typeof DETAILS;
