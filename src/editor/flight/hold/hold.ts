import { type HeldCamera, walkAbout } from '../../../flight/hold.ts';
import { ZERO } from '../../../math/vec3.ts';
import type { Editor } from '../../state/editor.ts';
import { sceneUpVector } from '../../state/observer.ts';
import type { ObserverController } from '../observerController.ts';

/** Holds what the observer sees now, with the camera at his eye; or goes back to his eye, and on. */
export function toggleHold(editor: Editor, observerController: ObserverController): void {
  if (observerController.held) {
    observerController.held.end();
    return;
  }
  observerController.inputs.screen?.letGo();
  const { playing } = editor.store.getState();
  let camera: HeldCamera = { vantage: ZERO, orientation: observerController.observer.orientation };
  observerController.held = {
    get camera() {
      return camera;
    },
    walk(controls, dt, { speedOfLight: c, maxSpeed, scene }) {
      camera = walkAbout(camera, controls, dt, { c, maxSpeed, up: sceneUpVector(scene) });
    },
    end() {
      observerController.held = undefined;
      editor.update({ held: false, ...(playing && { playing }) });
    },
  };
  editor.update({ held: true, playing: false });
}
