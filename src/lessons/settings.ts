import type { Vec3 } from '../math/vec3.ts';
import { parseFlightPlan } from './flightPlan.ts';
import { parseInstrument } from './instruments.ts';
import type { Lesson, LessonClaim, LessonSetting, LessonValue } from './lesson.ts';
import { LessonError } from './lessonError.ts';

export const isVector = (value: LessonValue): value is Vec3 => Array.isArray(value);

const isDuration = (value: LessonValue): boolean => typeof value === 'number' && value >= 0;

/** What steps set besides parameters of nodes, and whether a value is fit for it. */
const PAGE_SETTINGS: Readonly<
  Record<string, { readonly is: (value: LessonValue) => boolean; readonly wants: string }>
> = {
  example: {
    is: (value) => typeof value === 'string' && /^[a-z0-9-]+\.(?:usdc|slowlight\.json)$/.test(value),
    wants: 'a file of examples/, as street.usdc',
  },
  time: { is: (value) => typeof value === 'number', wants: 'a world time [s]' },
  playing: { is: (value) => typeof value === 'boolean', wants: 'yes or no' },
  lock: { is: (value) => value === 'free' || value === 'look', wants: 'free or look' },
  'observer.beta': {
    is: (value) => isVector(value) && Math.hypot(...value) < 1,
    wants: 'a velocity in units of c, as 0, 0, -0.9, below 1',
  },
  'observer.position': { is: isVector, wants: 'a place x, y, z [m]' },
  'observer.look': {
    is: (value) => isVector(value) && Math.hypot(...value) > 0,
    wants: 'a direction x, y, z',
  },
  flight: {
    is: (value) => typeof value === 'string' && parseFlightPlan(value) !== undefined,
    wants: 'none, or as coast 0.6, 0, 0 for 8; trip 90, 0, 0 at 5',
  },
  'flight.from': { is: isDuration, wants: 'own seconds of the flight' },
  'flight.to': { is: isDuration, wants: 'own seconds of the flight' },
  panel: {
    is: (value) => typeof value === 'string' && parseInstrument(value) !== undefined,
    wants: 'a panel, as clocks, or with what it shows, as diagram energy',
  },
};

const PARAM = /^[A-Za-z]\w*\.[A-Za-z]\w*$/;
const NUMBER = /^-?\d+(?:\.\d+)?(?:e-?\d+)?$/;

/** `KEY = VALUE`. Throws a LessonError. */
export function parseSetting(text: string, file: string, line: number): LessonSetting {
  const [, key, written] = /^([\w.]+) = (\S.*)$/.exec(text) ?? [];
  if (key === undefined || written === undefined)
    throw new LessonError(file, line, `"${text}" is no setting; write KEY = VALUE`);
  const value = parseValue(written);
  const known = Object.hasOwn(PAGE_SETTINGS, key) ? PAGE_SETTINGS[key] : undefined;
  if (known && !known.is(value)) throw new LessonError(file, line, `${key} is ${known.wants}, not ${written}`);
  if (!known && (!PARAM.test(key) || key.startsWith('observer.')))
    throw new LessonError(
      file,
      line,
      `there is no setting ${key}; there are ${Object.keys(PAGE_SETTINGS).join(', ')}, and NODE.PARAMETER`,
    );
  return { key, value, line };
}

function parseValue(written: string): LessonValue {
  if (written === 'yes' || written === 'no') return written === 'yes';
  if (NUMBER.test(written)) return Number(written);
  const parts = written.split(',').map((part) => part.trim());
  if (parts.length === 3 && parts.every((part) => NUMBER.test(part))) return parts.map(Number) as unknown as Vec3;
  return written;
}

/** `QUANTITY(A, B) = NUMBER`. Throws a LessonError. */
export function parseClaim(text: string, file: string, line: number): LessonClaim {
  const [, quantity, list, printed] = /^([a-z]\w*)\(([^()]*)\) = (\S+)$/i.exec(text) ?? [];
  if (quantity === undefined || list === undefined || printed === undefined || !NUMBER.test(printed))
    throw new LessonError(file, line, `"${text}" is no claim; write QUANTITY(A, B) = NUMBER`);
  const of = list === '' ? [] : list.split(',').map((part) => part.trim());
  const wrong = of.find((part) => !NUMBER.test(part));
  if (wrong !== undefined) throw new LessonError(file, line, `"${wrong}" is no number`);
  return { quantity, of: of.map(Number), printed, line };
}

/** A scene with all that differs from how it opens. */
export interface LessonState {
  /** File of examples/. */
  readonly example: string;
  /** By key, without `example`. */
  readonly settings: ReadonlyMap<string, LessonValue>;
}

/**
 * The state at a step: all that the steps before it and it itself set, later settings over earlier ones; another example
 * begins anew. `seen`: whether the step's answer is looked at. Steps can thus be entered in any order.
 */
export function stateAtStep({ steps }: Lesson, step: number, seen: boolean): LessonState {
  const before = steps.slice(0, step).flatMap(({ set, question }) => [...set, ...(question?.see ?? [])]);
  const now = steps[step]!;
  let example = '';
  let settings = new Map<string, LessonValue>();
  for (const { key, value } of [...before, ...now.set, ...(seen ? (now.question?.see ?? []) : [])]) {
    if (key !== 'example') settings.set(key, value);
    else {
      example = String(value);
      settings = new Map();
    }
  }
  return { example, settings };
}

/** Whether a setting is a parameter of a node. */
export const isParameter = (key: string): boolean => !Object.hasOwn(PAGE_SETTINGS, key);
