import type { GraphLevel } from '../../../graph/analysis/sockets.ts';
import { DocumentError } from '../../../graph/document/document.ts';
import { copyFragment, parseFragment, pasteFragment, serializeFragment } from '../../../graph/edits/fragment.ts';
import { msg } from '../../../messages/message.ts';
import type { Editor } from '../../state/editor.ts';
import { canvas, levelAt, prunedSelection, selectItems } from '../canvas/canvasState.ts';
import { findFreeCenter, revealNodes } from '../layout/freePosition.ts';
import { removeCommand } from './edits.ts';

/** Copied nodes are text on the system clipboard, so they can be pasted into other tabs and programs. */
const shownLevel = (editor: Editor): GraphLevel =>
  levelAt(editor.store.getState().history.document, canvas.getState().path);

/** The selection as text; undefined if it is empty. */
export function copySelection(editor: Editor): string | undefined {
  const level = shownLevel(editor);
  const { nodes, notes } = prunedSelection(level, canvas.getState().selection);
  if (nodes.length + notes.length === 0) return undefined;
  return serializeFragment(copyFragment(level.document, { nodes, notes, group: level.group }));
}

export function cutSelection(editor: Editor): string | undefined {
  const words = copySelection(editor);
  const level = shownLevel(editor);
  if (words !== undefined)
    editor.edit(removeCommand(level, prunedSelection(level, canvas.getState().selection)), msg`cut`);
  return words;
}

/** Pastes nodes from text at the center of the viewport. Invalid text is refused with the place of the error. */
export function pasteText(editor: Editor, words: string): void {
  const level = shownLevel(editor);
  try {
    const fragment = parseFragment(words);
    const at = findFreeCenter(level, fragment, canvas.getState().viewport?.center());
    const { command, nodes, notes } = pasteFragment(level.document, fragment, level.group, at);
    editor.edit(command, msg`paste`);
    selectItems({ nodes, notes });
    revealNodes(nodes);
  } catch (error) {
    if (!(error instanceof DocumentError)) throw error;
    editor.notify({ kind: 'error', text: error.text, place: words.trim().slice(0, 60) });
  }
}
