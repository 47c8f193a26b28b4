import { own } from '../../../graph/document/document.ts';
import { degrees } from '../../../math/angle.ts';
import { nodeLibrary } from '../../../nodes/library.ts';
import { pictureLens } from '../../../nodes/pictures/renderSettings.ts';
import { nearestToOutput } from '../../../nodes/project/outputChain.ts';
import type { Editor } from '../../state/editor.ts';

/** The field of view [rad] in which what is in the middle is so many times as large. */
export const zoomedFieldOfView = (fovY: number, factor: number): number => 2 * Math.atan(Math.tan(fovY / 2) / factor);

let pinches = 0;

/**
 * Begins a pinch: what is returned makes what is in the middle of the picture so many times as large as it is now, by the
 * camera's field of view, in one step of the history. Undefined for panoramic lenses, which stay as they are.
 */
export function beginPinch(editor: Editor): ((factor: number) => void) | undefined {
  const { picture, history } = editor.store.getState();
  const node = nearestToOutput(history.document, 'scene-camera');
  const spec = own(nodeLibrary, 'scene-camera')?.params.fieldOfView;
  const lens = picture && pictureLens(picture);
  if (!node || spec?.kind !== 'number' || lens?.kind !== 'perspective') return undefined;
  const gesture = `pinch ${pinches++}`;
  return (factor) => {
    const wanted = degrees(zoomedFieldOfView(lens.fovY, factor));
    const value = Math.round(10 * Math.min(spec.max, Math.max(spec.min, wanted))) / 10;
    editor.set(node.id, 'fieldOfView', value, spec.title, gesture);
  };
}
