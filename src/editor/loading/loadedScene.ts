import { toLoadedScene } from '../../nodes/common/loadedScene.ts';
import type { LoadedScene } from '../../nodes/services.ts';
import type { Scene } from '../../scene/types.ts';
import { renderableScene } from '../../scene/validation/renderableScene.ts';

/** A scene with its problems and its fastest point. */
export function loadedScene(read: Scene): LoadedScene {
  const { scene, diagnostics } = renderableScene(read);
  return toLoadedScene({ ...scene, diagnostics: [...scene.diagnostics, ...diagnostics] });
}
