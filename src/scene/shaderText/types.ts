import { type LocalizedText, msg } from '../../messages/message.ts';
import { refuse, type SourceLocation } from './sourceLocation.ts';

/** Component type; literals are `whole` or `broken` until their context decides. `int` is an i32 of GLSL, which converts to f32 by itself. */
export type ComponentType = 'f32' | 'i32' | 'int' | 'bool' | 'whole' | 'broken';

/** A scalar (1 × 1), a vector (n × 1), a square matrix (column-major), or the current pixel. */
export interface ShaderType {
  readonly of: ComponentType | 'pixel';
  readonly rows: number;
  readonly columns: number;
}

export const scalar = (of: ShaderType['of']): ShaderType => ({ of, rows: 1, columns: 1 });
export const vector = (rows: number, of: ShaderType['of'] = 'f32'): ShaderType => ({ of, rows, columns: 1 });
export const F32 = scalar('f32');
export const I32 = scalar('i32');
export const BOOL = scalar('bool');
export const PIXEL = scalar('pixel');

export const componentCount = ({ rows, columns }: ShaderType): number => rows * columns;
export const isInteger = ({ of }: ShaderType): boolean => of === 'i32' || of === 'int' || of === 'whole';
export const isFloat = ({ of }: ShaderType): boolean => of === 'f32' || of === 'broken';
export const sameShape = (a: ShaderType, b: ShaderType): boolean => a.rows === b.rows && a.columns === b.columns;
export const isSameType = (a: ShaderType, b: ShaderType): boolean => a.of === b.of && sameShape(a, b);
/** Default type of a literal. */
export const concreteType = (type: ShaderType): ShaderType =>
  type.of === 'whole' ? { ...type, of: 'i32' } : type.of === 'broken' ? { ...type, of: 'f32' } : type;
/** Whether one converts implicitly to the other. */
export const isConvertible = (from: ShaderType, to: ShaderType): boolean =>
  sameShape(from, to) && (from.of === to.of || isComponentConvertible(from.of, to.of));
const isComponentConvertible = (from: ShaderType['of'], to: ShaderType['of']): boolean =>
  (from === 'whole' && (to === 'broken' || to === 'f32' || to === 'i32' || to === 'int')) ||
  (from === 'int' && to === 'f32') ||
  (from === 'broken' && to === 'f32');

/** The common component type. */
export function commonComponentType(types: readonly ShaderType[]): ComponentType | undefined {
  const kinds = ['whole', 'broken', 'i32', 'int', 'f32', 'bool'] as const;
  return kinds.find((of) => types.every((type) => type.of === of || isComponentConvertible(type.of, of)));
}

/** As it is written in WGSL. */
export function typeName({ of, rows, columns }: ShaderType): string {
  const component = of === 'whole' ? 'i32' : of === 'broken' ? 'f32' : of === 'pixel' ? 'Pixel' : of;
  if (columns > 1) return `mat${columns}x${rows}f`;
  if (rows === 1) return component;
  return of === 'bool' ? `vec${rows}<bool>` : `vec${rows}${component[0]}`;
}

export const expectType = (found: ShaderType, wanted: ShaderType, at: SourceLocation, what: LocalizedText): void => {
  if (!isConvertible(found, wanted))
    refuse(
      at,
      msg`${what} is ${typeName(found)}, and should be ${typeName(wanted)}: convert it by ${typeName(wanted)}(…)`,
    );
};
