import { msg } from '../../messages/message.ts';
import { convertComponents, reshapeMatrix } from './arithmetic.ts';
import { constants, convertTo, partsOf } from './operations.ts';
import type { ShaderExpression } from './program.ts';
import { refuse, type SourceLocation } from './sourceLocation.ts';
import {
  commonComponentType,
  componentCount,
  concreteType,
  isConvertible,
  isSameType,
  type ShaderType,
  sameShape,
  typeName,
} from './types.ts';

/** `vec3f(…)`, `f32(…)`, `mat2x2f(…)`. */
export function constructed(type: ShaderType, args: readonly ShaderExpression[], at: SourceLocation): ShaderExpression {
  const size = componentCount(type);
  const bare = type.of === 'whole';
  const of = bare ? commonComponentType(args.map((arg) => arg.type)) : type.of;
  if (!of) return refuse(at, msg`the values are of different types: convert them`);
  const made: ShaderType = { ...type, of };
  const one = args[0];
  if (!one) return { op: 'constant', type: concreteType(made), numbers: Array.from({ length: size }, () => 0) };
  if (args.length === 1 && sameShape(one.type, type) && type.columns === 1) return converted(one, made, at);
  const total = args.reduce((sum, arg) => sum + componentCount(arg.type), 0);
  const splat = args.length === 1 && componentCount(one.type) === 1 && type.columns === 1;
  if (total !== size && !splat) refuse(at, msg`${typeName(made)} has ${size} components, and is given ${total}`);
  const parts = args.map((arg, i) => {
    if (arg.type.of !== made.of && !isConvertible(arg.type, { ...arg.type, of: made.of }))
      refuse(at, msg`component ${i + 1} of ${typeName(made)} is ${typeName(arg.type)}: convert it by ${made.of}(…)`);
    return convertTo(arg, { ...arg.type, of: made.of });
  });
  const known = constants(parts)?.flat();
  if (!known) return { op: 'build', type: made, parts };
  return { op: 'constant', type: made, numbers: splat ? Array.from({ length: size }, () => known[0] ?? 0) : known };
}

/** As `constructed`, but components of any type are converted, a vector may be cut short, and matrices are made of a number or another matrix. */
export function glslConstructed(
  type: ShaderType,
  args: readonly ShaderExpression[],
  at: SourceLocation,
): ShaderExpression {
  const [one] = args;
  if (!one) return refuse(at, msg`${typeName(type)} has ${componentCount(type)} components, and is given ${0}`);
  const made = args.map((arg) => converted(arg, { ...arg.type, of: type.of }, at));
  const [first] = made as [ShaderExpression];
  if (made.length > 1) {
    const total = made.reduce((sum, arg) => sum + componentCount(arg.type), 0);
    const last = made.at(-1) as ShaderExpression;
    const excess = total - componentCount(type);
    // GLSL drops what the last value has too much.
    if (excess > 0 && excess < componentCount(last.type) && last.type.columns === 1) {
      const kept = Array.from({ length: componentCount(last.type) - excess }, (_, k) => k);
      return constructed(type, [...made.slice(0, -1), partsOf(last, kept)], at);
    }
    return constructed(type, made, at);
  }
  if (type.columns > 1) return matrixOfOne(type, first, at);
  if (first.type.columns === 1 && first.type.rows > type.rows) {
    const kept = Array.from({ length: type.rows }, (_, k) => k);
    return partsOf(first, kept);
  }
  return constructed(type, [first], at);
}

/** A multiple of the identity, or another matrix cut out or filled up by the identity. */
function matrixOfOne(type: ShaderType, one: ShaderExpression, at: SourceLocation): ShaderExpression {
  if (one.type.columns === 1 && one.type.rows > 1) refuse(at, msg`a matrix is not made of a vector`);
  if (one.op === 'constant') return { op: 'constant', type, numbers: reshapeMatrix(one.numbers, one.type, type) };
  return { op: 'reshape', type, of: one };
}

function converted(from: ShaderExpression, to: ShaderType, at: SourceLocation): ShaderExpression {
  if (from.type.of === 'pixel') refuse(at, msg`a Pixel is no number: take its position, uv, size, direction or color`);
  if (from.op === 'constant') return { op: 'constant', type: to, numbers: convertComponents(from.numbers, to) };
  return isSameType(from.type, to) ? from : { op: 'convert', type: to, of: from };
}
