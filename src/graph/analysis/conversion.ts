import { ANY } from '../nodeType.ts';

type Conversion = (value: unknown) => unknown;

const identity: Conversion = (value) => value;
const splat: Conversion = (value) => [value, value, value];

/** From each type to those that it converts to. */
const SOCKET_CONVERSIONS: Readonly<Record<string, Readonly<Record<string, Conversion>>>> = {
  number: { vector: splat, color: splat },
  vector: { color: identity },
  color: { vector: identity },
  mask: { image: identity },
  image: { mask: identity },
};

/** Conversion of a value from one socket type to another; undefined if there is none. */
export function conversion(from: string, to: string): Conversion | undefined {
  if (from === to || from === ANY || to === ANY) return identity;
  return Object.hasOwn(SOCKET_CONVERSIONS, from) && Object.hasOwn(SOCKET_CONVERSIONS[from]!, to)
    ? SOCKET_CONVERSIONS[from]![to]
    : undefined;
}
