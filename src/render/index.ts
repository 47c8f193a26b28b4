/**
 * The renderer on a GPU, by WebGPU or WebGL2, in a page or in Node.
 *
 * @module slowlight/render
 */

export type { RasterRenderer } from './api.ts';
export { type DomeMaps, type DomeMeans, domeMaps } from './lights/sky/domeMaps.ts';
export type { DomeLevel } from './lights/sky/domeMipmaps.ts';
export { SceneRenderer } from './renderer.ts';
export type {
  Backend,
  BesideOptions,
  PickedSurface,
  PickResult,
  RendererInfo,
  RendererOptions,
  Sampling,
  Shading,
  ShadingChoice,
} from './settings.ts';
