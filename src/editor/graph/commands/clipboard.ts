import type { GraphLevel } from '../../../graph/analysis/sockets.ts';
import { DocumentError } from '../../../graph/document/document.ts';
import { copyFragment, parseFragment, pasteFragment, serializeFragment } from '../../../graph/edits/fragment.ts';
import type { Editor } from '../../state/editor.ts';
import { canvas, levelAt, prunedSelection, selectItems } from '../canvas/canvasState.ts';
import { findFreeCenter, revealNodes } from '../layout/freePosition.ts';
import { removeCommand } from './edits.ts';

/** Copied nodes are text on the system's clipboard, so that they go from tab to tab, and into a mail. */
const shownLevel = (studio: Editor): GraphLevel =>
  levelAt(studio.store.getState().history.document, canvas.getState().path);

/** What is chosen, as text; undefined where nothing is. */
export function copySelection(studio: Editor): string | undefined {
  const level = shownLevel(studio);
  const { nodes, notes } = prunedSelection(level, canvas.getState().selection);
  if (nodes.length + notes.length === 0) return undefined;
  return serializeFragment(copyFragment(level.document, { nodes, notes, group: level.group }));
}

export function cutSelection(studio: Editor): string | undefined {
  const words = copySelection(studio);
  const level = shownLevel(studio);
  if (words !== undefined)
    studio.edit(removeCommand(level, prunedSelection(level, canvas.getState().selection)), 'edit.cut');
  return words;
}

/** Nodes out of a text, in the middle of what is seen. What is no nodes is refused, with the place of the fault. */
export function pasteText(studio: Editor, words: string): void {
  const level = shownLevel(studio);
  try {
    const fragment = parseFragment(words);
    const at = findFreeCenter(level, fragment, canvas.getState().viewport?.center());
    const { command, nodes, notes } = pasteFragment(level.document, fragment, level.group, at);
    studio.edit(command, 'edit.paste');
    selectItems({ nodes, notes });
    revealNodes(nodes);
  } catch (error) {
    if (!(error instanceof DocumentError)) throw error;
    studio.notify({ kind: 'error', text: error.message, place: words.trim().slice(0, 60) });
  }
}
