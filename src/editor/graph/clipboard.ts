import { DocumentError } from '../../graph/document.ts';
import { copyOf, parseFragment, pasteOf, serializeFragment } from '../../graph/edits/fragment.ts';
import type { Level } from '../../graph/sockets.ts';
import type { Studio } from '../state/studio.ts';
import { canvas, choose, chosenIn, levelAt } from './canvas.ts';
import { removing } from './edits.ts';
import { bringIntoSight, freeMiddle } from './room.ts';

/** Copied nodes are text on the system's clipboard, so that they go from tab to tab, and into a mail. */
const levelOf = (studio: Studio): Level => levelAt(studio.store.getState().history.document, canvas.getState().path);

/** What is chosen, as text; undefined where nothing is. */
export function copied(studio: Studio): string | undefined {
  const level = levelOf(studio);
  const { nodes, notes } = chosenIn(level, canvas.getState().chosen);
  if (nodes.length + notes.length === 0) return undefined;
  return serializeFragment(copyOf(level.document, { nodes, notes, group: level.group }));
}

export function cut(studio: Studio): string | undefined {
  const words = copied(studio);
  const level = levelOf(studio);
  if (words !== undefined) studio.edit(removing(level, chosenIn(level, canvas.getState().chosen)), 'edit.cut');
  return words;
}

/** Nodes out of a text, in the middle of what is seen. What is no nodes is refused, with the place of the fault. */
export function paste(studio: Studio, words: string): void {
  const level = levelOf(studio);
  try {
    const fragment = parseFragment(words);
    const at = freeMiddle(level, fragment, canvas.getState().sight?.middle());
    const { command, nodes, notes } = pasteOf(level.document, fragment, level.group, at);
    studio.edit(command, 'edit.paste');
    choose({ nodes, notes });
    bringIntoSight(nodes);
  } catch (error) {
    if (!(error instanceof DocumentError)) throw error;
    studio.notify({ kind: 'error', text: error.message, place: words.trim().slice(0, 60) });
  }
}
