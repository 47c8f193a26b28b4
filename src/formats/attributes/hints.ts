import type { Vec3 } from '../../math/vec3.ts';
import { type LocalizedText, type Message, msg } from '../../messages/message.ts';
import type { Material, SceneHints } from '../../scene/types.ts';

/** Viewing hints of a file; values of the wrong type are ignored. */
export function parseSceneHints(get: (name: keyof SceneHints) => unknown): SceneHints {
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

/** Reflectances that can also be textured; `shader`: the USD shader input that reads them. */
export const INVISIBLE_BANDS = [
  { of: 'uv', texture: 'uvTexture', name: 'slowlight:albedo:uv', shader: 'Ultraviolet' },
  { of: 'ir', texture: 'irTexture', name: 'slowlight:albedo:ir', shader: 'Infrared' },
] as const;

/** Names a table of spectral reflectance. */
export const REFLECTANCE_ATTRIBUTE = 'slowlight:reflectance';

/** A material's reflectance and emission outside the visible band. */
type SpectralHints = Pick<Material, 'uv' | 'ir' | 'emissionTemperature'>;

/** Slowlight's material attributes and extras: their fields and ranges. */
export const SPECTRAL_ATTRIBUTES = [
  { of: 'uv', name: 'slowlight:albedo:uv', least: 0, most: 1, range: msg`0 to 1` },
  { of: 'ir', name: 'slowlight:albedo:ir', least: 0, most: 1, range: msg`0 to 1` },
  { of: 'emissionTemperature', name: 'slowlight:emission:temperature', least: 1, most: 1e9, range: msg`1 to 1e9 K` },
] as const;

/** Slowlight's attributes of a dome light: the colours of its horizon and of the ground. */
export const SKY_ATTRIBUTES = ['slowlight:sky:horizon', 'slowlight:sky:ground'] as const;

/** A material's spectral hints; `refuse` is called for each value out of range, which is ignored. */
export function parseSpectralHints(get: (name: string) => unknown, refuse: (message: Message) => void): SpectralHints {
  const hints = SPECTRAL_ATTRIBUTES.flatMap(({ of, name, least, most, range }) => {
    const value = get(name);
    if (value === undefined) return [];
    const number = finite(value);
    if (number !== undefined && number >= least && number <= most) return [[of, number] as const];
    refuse(msg`${name} is ${describeValue(value)}, which is not a number from ${range}; it is left out`);
    return [];
  });
  return Object.fromEntries(hints);
}

const describeValue = (value: unknown): LocalizedText =>
  typeof value === 'string' ? `"${value.slice(0, 40)}"` : typeof value === 'object' ? msg`an object` : String(value);

const finite = (value: unknown): number | undefined =>
  typeof value === 'number' && Number.isFinite(value) ? value : undefined;

function vector(value: unknown): Vec3 | undefined {
  const isList = Array.isArray(value) || ArrayBuffer.isView(value);
  const numbers = isList ? Array.from(value as ArrayLike<unknown>, finite) : [];
  const [x, y, z] = numbers;
  return numbers.length === 3 && x !== undefined && y !== undefined && z !== undefined ? [x, y, z] : undefined;
}
