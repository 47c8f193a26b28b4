import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { saying } from '../../tests/support/inWords.ts';
import { inEnglish } from '../messages/message.ts';
import { type ExpressionContext, evaluateExpression } from './expression.ts';

const value = (text: string, context?: ExpressionContext) => {
  const result = evaluateExpression(text, context);
  return 'value' in result ? result.value : result.problem;
};

describe('expressions', () => {
  it.each<[string, ExpressionContext | undefined, number]>([
    ['1 + 2*3', undefined, 7],
    ['(1 + 2)*3', undefined, 9],
    ['-2^2', undefined, -4],
    ['2^-1', undefined, 0.5],
    ['10/4/5', undefined, 0.5],
    ['.5e1', undefined, 5],
    ['2pi', undefined, 2 * Math.PI],
    ['50 %', undefined, 0.5],
    ['sin(30deg)', undefined, 0.5],
    ['gamma(0.6)', undefined, 1.25],
    ['beta(1.25)', undefined, 0.6],
    ['90deg', undefined, Math.PI / 2],
    ['0.9*c', { unit: 'm/s', speedOfLight: 30 }, 27],
    ['0.9*c', { unit: 'c', speedOfLight: 30 }, 0.9],
    ['0.9', { unit: 'c', speedOfLight: 30 }, 0.9],
    ['15 m/s', { unit: 'c', speedOfLight: 30 }, 0.5],
    ['36 km/h', { unit: 'm/s' }, 10],
    ['30deg', { unit: '°' }, 30],
    ['(pi/6) rad', { unit: '°' }, 30],
    ['(1/4) turn', { unit: '°' }, 90],
    ['2 min', { unit: 's' }, 120],
    ['5 m^2 / 1 m', { unit: 'm' }, 5],
    ['3 m/s^2 * 2 s', { unit: 'm/s' }, 6],
    ['1 − 2 × 3', undefined, -5],
    ['0.5', { unit: 'EV' }, 0.5],
  ])('%s in %o is %d', (text, context, wanted) => {
    expect(value(text, context)).toBeCloseTo(wanted, 12);
  });

  it.each<[string, ExpressionContext | undefined, RegExp, number]>([
    ['', undefined, /missing at the end/, 0],
    ['1 +', undefined, /missing at the end/, 3],
    ['1 + 2)', undefined, /"\)" does not belong/, 5],
    ['(1 + 2', undefined, /not closed/, 0],
    ['2 parrots', undefined, /"parrots" is neither/, 1],
    ['constructor', undefined, /neither/, 0],
    ['c', undefined, /"c" is neither/, 0],
    ['1 m + 2 s', { unit: 'm' }, /m and s do not add/, 4],
    ['5 km', { unit: 's' }, /a value in m where s/, 0],
    ['5 km', undefined, /a value in m where a plain number/, 0],
    ['5 km', { unit: 'EV' }, /a value in m where EV/, 0],
    ['1/0', undefined, /no finite number/, 0],
    ['2^(1 m)', undefined, /exponent/, 1],
    ['(2 m)^0.5', undefined, /whole numbers/, 5],
    ['sqrt(1, 2)', undefined, /takes one value/, 0],
    ['sin(1 m)', undefined, /plain numbers and angles/, 0],
    ['1 $ 2', undefined, /"\$" is not understood/, 1],
    ['('.repeat(60), undefined, /brackets in one another/, 16],
  ])('%s in %o is rejected with its position', (text, context, message, at) => {
    const result = evaluateExpression(text, context);
    expect(result).toMatchObject({ problem: saying(message) });
    expect('at' in result && Math.abs(result.at - at)).toBeLessThanOrEqual(1);
  });

  it('agree with JavaScript’s arithmetic', () => {
    const arithmetic = fc.letrec<{ sum: string }>((tie) => ({
      sum: fc.oneof(
        { maxDepth: 4 },
        fc.integer({ min: 0, max: 99 }).map(String),
        fc.tuple(tie('sum'), fc.constantFrom('+', '-', '*'), tie('sum')).map(([a, op, b]) => `(${a}) ${op} (${b})`),
        tie('sum').map((a) => `-(${a})`),
      ),
    })).sum;
    fc.assert(
      fc.property(arithmetic, (text) => {
        fc.pre(text.length <= 200 && text.split('(').length < 10);
        // Reference: JavaScript's own arithmetic, for texts of digits, parentheses and operators only.
        expect(value(text)).toBe(new Function(`return ${text}`)());
      }),
    );
  });

  it('of any text give a value or a problem', () => {
    const letters = fc.constantFrom(...'0123456789.+-*/^(),% cmskhe°π×\u00a0$"'.split(''));
    fc.assert(
      fc.property(fc.string({ unit: letters, maxLength: 220 }), (text) => {
        const result = evaluateExpression(text, { unit: 'm/s', speedOfLight: 30 });
        if ('value' in result) expect(Number.isFinite(result.value)).toBe(true);
        else expect(inEnglish(result.problem)).not.toBe('');
      }),
      { numRuns: 2000 },
    );
  });
});
