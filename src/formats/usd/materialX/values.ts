import type { TupleType, Value } from '../layer/layer.ts';
import { isPrimName } from '../layer/paths.ts';

/** USD type and storage of a MaterialX type. */
interface InputType {
  readonly typeName: string;
  readonly stored: TupleType | 'float' | 'int' | 'bool' | 'string' | 'asset' | 'token';
  readonly size: number;
}

const tuple = (typeName: string, stored: TupleType, size: number): InputType => ({ typeName, stored, size });

/** By MaterialX type; others, such as surfaceshader, are tokens. */
const TYPES: ReadonlyMap<string, InputType> = new Map<string, InputType>([
  ['float', { typeName: 'float', stored: 'float', size: 1 }],
  ['integer', { typeName: 'int', stored: 'int', size: 1 }],
  ['boolean', { typeName: 'bool', stored: 'bool', size: 1 }],
  ['color3', tuple('color3f', 'float3', 3)],
  ['color4', tuple('color4f', 'float4', 4)],
  ['vector2', tuple('float2', 'float2', 2)],
  ['vector3', tuple('float3', 'float3', 3)],
  ['vector4', tuple('float4', 'float4', 4)],
  ['matrix33', tuple('matrix3d', 'matrix3d', 9)],
  ['matrix44', tuple('matrix4d', 'matrix4d', 16)],
  ['string', { typeName: 'string', stored: 'string', size: 1 }],
  ['geomname', { typeName: 'string', stored: 'string', size: 1 }],
  ['filename', { typeName: 'asset', stored: 'asset', size: 1 }],
]);
const TOKEN: InputType = { typeName: 'token', stored: 'token', size: 1 };

export const usdTypeOf = (type: string): InputType => TYPES.get(type) ?? TOKEN;

/** The value that a text means; undefined if it is none of that type. */
export function parseMaterialXValue(type: string, text: string): Value | undefined {
  const { stored, size } = usdTypeOf(type);
  if (stored === 'string' || stored === 'asset' || stored === 'token') return { type: stored, data: text };
  if (stored === 'bool') {
    const word = text.trim();
    return word === 'true' || word === 'false' ? { type: 'bool', data: word === 'true' } : undefined;
  }
  // MaterialX separates by commas, by spaces, or by both.
  const numbers = (text.match(/[^,\s]+/g) ?? []).map(Number);
  if (numbers.length !== size || !numbers.every(Number.isFinite)) return undefined;
  if (stored === 'float') return { type: 'float', data: Math.fround(numbers[0]) };
  if (stored === 'int') return Number.isInteger(numbers[0]) ? { type: 'int', data: numbers[0] | 0 } : undefined;
  return { type: stored, data: stored.endsWith('d') ? Float64Array.from(numbers) : Float32Array.from(numbers) };
}

/** The name of a prim or property for that of an element: namespaces end with `__`, as in usdMtlx. */
export function usdName(name: string): string {
  const made = name.replaceAll(':', '__');
  return isPrimName(made) ? made : `_${made.replaceAll(/[^\p{L}\p{N}_]/gu, '_')}`;
}
