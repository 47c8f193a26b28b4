import { ANY } from '../nodeType.ts';

type Conversion = (value: unknown) => unknown;

const identity: Conversion = (value) => value;
const splat: Conversion = (value) => [value, value, value];

/** From each type to those that it is taken for where they are wanted. */
const SOCKET_CONVERSIONS: Readonly<Record<string, Readonly<Record<string, Conversion>>>> = {
  number: { vector: splat, color: splat },
  vector: { color: identity },
  color: { vector: identity },
  mask: { image: identity },
  image: { mask: identity },
};

/** How a value of one socket type becomes one of another; undefined where it cannot. */
export function conversion(from: string, to: string): Conversion | undefined {
  if (from === to || from === ANY || to === ANY) return identity;
  return Object.hasOwn(SOCKET_CONVERSIONS, from) && Object.hasOwn(SOCKET_CONVERSIONS[from]!, to)
    ? SOCKET_CONVERSIONS[from]![to]
    : undefined;
}
