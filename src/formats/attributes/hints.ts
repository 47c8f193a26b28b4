import type { Vec3 } from '../../math/vec3.ts';
import type { Material, SceneHints } from '../../scene/types.ts';

/** What a file's author suggests for viewing, from the values that stand in it; what is not of its kind is passed over. */
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

/** Reflectances that a picture may tell, too; `shader`: what reads it where that is a USD material. */
export const INVISIBLE_BANDS = [
  { of: 'uv', texture: 'uvTexture', name: 'slowlight:albedo:uv', shader: 'Ultraviolet' },
  { of: 'ir', texture: 'irTexture', name: 'slowlight:albedo:ir', shader: 'Infrared' },
] as const;

/** A table of what a material reflects at each wavelength. */
export const REFLECTANCE_ATTRIBUTE = 'slowlight:reflectance';

/** What a material says of light that eyes do not see at rest. */
type SpectralHints = Pick<Material, 'uv' | 'ir' | 'emissionTemperature'>;

/** Of the attributes and extras of a material that are ours: where each comes from, and what it may be. */
export const SPECTRAL_ATTRIBUTES = [
  { of: 'uv', name: 'slowlight:albedo:uv', least: 0, most: 1, range: '0 to 1' },
  { of: 'ir', name: 'slowlight:albedo:ir', least: 0, most: 1, range: '0 to 1' },
  { of: 'emissionTemperature', name: 'slowlight:emission:temperature', least: 1, most: 1e9, range: '1 to 1e9 K' },
] as const;

/** Our own attributes of a dome: the colours of its horizon and of the ground. */
export const SKY_ATTRIBUTES = ['slowlight:sky:horizon', 'slowlight:sky:ground'] as const;

/** The hints of a material; `refuse` is told of each that is no number of its range, which is passed over. */
export function parseSpectralHints(get: (name: string) => unknown, refuse: (message: string) => void): SpectralHints {
  const hints = SPECTRAL_ATTRIBUTES.flatMap(({ of, name, least, most, range }) => {
    const value = get(name);
    if (value === undefined) return [];
    const number = finite(value);
    if (number !== undefined && number >= least && number <= most) return [[of, number] as const];
    refuse(`${name} is ${describeValue(value)}, which is not a number from ${range}; it is left out`);
    return [];
  });
  return Object.fromEntries(hints);
}

const describeValue = (value: unknown): string =>
  typeof value === 'number' ? String(value) : typeof value === 'string' ? `"${value.slice(0, 40)}"` : typeof value;

const finite = (value: unknown): number | undefined =>
  typeof value === 'number' && Number.isFinite(value) ? value : undefined;

function vector(value: unknown): Vec3 | undefined {
  const isList = Array.isArray(value) || ArrayBuffer.isView(value);
  const numbers = isList ? Array.from(value as ArrayLike<unknown>, finite) : [];
  const [x, y, z] = numbers;
  return numbers.length === 3 && x !== undefined && y !== undefined && z !== undefined ? [x, y, z] : undefined;
}
