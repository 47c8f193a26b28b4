export type { RasterRenderer } from './api.ts';
export { SceneRenderer } from './renderer.ts';
export type { Backend, PickResult, RendererInfo, RendererOptions } from './settings.ts';
