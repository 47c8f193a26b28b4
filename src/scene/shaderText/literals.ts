import { msg } from '../../messages/message.ts';
import type { ShaderExpression } from './program.ts';
import { refuse, type SourceLocation } from './sourceLocation.ts';
import { scalar } from './types.ts';

/** Nearly the largest f32. */
export const LARGEST = 3.4e38;
export function literal(text: string, at: SourceLocation): ShaderExpression {
  const suffix = /^0[xX]/.test(text) ? /[iu]$/.exec(text)?.[0] : /[fhiu]$/.exec(text)?.[0];
  if (suffix === 'u' || suffix === 'h')
    refuse(at, msg`the number ${text} is of a type that is not taken: leave the ${suffix} out`);
  const value = Number(suffix ? text.slice(0, -1) : text);
  const broken = suffix === 'f' || (!/^0[xX]/.test(text) && /[.eE]/.test(text));
  if (!broken && value > 2 ** 31 - 1)
    refuse(at, msg`${text} is more than the largest i32, 2147483647: write it with a point`);
  if (Math.abs(value) > LARGEST) refuse(at, msg`${text} is more than the largest f32, 3.4e38`);
  const of = suffix === 'f' ? 'f32' : suffix === 'i' ? 'i32' : broken ? 'broken' : 'whole';
  return { op: 'constant', type: { of, rows: 1, columns: 1 }, numbers: [value] };
}

/** Whole numbers are ints, others floats. */
export function glslLiteral(text: string, at: SourceLocation): ShaderExpression {
  const hex = /^0[xX]/.test(text);
  const suffix = hex ? undefined : /[uU]$|(?:lf|LF|[fF])$/.exec(text)?.[0];
  if (suffix === 'u' || suffix === 'U')
    refuse(at, msg`the number ${text} is of a type that is not taken: leave the ${suffix} out`);
  const digits = suffix ? text.slice(0, -suffix.length) : text;
  const found = literal(suffix && !/[.eE]/.test(digits) ? `${digits}.0` : digits, at);
  return { ...found, type: scalar(found.type.of === 'whole' ? 'int' : 'f32') };
}
