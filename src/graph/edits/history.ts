import { applyPatches, type Patch } from 'immer';
import type { LocalizedText } from '../../messages/message.ts';
import type { GraphDocument } from '../document/document.ts';
import { applyCommand, type Command } from './commands.ts';

interface HistoryStep {
  /** What the step did, for the undo button. */
  readonly label: LocalizedText;
  /** Consecutive steps of the same gesture are merged. */
  readonly gesture?: string;
  readonly patches: readonly Patch[];
  readonly inverse: readonly Patch[];
  /** For a replaced document: origins before and after. */
  readonly origins?: readonly [before: string, after: string];
}

/** A document with its undo and redo steps. Immutable. */
export interface History {
  readonly document: GraphDocument;
  /** File, address or link that the document was opened from; empty for a new one. */
  readonly origin: string;
  readonly past: readonly HistoryStep[];
  readonly future: readonly HistoryStep[];
}

export const newHistory = (document: GraphDocument, origin = ''): History => ({
  document,
  origin,
  past: [],
  future: [],
});

/**
 * Executes a command. `gesture` identifies a continuous interaction (dragging a slider), whose edits coalesce into one
 * step. An edit without effect leaves the history unchanged.
 */
export function executeCommand(history: History, command: Command, label: LocalizedText, gesture?: string): History {
  const { document, patches, inverse } = applyCommand(history.document, command);
  if (document === history.document) return history;
  const last = history.past.at(-1);
  if (gesture && last?.gesture === gesture && history.future.length === 0)
    return {
      ...history,
      document,
      past: [...history.past.slice(0, -1), coalesceStep(last, patches, inverse)],
      future: [],
    };
  return { ...history, document, past: [...history.past, { label, gesture, patches, inverse }], future: [] };
}

/** Replaces the document as an undoable step. */
export function replaceDocument(
  history: History,
  document: GraphDocument,
  origin: string,
  label: LocalizedText,
): History {
  const whole = (value: GraphDocument): readonly Patch[] => [{ op: 'replace', path: [], value }];
  const step: HistoryStep = {
    label,
    patches: whole(document),
    inverse: whole(history.document),
    origins: [history.origin, origin],
  };
  return { document, origin, past: [...history.past, step], future: [] };
}

/** Merges an edit into a step; later values of the same entries replace earlier ones, so that long drags stay small. */
function coalesceStep(step: HistoryStep, patches: readonly Patch[], inverse: readonly Patch[]): HistoryStep {
  const before = step.patches.length - patches.length;
  const replaces =
    before >= 0 &&
    patches.every((patch, i) => patch.op === 'replace' && setsPath(step.patches[before + i]!, patch.path.join('.')));
  if (!replaces) return { ...step, patches: [...step.patches, ...patches], inverse: [...inverse, ...step.inverse] };
  const latest = patches.map(({ value }, i) => ({ ...step.patches[before + i]!, value }));
  return { ...step, patches: [...step.patches.slice(0, before), ...latest] };
}

const setsPath = ({ op, path }: Patch, place: string): boolean => op !== 'remove' && path.join('.') === place;

/** Ends the running gesture: the next edit is a new step. */
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
    origin: step.origins?.[0] ?? history.origin,
    past: history.past.slice(0, -1),
    future: [{ ...step, gesture: undefined }, ...history.future],
  };
}

export function redo(history: History): History {
  const [step, ...rest] = history.future;
  if (!step) return history;
  const document = applyPatches(history.document, step.patches);
  return { document, origin: step.origins?.[1] ?? history.origin, past: [...history.past, step], future: rest };
}
