/** Sizes and counts that set the quality and cost of shadows. */
export interface ShadowDetail {
  /** Side of a tile of the static cascades, with one distant light or with two [texels]. */
  readonly staticTiles: readonly [number, number];
  /** Side of a moving body's tile [texels]. */
  readonly dynamicTile: number;
  /** Number of moving bodies that throw shadows: those with the largest apparent size, in any direction. */
  readonly maxCasters: number;
  /** Side of a tile of a local light: of up to four lights at rest; otherwise, and where something moves [texels]. */
  readonly localTiles: readonly [number, number];
  /** Number of tiles for bodies that move relative to a light, divided among the local lights. */
  readonly maxLocalCasters: number;
  /** Side of a cell of the edge map of distant lights, and so the largest radius of the filter [texels]. */
  readonly cell: number;
  /** Number of lookups of the filter. */
  readonly taps: number;
}

/** `coarse` is for a software GPU that shows changing pictures. */
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
