import { msg } from '../../messages/message.ts';
import { refuse } from './sourceLocation.ts';
import type { TypeSyntax } from './syntax.ts';
import { type ComponentType, componentCount, PIXEL, type ShaderType, scalar, vector } from './types.ts';

const NAMED = /^(?:(f32|i32|bool)|vec([234])([fi])|mat([234])x\4f)$/;
const TEMPLATED = /^(?:vec([234])|mat([234])x\2)$/;

/** Looks up a type by name; undefined if unknown. A vector or matrix name without component type (`vec3`) has `whole` components. */
export function typeNamed({ name, of, type: known }: TypeSyntax): ShaderType | undefined {
  if (known) return known;
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
  const whole = type && (written.type || !(written.name.length === 4 && !written.of));
  if (type && whole) return type;
  return refuse(
    written.at,
    msg`the type ${written.name} is not known: there are f32, i32, bool, vec2f … vec4f, vec2i … vec4i, mat2x2f, mat3x3f, mat4x4f and Pixel`,
  );
}
