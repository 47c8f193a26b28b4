import { applyPatches, type Patch } from 'immer';
import { applyCommand, type Command } from './commands.ts';
import type { GraphDocument } from './document.ts';

interface Step {
  /** What the step did, as a key of the catalogue of messages or plain words, for the undo button. */
  readonly label: string;
  /** Steps in a row with the same gesture become one. */
  readonly gesture?: string;
  readonly patches: readonly Patch[];
  readonly inverse: readonly Patch[];
}

/** A document with the steps that made it. Immutable: every operation gives a new one. */
export interface History {
  readonly document: GraphDocument;
  readonly past: readonly Step[];
  readonly future: readonly Step[];
}

export const newHistory = (document: GraphDocument): History => ({ document, past: [], future: [] });

/**
 * Does a command. `gesture` names one continuous action (the drag of one slider): while it lasts its edits coalesce into one
 * step. An edit that changes nothing leaves the history as it is.
 */
export function execute(history: History, command: Command, label: string, gesture?: string): History {
  const { document, patches, inverse } = applyCommand(history.document, command);
  if (document === history.document) return history;
  const last = history.past.at(-1);
  if (gesture && last?.gesture === gesture && history.future.length === 0) {
    const joined = { ...last, patches: [...last.patches, ...patches], inverse: [...inverse, ...last.inverse] };
    return { document, past: [...history.past.slice(0, -1), joined], future: [] };
  }
  return { document, past: [...history.past, { label, gesture, patches, inverse }], future: [] };
}

/** Ends the running gesture: the next edit is a step of its own. */
export function endGesture(history: History): History {
  const last = history.past.at(-1);
  if (!last?.gesture) return history;
  return { ...history, past: [...history.past.slice(0, -1), { ...last, gesture: undefined }] };
}

export function undo(history: History): History {
  const step = history.past.at(-1);
  if (!step) return history;
  return {
    document: applyPatches(history.document, step.inverse),
    past: history.past.slice(0, -1),
    future: [{ ...step, gesture: undefined }, ...history.future],
  };
}

export function redo(history: History): History {
  const [step, ...rest] = history.future;
  if (!step) return history;
  return { document: applyPatches(history.document, step.patches), past: [...history.past, step], future: rest };
}
