import { own, type ParamValue } from '../../graph/document/document.ts';
import { resolveParams } from '../../graph/nodeType.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { nearestToOutput } from '../../nodes/project/outputChain.ts';
import { VIEW_NAMES } from '../../scene/views/views.ts';
import { FALSE_COLOR_QUANTITIES } from '../../spectrum/falseColor/falseColor.ts';
import type { Editor, EditorState } from '../state/editor.ts';

/** Actions shared by keys and buttons; without the node they do nothing. */
export const nextView = (editor: Editor): void =>
  change(editor, 'relativity-console', 'view', (now) => next(VIEW_NAMES, now));

export const toggleGrid = (editor: Editor): void =>
  change(editor, 'relativity-rasterize', 'grid', (now) => now !== true);

export const nextFalseColor = (editor: Editor): void =>
  change(editor, 'false-colour', 'of', (now) => next(['none', ...FALSE_COLOR_QUANTITIES], now));

/** Takes a tool over the picture, or puts it away. */
export const toggleTool = (editor: Editor, tool: NonNullable<EditorState['tool']>): void =>
  editor.update({ tool: editor.store.getState().tool === tool ? undefined : tool });

/** Detaches the observer from the camera it rides on. */
export const leaveCamera = (editor: Editor): void => change(editor, 'scene-camera', 'ride', () => false);

const next = (values: readonly string[], now: ParamValue | undefined): string =>
  values[(values.indexOf(String(now)) + 1) % values.length]!;

/** Changes a parameter of the node of a type that is nearest to the output. */
function change(editor: Editor, typeId: string, param: string, to: (now: ParamValue | undefined) => ParamValue): void {
  const node = nearestToOutput(editor.store.getState().history.document, typeId);
  const type = own(nodeLibrary, typeId);
  const spec = type?.params[param];
  if (node && spec) editor.set(node.id, param, to(resolveParams(type, node.params)[param]), spec.title);
}
