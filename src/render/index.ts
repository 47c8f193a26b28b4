export type { PictureMaker } from './api.ts';
export { SceneRenderer } from './renderer.ts';
export {
  AOVS,
  type AovInfo,
  type AovName,
  type Backend,
  DEFAULT_SETTINGS,
  type PickResult,
  type RendererInfo,
  type RendererOptions,
  type RenderSettings,
  type Solver,
  type View,
  type ViewPoint,
} from './settings.ts';
