import { readdirSync, readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { nodeReference } from '../../src/nodes/docs/nodeReference.ts';
import { FLAGS, withTables } from './flagTables.ts';

const GUIDE = new URL('../../docs/guide/', import.meta.url);
const read = (file: string): string => readFileSync(new URL(file, GUIDE), 'utf8');

// `npm run docs` runs this file with -u, which writes the pages anew.
it('the tables of flags in docs/guide/command-line.md are those of the program', async () => {
  const page = read('command-line.md');
  expect(page.match(/<!-- made: /g)).toHaveLength(6);
  await expect(withTables(page)).toMatchFileSnapshot('../../docs/guide/command-line.md');
});

it('docs/guide/nodes.md is what `slowlight graph docs` prints', async () => {
  await expect(`${nodeReference()}\n`).toMatchFileSnapshot('../../docs/guide/nodes.md');
});

it('the guide names no flag that the program does not have', () => {
  const pages = [...readdirSync(GUIDE).filter((file) => file.endsWith('.md')), '../../README.md'];
  const unknown = pages.flatMap((file) =>
    Array.from(read(file).matchAll(/(?<![\w-])--[a-z][a-z-]*/g), ([flag]) => flag)
      .filter((flag) => !FLAGS.has(flag))
      .map((flag) => `${file}: ${flag}`),
  );
  expect(unknown).toEqual([]);
});
