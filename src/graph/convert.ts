import { ANY } from './nodeType.ts';

type Conversion = (value: unknown) => unknown;

const same: Conversion = (value) => value;
const threefold: Conversion = (value) => [value, value, value];

/** From each type to those that it is taken for where they are wanted. */
const CONVERSIONS: Readonly<Record<string, Readonly<Record<string, Conversion>>>> = {
  number: { vector: threefold, color: threefold },
  vector: { color: same },
  color: { vector: same },
  mask: { image: same },
  image: { mask: same },
};

/** How a value of one socket type becomes one of another; undefined where it cannot. */
export function conversion(from: string, to: string): Conversion | undefined {
  if (from === to || from === ANY || to === ANY) return same;
  return Object.hasOwn(CONVERSIONS, from) && Object.hasOwn(CONVERSIONS[from]!, to) ? CONVERSIONS[from]![to] : undefined;
}
