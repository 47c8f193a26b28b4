import type { Vec3 } from '../math/vec3.ts';
import type { SceneHints } from '../scene/types.ts';

/** What a file's author suggests for viewing, from the values that stand in it; what is not of its kind is passed over. */
export function hintsFrom(get: (name: keyof SceneHints) => unknown): SceneHints {
  const number = (name: keyof SceneHints): number | undefined => finite(get(name));
  const text = (name: keyof SceneHints): string | undefined => {
    const value = get(name);
    return typeof value === 'string' ? value : undefined;
  };
  const c = number('speedOfLight');
  const hints = {
    speedOfLight: c !== undefined && c > 0 ? c : undefined,
    title: text('title'),
    lookFor: text('lookFor'),
    beta: vector(get('beta')),
    openAt: number('openAt'),
  };
  return Object.fromEntries(Object.entries(hints).filter(([, value]) => value !== undefined));
}

const finite = (value: unknown): number | undefined =>
  typeof value === 'number' && Number.isFinite(value) ? value : undefined;

function vector(value: unknown): Vec3 | undefined {
  const isList = Array.isArray(value) || ArrayBuffer.isView(value);
  const numbers = isList ? Array.from(value as ArrayLike<unknown>, finite) : [];
  const [x, y, z] = numbers;
  return numbers.length === 3 && x !== undefined && y !== undefined && z !== undefined ? [x, y, z] : undefined;
}
