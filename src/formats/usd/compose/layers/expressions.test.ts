import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { type ExpressionValue, evaluate, expandExpression } from './expressions.ts';

const VARIABLES = new Map<string, ExpressionValue>([
  ['S', 'hello'],
  ['N', 7],
  ['B', true],
  ['A', ['a', 'b']],
  ['I', [1, 2, 3]],
  ['E', `\`"x_\${S}"\``],
  ['Z', null],
]);

/** Values of expressions by usd-core’s Sdf.VariableExpression, and the expressions it rejects. */
const { values, refused }: { values: [string, ExpressionValue][]; refused: string[] } = JSON.parse(
  readFileSync(new URL('../fixtures/expressions.json', import.meta.url), 'utf8'),
);

describe('expressions', () => {
  it.each(values)('%s', (text, value) => expect(evaluate(text, VARIABLES)).toEqual(value));

  it.each(refused)('%s is rejected', (text) => expect(() => evaluate(text, VARIABLES)).toThrow(/./));

  it('are strings, or undefined', () => {
    expect(expandExpression('a.usda', VARIABLES)).toBe('a.usda');
    expect(expandExpression('`if(False, "a")`', VARIABLES)).toBe('');
    expect(() => expandExpression('`[1]`', VARIABLES)).toThrow('it makes a list, not text');
  });

  it('of mutually dependent variables terminate', () => {
    const circle = new Map([
      ['A', `\`"\${B}"\``],
      ['B', `\`"\${A}"\``],
    ]);
    expect(() => evaluate(`\`\${A}\``, circle)).toThrow('the variable A is made of itself');
    const bomb = new Map(Array.from({ length: 40 }, (_, i) => [`V${i}`, `\`"\${V${i + 1}}\${V${i + 1}}"\``]));
    expect(() => evaluate(`\`\${V0}\``, bomb)).toThrow('it takes too many steps');
    expect(() => evaluate(`\`${'['.repeat(1e5)}`, circle)).toThrow();
  });
});
