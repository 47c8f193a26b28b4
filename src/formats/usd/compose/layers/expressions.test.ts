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

/** What Sdf.VariableExpression of usd-core makes of expressions, and those it refuses. */
const { values, refused }: { values: [string, ExpressionValue][]; refused: string[] } = JSON.parse(
  readFileSync(new URL('../fixtures/expressions.json', import.meta.url), 'utf8'),
);

describe('expressions', () => {
  it.each(values)('%s', (text, value) => expect(evaluate(text, VARIABLES)).toEqual(value));

  it.each(refused)('%s is refused', (text) => expect(() => evaluate(text, VARIABLES)).toThrow(/./));

  it('are text, or nothing', () => {
    expect(expandExpression('a.usda', VARIABLES)).toBe('a.usda');
    expect(expandExpression('`if(False, "a")`', VARIABLES)).toBe('');
    expect(() => expandExpression('`[1]`', VARIABLES)).toThrow('it makes a list, not text');
  });

  it('of variables that are made of each other end', () => {
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
