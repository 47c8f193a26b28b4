import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { DIAGNOSTIC_CODES } from '../../src/formats/diagnostics/diagnosticCodes.ts';
import { entryOf } from '../../src/formats/entry.ts';
import { memorySource } from '../../src/formats/files/fileSource.ts';
import { openScene } from '../../src/formats/open.ts';
import type { ReadOptions } from '../../src/formats/readOptions.ts';
import { memoryFile, zipSource } from '../../src/formats/zip/zipSource.ts';
import { InputError, type Scene } from '../../src/scene/types.ts';
import type { Example, FormatClaim } from './claim.ts';
import { chapters } from './formatClaims.ts';
import { page } from './formatsPage.ts';

const opened = async (files: Example, options: ReadOptions = {}): Promise<Scene> => {
  const given = typeof files === 'function' ? await files() : files;
  const encode = (content: string | Uint8Array) =>
    typeof content === 'string' ? new TextEncoder().encode(content) : content;
  const bytes = Object.fromEntries(Object.entries(given).map(([path, content]) => [path, encode(content)]));
  const [entry] = Object.keys(given);
  if (!entry.endsWith('.zip')) return openScene(memorySource(bytes), entry, options);
  const packed = await zipSource(memoryFile(bytes[entry]), entry, memorySource(bytes));
  return openScene(packed, entryOf(await packed.list())!, options);
};

/** What every file of a format says. */
const ALWAYS = 'file.units';

async function holds(row: FormatClaim): Promise<void> {
  for (const example of [row.files].flat()) await holdsFor(row, example);
}

async function holdsFor(row: FormatClaim, example: Example): Promise<void> {
  if (row.how === 'refused') {
    const error = await opened(example, row.options).then(
      () => undefined,
      (thrown: unknown) => thrown,
    );
    expect(error).toBeInstanceOf(InputError);
    expect((error as InputError).diagnostic.code).toBe(row.says);
    return;
  }
  const scene = await opened(example, row.options);
  const said = scene.diagnostics.filter(({ code }) => code !== ALWAYS);
  if (row.how === 'read') {
    expect(said.filter(({ severity, code }) => severity !== 'info' || code !== row.says)).toEqual([]);
  }
  if (row.says !== undefined) expect(said.map(({ code }) => code)).toContain(row.says);
  row.check?.(scene);
  // The rest is shown, whatever is left out, or it is said that there is none.
  expect(scene.objects.length > 0).toBe(!said.some(({ code }) => code === 'file.no-triangles'));
}

describe.each(chapters)('$title', ({ groups }) => {
  describe.each(groups)('$title', ({ rows }) => {
    it.each(rows)('$what: $how', (row) => holds(row));
  });
});

/** The sources, without tests and their fixtures. */
const sources = (folder: URL): string[] =>
  readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    if (entry.isDirectory()) return entry.name === 'fixtures' ? [] : sources(new URL(`${entry.name}/`, folder));
    const isCode = /\.tsx?$/.test(entry.name) && !/\.test\.tsx?$|^codes\.ts$/.test(entry.name);
    return isCode ? [readFileSync(new URL(entry.name, folder), 'utf8')] : [];
  });

describe('the guide', () => {
  it('lists no code that nothing says', () => {
    const code = sources(new URL('../../src/', import.meta.url)).join('\n');
    expect(Object.keys(DIAGNOSTIC_CODES).filter((name) => !code.includes(`'${name}'`))).toEqual([]);
  });

  /** `npm run docs` makes it anew. */
  it('is what the code says', async () => {
    await expect(page()).toMatchFileSnapshot('../../docs/guide/formats.md');
  });
});
