import { surveyed } from '../../nodes/geometry/surveyed.ts';
import type { LoadedScene } from '../../nodes/services.ts';
import { drawableScene } from '../../scene/drawable.ts';
import type { Scene } from '../../scene/types.ts';

/** What is told when a scene is opened: its faults, and its fastest point. */
export function loadedScene(read: Scene): LoadedScene {
  const { scene, remarks } = drawableScene(read);
  return surveyed({ ...scene, diagnostics: [...scene.diagnostics, ...remarks] });
}
