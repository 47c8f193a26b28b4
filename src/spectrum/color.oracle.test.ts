import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { hasColorScience, python } from '../../tests/support/pythonOracles.ts';

const fixture = (name: string): string => fileURLToPath(new URL(`./fixtures/${name}`, import.meta.url));

describe.skipIf(!hasColorScience())('colour-science', () => {
  it('reproduces the committed values', () => {
    const committed = JSON.parse(readFileSync(fixture('oracle.expected.json'), 'utf8'));
    const fresh = JSON.parse(python(fixture('oracle.py')));
    expect(differences(fresh, committed)).toEqual([]);
  });

  it('has the same tables as the sources', () => {
    const script = fileURLToPath(new URL('../../scripts/spectrumTables.py', import.meta.url));
    const numbers = JSON.parse(python(script, '--json'));
    const ours = new Map(
      ['cie1931', 'mallettYuksel', 'daylightSeries', 'lamps'].flatMap((name) => tablesOf(`./tables/${name}.ts`)),
    );
    expect([...ours.keys()].sort()).toEqual(Object.keys(numbers).sort());
    for (const [name, values] of ours) expect(values, name).toEqual(numbers[name]);
  });
});

/** Paths of numbers that differ in the first eight digits; another machine's numpy may round differently beyond. */
function differences(a: unknown, b: unknown, path = ''): string[] {
  if (typeof a === 'number' && typeof b === 'number')
    return Math.abs(a - b) <= 1e-8 * Math.abs(b) + 1e-12 ? [] : [`${path}: ${a}, not ${b}`];
  if (typeof a !== 'object' || typeof b !== 'object' || !a || !b) return a === b ? [] : [path];
  const keys = new Set([...Object.keys(a), ...Object.keys(b)]);
  return [...keys].flatMap((key) => differences(Reflect.get(a, key), Reflect.get(b, key), `${path}/${key}`));
}

/** The arrays of a file of tables, by export name. */
function tablesOf(file: string): [name: string, values: number[]][] {
  const text = readFileSync(fileURLToPath(new URL(file, import.meta.url)), 'utf8');
  return [...text.matchAll(/export const (\w+): readonly number\[\] = (\[[^\]]*\]);/g)].map(([, name, values]) => [
    name,
    JSON.parse(values.replace(/,\s*\]/, ']')),
  ]);
}
