/** How much work shadows are. */
export interface ShadowDetail {
  /** Side of a tile of what rests, for one sun or for two [texels]. */
  readonly staticTiles: readonly [number, number];
  /** Side of a moving body's tile [texels]. */
  readonly dynamicTile: number;
  /** So many moving bodies throw shadows: those that look largest from where the observer is, in any direction. */
  readonly maxCasters: number;
  /** Side of a tile of a light: of up to four that rest; of more, and of those where something moves [texels]. */
  readonly localTiles: readonly [number, number];
  /** So many tiles are shared out among lights for bodies that they go past. */
  readonly maxLocalCasters: number;
  /** Side of a cell of edgeMap.ts of suns: the filter is so wide at most, to either side [texels]. */
  readonly cell: number;
  /** Lookups of the filter. */
  readonly taps: number;
}

/** Coarse: for a software GPU that is to show a picture as it changes. */
export const SHADOW_DETAILS = {
  fine: {
    staticTiles: [2048, 1024],
    dynamicTile: 512,
    maxCasters: 16,
    localTiles: [512, 256],
    maxLocalCasters: 32,
    cell: 8,
    taps: 32,
  },
  coarse: {
    staticTiles: [1024, 512],
    dynamicTile: 128,
    maxCasters: 8,
    localTiles: [256, 128],
    maxLocalCasters: 16,
    cell: 4,
    taps: 16,
  },
} as const satisfies Record<string, ShadowDetail>;

export type ShadowDetailName = keyof typeof SHADOW_DETAILS;
