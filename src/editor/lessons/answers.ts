import { loadObject, saveObject } from '../state/storedObject.ts';

/** What has been answered in a lesson. */
export interface Answered {
  /** The chosen answer by step. */
  readonly chosen: Readonly<Record<number, number>>;
  /** Steps whose answer has been looked at. */
  readonly seen: readonly number[];
}
export const NOTHING: Answered = { chosen: {}, seen: [] };

const KEY = 'slowlight.lessons';

/** What was answered in a lesson before, in this browser. `answers`: how many each step has. */
export function loadAnswers(lesson: string, answers: readonly number[]): Answered {
  const kept = loadObject(KEY)[lesson];
  if (typeof kept !== 'object' || kept === null) return NOTHING;
  const { chosen, seen } = kept as Partial<Record<keyof Answered, unknown>>;
  const known = Object.entries(typeof chosen === 'object' && chosen !== null ? chosen : {}).filter(
    ([step, answer]) => Number.isInteger(answer) && answer >= 0 && answer < (answers[Number(step) - 1] ?? 0),
  );
  const steps = known.map(([step]) => Number(step));
  return {
    chosen: Object.fromEntries(known),
    seen: Array.isArray(seen) ? steps.filter((step) => seen.includes(step)) : [],
  };
}

export const saveAnswers = (lesson: string, answered: Answered): void =>
  saveObject(KEY, { ...loadObject(KEY), [lesson]: answered });
