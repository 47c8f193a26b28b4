import { type LocalizedText, type Message, msg } from '../../messages/message.ts';
import type { FastestVertex } from '../motion/kinds/motionKind.ts';
import type { Diagnostic } from '../types.ts';
import type { SceneCode } from './diagnosticCodes.ts';

export const problem = (
  severity: Diagnostic['severity'],
  code: SceneCode,
  place: LocalizedText,
  message: Message,
): Diagnostic => ({
  severity,
  code,
  place,
  message,
});

/** The place of problems of an object's motion. */
export const motionPlace = (path: string): Message => msg`motion of ${path}`;

/** Path of the object that a problem is about. */
export const objectPath = ({ place }: Diagnostic): string =>
  typeof place === 'string' ? place : String(place.values[0]);

/** An error if the fastest vertex of an object is not slower than light. */
export function validateFastest(path: string, { speed, from, to }: FastestVertex, c: number): Diagnostic[] {
  return speed >= c ? [tooFast(motionPlace(path), speed, from, to, c)] : [];
}

/** A model message: what, how much, when, and the least valid c. */
function tooFast(place: LocalizedText, speed: number, from: number, to: number, c: number): Diagnostic {
  const [fast, least] = [inUnitsOfC(speed / c), roundedUp(speed)];
  const message = Number.isFinite(from)
    ? msg`${fast} c between t = ${seconds(from)} and ${seconds(to)}; raise c above ${least} m/s or slow it down`
    : msg`${fast} c at all times; raise c above ${least} m/s or slow it down`;
  return problem('error', 'motion.superluminal', place, message);
}

/** Speeds up to this need not be known exactly, because they are slower than light. */
export const almostC = (c: number): number => c * (1 - 1e-9);

/** A ratio ≥ 1 with at least three digits, and enough of them to show that it exceeds 1. */
export function inUnitsOfC(ratio: number): string {
  for (let digits = 3; digits < 9; digits++)
    if (Number(ratio.toPrecision(digits)) > 1) return ratio.toPrecision(digits);
  return '1';
}

/** Rounded up to three digits. */
export function roundedUp(x: number): string {
  const step = 10 ** (Math.floor(Math.log10(x)) - 2);
  const up = Math.ceil(x / step - 1e-9) * step;
  return Number(up.toPrecision(3)).toString();
}

export const seconds = (t: number): string => `${t.toFixed(Math.abs(t) < 0.01 && t !== 0 ? 6 : 2)} s`;
