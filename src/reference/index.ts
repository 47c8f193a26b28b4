/**
 * The reference renderer: rays into the past through a scene, in 64-bit arithmetic, on the processor.
 *
 * @module slowlight/reference
 */

export type * from './acceleration/ray.ts';
export { lightOf } from './acceleration/ray.ts';
export { dopplerOfHit } from './aov.ts';
export { cameraRay } from './camera/cameraRay.ts';
export { rayToward } from './camera/lensRay.ts';
export { type TransparentMode, visibleHit } from './camera/visibleHit.ts';
export { createTracedScene, nearestHit, type TracedScene } from './intersection/tracedScene.ts';
export { DEFAULT_LIGHT, type LightOptions } from './lights/lightOptions.ts';
export { materialOf } from './materials/material.ts';
export type { AdaptiveSampling } from './sampling/adaptiveSampling.ts';
export { renderTile } from './tile.ts';
export type { ImageTile, OutputLayer, TileData, TileRequest } from './tileRequest.ts';
