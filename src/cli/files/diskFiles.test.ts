import { appendFileSync, mkdtempSync, rmSync, truncateSync, utimesSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { InputError } from '../../scene/types.ts';
import { openDiskFile, readDiskFile } from './diskFiles.ts';

const folder = mkdtempSync(join(tmpdir(), 'slowlight-disk-'));
afterAll(() => rmSync(folder, { recursive: true }));

function file(name: string) {
  const path = join(folder, name);
  writeFileSync(
    path,
    Uint8Array.from({ length: 100 }, (_, i) => i),
  );
  return { path, opened: openDiskFile(path, name)! };
}

function refusal(read: () => unknown): string {
  try {
    read();
  } catch (error) {
    if (error instanceof InputError) return `${error.diagnostic.code} ${error.message}`;
  }
  throw new Error('was read');
}

describe('a file on disk', () => {
  it('is read in parts through its handle', () => {
    const { opened } = file('a');
    expect(opened.size).toBe(100);
    expect([...readDiskFile(structuredClone(opened.file), 40, 3)]).toEqual([40, 41, 42]);
    expect([...readDiskFile(opened.file, 99, 1)]).toEqual([99]);
  });

  it('that is not a regular file is not opened', () => {
    expect(openDiskFile(join(folder, 'none'), 'none')).toBeUndefined();
    const file = join(folder, 'file');
    writeFileSync(file, 'x');
    expect(openDiskFile(join(file, 'scene.usda'), 'scene.usda')).toBeUndefined();
    expect(openDiskFile(folder, 'folder')).toBeUndefined();
  });

  it.each([
    ['longer', (path: string) => appendFileSync(path, 'x')],
    ['cut off', (path: string) => truncateSync(path, 50)],
    ['newer', (path: string) => utimesSync(path, 1, 1)],
  ])('that has become %s is rejected, whether it was read before or not', (name, change) => {
    for (const before of [true, false]) {
      const { path, opened } = file(`${name} ${before}`);
      if (before) readDiskFile(opened.file, 0, 1);
      change(path);
      expect(refusal(() => readDiskFile(opened.file, 0, 1))).toMatch(/^file\.changed \S+ .*open the scene again$/);
    }
  });

  it('that was deleted is reported', () => {
    const { path, opened } = file('gone');
    rmSync(path);
    expect(refusal(() => readDiskFile(opened.file, 0, 1))).toContain('ENOENT');
  });

  it('is reopened if more files are used than are kept open', () => {
    const many = Array.from({ length: 40 }, (_, i) => file(`many ${i}`).opened);
    for (const round of [1, 2]) for (const { file: one } of many) expect(readDiskFile(one, round, 1)[0]).toBe(round);
  });
});
