import { describe, expect, it } from 'vitest';
import { openScene } from '../../src/formats/open.ts';
import { memorySource } from '../../src/formats/source.ts';
import { InputError, type Scene } from '../../src/scene/types.ts';
import { chapters } from './chapters.ts';
import type { Row } from './row.ts';

const opened = async ({ files, options }: Row): Promise<Scene> => {
  const given = typeof files === 'function' ? await files() : files;
  const encode = (content: string | Uint8Array) =>
    typeof content === 'string' ? new TextEncoder().encode(content) : content;
  const bytes = Object.fromEntries(Object.entries(given).map(([path, content]) => [path, encode(content)]));
  return openScene(memorySource(bytes), Object.keys(given)[0], options);
};

/** What every file of a format says. */
const ALWAYS = 'file.units';

async function holds(row: Row): Promise<void> {
  if (row.how === 'refused') {
    const error = await opened(row).then(
      () => undefined,
      (thrown: unknown) => thrown,
    );
    expect(error).toBeInstanceOf(InputError);
    expect((error as InputError).diagnostic.code).toBe(row.says);
    return;
  }
  const scene = await opened(row);
  const said = scene.diagnostics.filter(({ code }) => code !== ALWAYS);
  if (row.how === 'read') {
    expect(said.filter(({ severity, code }) => severity !== 'info' || code !== row.says)).toEqual([]);
  }
  if (row.says !== undefined) expect(said.map(({ code }) => code)).toContain(row.says);
  row.check?.(scene);
  // The rest is shown, whatever is left out.
  expect(scene.objects.length).toBeGreaterThan(0);
}

describe.each(chapters)('$title', ({ groups }) => {
  describe.each(groups)('$title', ({ rows }) => {
    it.each(rows)('$what: $how', (row) => holds(row));
  });
});
