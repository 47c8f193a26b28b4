import { Option } from 'commander';
import { parseVariantChoice } from '../../formats/variantChoice.ts';
import { length, type Vec3 } from '../../math/vec3.ts';
import { listed, type Message, msg } from '../../messages/message.ts';
import { MAX_SAMPLES } from '../../reference/lights/lightOptions.ts';
import type { NumberRange } from '../../scene/settings/setting.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import { AOVS, type AovName } from '../../scene/view/view.ts';
import { InvalidValue } from '../terminal/commandLineErrors.ts';
import { localized } from '../terminal/language.ts';

/** Parsers of flag values. Each throws an InvalidValue that says what was expected. */

export function parseNumber(text: string): number {
  const value = Number(text);
  if (text.trim() === '' || !Number.isFinite(value)) throw new InvalidValue(msg`Expected a number.`);
  return value;
}

/** Parser of a number with a condition; `expected` describes it in the error. */
const numberWhere =
  (condition: (value: number) => boolean, expected: Message) =>
  (text: string): number => {
    const value = parseNumber(text);
    if (!condition(value)) throw new InvalidValue(msg`Expected ${expected}.`);
    return value;
  };

/** Parser of a number within a range. */
export function parseWithin(range: NumberRange): (text: string) => number {
  const { min = Number.NEGATIVE_INFINITY, above = Number.NEGATIVE_INFINITY, max = Number.POSITIVE_INFINITY } = range;
  const whole = range.integer === true;
  return numberWhere((x) => x >= min && x > above && x <= max && (!whole || Number.isInteger(x)), described(range));
}

function described({ min, above, max, integer }: NumberRange): Message {
  if (integer) return msg`a whole number, ${min ?? ''} to ${max ?? ''}`;
  if (above !== undefined)
    return max === undefined ? msg`a number above ${above}` : msg`a number above ${above} and at most ${max}`;
  return max === undefined ? msg`a number, ${min ?? ''} or above` : msg`a number from ${min ?? ''} to ${max}`;
}

export const parsePositive = parseWithin({ above: 0 });
export const parseNotNegative = parseWithin({ min: 0 });
export const parseFraction = parseWithin({ min: 0, max: 1 });
export const parseFov = numberWhere((x) => x > 0 && x < 180, msg`degrees between 0 and 180`);
export const parseAperture = numberWhere((x) => x > 0 && x <= 360, msg`degrees above 0 and at most 360`);
export const parseDomeTilt = numberWhere((x) => x >= -90 && x <= 90, msg`degrees from -90 to 90`);
export const parseSamples = parseWithin({ min: 1, max: MAX_SAMPLES, integer: true });
export const parseLevels = parseWithin({ min: 0, max: 8, integer: true });
export const parsePort = numberWhere((x) => Number.isInteger(x) && x >= 0 && x <= 65535, msg`a port, 0 to 65535`);

export function parseVec3(text: string): Vec3 {
  const parts = text.split(',');
  if (parts.length !== 3) throw new InvalidValue(msg`Expected three numbers, X,Y,Z.`);
  const [x, y, z] = parts.map(parseNumber) as [number, number, number];
  return [x, y, z];
}

/** Adds a text to those of the previous uses of a repeatable flag. */
export const addText = (text: string, before: readonly string[] = []): readonly string[] => [...before, text];

/** A velocity in units of c. */
export function parseBeta(text: string): Vec3 {
  const beta = parseVec3(text);
  if (length(beta) >= 1) {
    throw new InvalidValue(msg`Its length is ${length(beta)}, and nothing with mass reaches 1 (the speed of light).`);
  }
  return beta;
}

/** Adds `SET=OPTION` to the previous choices; the set must not contain `=`. */
export function addVariant(text: string, before: ReadonlyMap<string, string> = new Map()): ReadonlyMap<string, string> {
  const choice = parseVariantChoice(text);
  if (!choice) throw new InvalidValue(msg`Expected SET=OPTION, as inspect lists them: /World/Car{paint}=red.`);
  return new Map([...before, choice]);
}

export function parseSize(text: string): PictureSize {
  const match = /^(\d+)[x×](\d+)$/i.exec(text.trim());
  const width = Number(match?.[1]);
  const height = Number(match?.[2]);
  if (!(width >= 1 && height >= 1 && width <= 16384 && height <= 16384)) {
    throw new InvalidValue(msg`Expected WIDTHxHEIGHT in pixels, like 1280x720.`);
  }
  return { width, height };
}

/** `--size`; default 1280x720. */
export const sizeOption = (meaning: Message): Option =>
  new Option('--size <WxH>', localized(meaning)).argParser(parseSize).default({ width: 1280, height: 720 }, '1280x720');

/** `FROM:TO`, two numbers, the smaller first. */
export function parseRange(text: string): { readonly from: number; readonly to: number } {
  const parts = text.split(':');
  const [from, to] = parts.map(Number) as [number, number];
  if (parts.length !== 2 || !Number.isFinite(from) || !Number.isFinite(to) || !(from < to)) {
    throw new InvalidValue(msg`Expected FROM:TO, two numbers, the smaller one first, like -2:0.`);
  }
  return { from, to };
}

export interface FrameRange {
  readonly first: number;
  readonly last: number;
}

/** `FIRST:LAST`, inclusive. */
export function parseFrames(text: string): FrameRange {
  const match = /^(-?\d+):(-?\d+)$/.exec(text.trim());
  const first = Number(match?.[1]);
  const last = Number(match?.[2]);
  if (!match || last < first) throw new InvalidValue(msg`Expected FIRST:LAST, two whole numbers, like 1:48.`);
  return { first, last };
}

/** Names of data channels. A world time, which 32 bits hold to 0.5 s after 10⁷ s, comes with the time relative to the observer's. */
export function parseAovs(text: string): AovName[] {
  const names = text.split(',').map((name) => name.trim());
  const unknown = names.filter((name) => !(name in AOVS));
  if (unknown.length > 0) {
    throw new InvalidValue(msg`There is no AOV ${listed(unknown)}; there are ${listed(Object.keys(AOVS))}.`);
  }
  const written = (names as AovName[]).flatMap((name): AovName[] =>
    name === 'emission_time' ? [name, 'emission_time_relative'] : [name],
  );
  return [...new Set(written)];
}

/** Pixel coordinates from the top left; the centre of the first pixel is 0,0. */
export function parsePixel(text: string): readonly [number, number] {
  const parts = text.split(',');
  if (parts.length !== 2) throw new InvalidValue(msg`Expected two numbers, X,Y.`);
  const [x, y] = parts.map(parseNumber) as [number, number];
  return [x, y];
}
