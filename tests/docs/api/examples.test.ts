import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { claim } from './claim.ts';
import { examplesIn, pageExamples, writeExamples } from './exampleModules.ts';
import { entriesOf, publicApi, ROOT } from './publicApi.ts';

const entries = entriesOf();
const exported = entries.flatMap(publicApi);
const pages = ['README.md', 'docs/api/README.md'].flatMap(pageExamples);
const examples = writeExamples([...exported, ...pages]);
/** Their examples need a GPU: they are compiled, and not run. */
const NEED_GPU = ['compute', 'render'];

async function wrongExamples(entry: string): Promise<string[]> {
  const wrong: string[] = [];
  for (const { path, name } of examples.filter((one) => one.entry === entry))
    await import(/* @vite-ignore */ join(ROOT, path)).catch((error) => wrong.push(`${name}: ${error.message}`));
  return wrong;
}

describe.each(entries)('slowlight/%s', (entry) => {
  const own = exported.filter((one) => one.entry === entry);

  it('says of each export what it is, and shows how to use it', () => {
    const at = ({ name, file, line }: (typeof own)[number], member = '') => `${name}${member} (${file}:${line})`;
    const withoutSentence = own.flatMap((one) => [
      ...(one.text.split('@')[0]!.trim() === '' ? [at(one)] : []),
      ...one.members.filter(({ text }) => text === '').map((member) => at(one, `.${member.name}`)),
    ]);
    const withoutExample = own.filter((one) => !one.isType && examplesIn(one.text).length === 0).map((one) => at(one));
    expect({ withoutSentence, withoutExample }).toEqual({ withoutSentence: [], withoutExample: [] });
  });

  it.skipIf(NEED_GPU.includes(entry))('does what its examples claim', async () => {
    expect(await wrongExamples(entry)).toEqual([]);
  });
});

it('has pages whose examples do what they claim', async () => {
  expect(pages.length).toBeGreaterThan(1);
  expect(await wrongExamples('pages')).toEqual([]);
});

it('has examples that compile', () => {
  expect(examples.reduce((sum, { claims }) => sum + claims, 0)).toBeGreaterThan(250);
  const compiler = join(ROOT, 'node_modules/typescript/bin/tsc');
  const { stdout } = spawnSync(process.execPath, [compiler, '-p', '.cache/api/tsconfig.json'], {
    cwd: ROOT,
    encoding: 'utf8',
  });
  expect(stdout).toBe('');
});

describe('a claim', () => {
  it.each([
    [0.8, '0.8'],
    [0.83, '0.8 c'],
    [[0, 1 / 3], '[0, 0.333]'],
    [new Float64Array([1, 2, 3]), '[1, 2, …]'],
    [{ t: -2, x: [1] }, '{ t: -2, x: [1] }'],
    ['a', "'a'"],
    [undefined, 'undefined: nothing there'],
    [6.626e-34, '6.63e-34 J s'],
  ])('%s is %s', (value, text) => {
    expect(() => claim(value, text)).not.toThrow();
  });

  it.each([
    [0.86, '0.8'],
    [1.0001, '1'],
    [[0, 0.3], '[0, 0.333]'],
    [[1, 2, 3], '[1, 2]'],
    [[1], '[1, 2, …]'],
    [{ t: -2 }, '{ t: -2, x: [1] }'],
    ['b', "'a'"],
    [null, 'undefined'],
    [1, '[1'],
    [1, '1x'],
  ])('%s is not %s', (value, text) => {
    expect(() => claim(value, text)).toThrow();
  });
});
