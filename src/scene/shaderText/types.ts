import { type LocalizedText, msg } from '../../messages/message.ts';
import { refuse, type SourceLocation } from './sourceLocation.ts';
import type { TypeSyntax } from './syntax.ts';

/** Component type; literals are `whole` or `broken` until their context decides. */
export type ComponentType = 'f32' | 'i32' | 'bool' | 'whole' | 'broken';

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
  (from === 'whole' && (to === 'broken' || to === 'f32' || to === 'i32')) || (from === 'broken' && to === 'f32');

/** The common component type. */
export function commonComponentType(types: readonly ShaderType[]): ComponentType | undefined {
  const kinds = ['whole', 'broken', 'i32', 'f32', 'bool'] as const;
  return kinds.find((of) => types.every((type) => type.of === of || isComponentConvertible(type.of, of)));
}

const NAMED = /^(?:(f32|i32|bool)|vec([234])([fi])|mat([234])x\4f)$/;
const TEMPLATED = /^(?:vec([234])|mat([234])x\2)$/;

/** As it is written in WGSL. */
export function typeName({ of, rows, columns }: ShaderType): string {
  const component = of === 'whole' ? 'i32' : of === 'broken' ? 'f32' : of === 'pixel' ? 'Pixel' : of;
  if (columns > 1) return `mat${columns}x${rows}f`;
  if (rows === 1) return component;
  return of === 'bool' ? `vec${rows}<bool>` : `vec${rows}${component[0]}`;
}

/** Looks up a type by name; undefined if unknown. A vector or matrix name without component type (`vec3`) has `whole` components. */
export function typeNamed({ name, of }: TypeSyntax): ShaderType | undefined {
  if (name === 'Pixel') return PIXEL;
  const named = NAMED.exec(name);
  if (named && !of) {
    const [, component, n, letter, size] = named;
    if (component) return scalar(component as ComponentType);
    if (n) return vector(Number(n), letter === 'f' ? 'f32' : 'i32');
    return { of: 'f32', rows: Number(size), columns: Number(size) };
  }
  const shape = TEMPLATED.exec(name);
  const inner = of && typeNamed(of);
  if (!shape || (of && !inner) || (inner && componentCount(inner) !== 1)) return undefined;
  const [, n, size] = shape;
  if (n) return vector(Number(n), inner?.of ?? 'whole');
  return { of: 'f32', rows: Number(size), columns: Number(size) };
}

/** The type annotation of a value or parameter. */
export function declaredType(written: TypeSyntax): ShaderType {
  const type = typeNamed(written);
  const whole = type && !(written.name.length === 4 && !written.of);
  if (type && whole) return type;
  return refuse(
    written.at,
    msg`the type ${written.name} is not known: there are f32, i32, bool, vec2f … vec4f, vec2i … vec4i, mat2x2f, mat3x3f, mat4x4f and Pixel`,
  );
}

export const expectType = (found: ShaderType, wanted: ShaderType, at: SourceLocation, what: LocalizedText): void => {
  if (!isConvertible(found, wanted))
    refuse(
      at,
      msg`${what} is ${typeName(found)}, and should be ${typeName(wanted)}: convert it by ${typeName(wanted)}(…)`,
    );
};
