export { dopplerOf } from './aov.ts';
export { cameraRay, rayToward } from './camera.ts';
export { materialOf } from './material.ts';
export { renderTile, type Tile, type TileData, type TileRequest } from './tile.ts';
export { nearestHit, type TracedScene, traceable } from './trace.ts';
export type * from './types.ts';
export { type Transparent, visibleHit } from './visible.ts';
