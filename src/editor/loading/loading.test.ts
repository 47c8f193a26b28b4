import { zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { msg } from '../../messages/message.ts';
import { LocalFiles, sceneKey } from './localFiles.ts';
import { missingPaths, suppliesMissingFiles } from './missingFiles.ts';
import { expandArchives, readUserFile } from './userFiles.ts';

const blob = (words: string) => new Blob([words]);
const text = async (bytes: Promise<Uint8Array>) => new TextDecoder().decode(await bytes);

describe('the files of a session', () => {
  it('form sets, in which any scene can be opened', () => {
    const local = new LocalFiles();
    const source = local.add(
      new Map([
        ['a/x.usda', blob('x')],
        ['a/y.usda', blob('y')],
      ]),
      'a/x.usda',
    );
    expect(source).toBe('local:1/a/x.usda');
    expect(local.get(local.sibling(source, 'a/y.usda'))?.entry).toBe('a/y.usda');
    expect(local.paths(source)).toEqual(['a/x.usda', 'a/y.usda']);
    expect(local.get('local:7/a.usda')).toBeUndefined();
    expect(local.get('examples/street.usdc')).toBeUndefined();
  });

  it('can be extended without changing the scene; the previous set stays for undo', () => {
    const local = new LocalFiles();
    const first = local.add(new Map([['a/x.usda', blob('x')]]), 'a/x.usda');
    const second = local.addToSet(
      first,
      new Map([
        ['wood.png', blob('w')],
        ['tex/ice.png', blob('i')],
      ]),
    );
    const third = local.addToSet(second, new Map([['last.png', blob('l')]]));
    expect(local.paths(third)).toEqual(['a/x.usda', 'a/wood.png', 'tex/ice.png', 'a/last.png']);
    expect(local.paths(first)).toEqual(['a/x.usda']);
    expect(new Set([first, second, third].map(sceneKey))).toEqual(new Set(['local:1/a/x.usda']));
    expect(new Set([first, second, third]).size).toBe(3);
    const branch = local.addToSet(first, new Map());
    expect(branch).not.toBe(second);
    expect(local.paths(second)).toHaveLength(3);
  });

  it('unpack archives when they are read, with progress', async () => {
    const zip = new Blob([zipSync({ 's/a.txt': new TextEncoder().encode('packed') })]);
    const files = await expandArchives(
      new Map([
        ['set.zip', zip],
        ['b.txt', blob('plain')],
      ]),
    );
    expect([...files.keys()]).toEqual(['set.zip/s/a.txt', 'b.txt']);
    const heard: number[] = [];
    const report = (received: number, total: number) => heard.push(received / total);
    expect(await text(readUserFile(files.get('set.zip/s/a.txt')!, report))).toBe('packed');
    expect(await text(readUserFile(files.get('b.txt')!, report))).toBe('plain');
    expect(heard.at(-1)).toBe(1);
    await expect(expandArchives(new Map([['bad.zip', blob('no')]]))).rejects.toThrow(/bad\.zip: the archive/);
  });
});

describe('the purpose of dropped files', () => {
  const missing = missingPaths([
    {
      severity: 'warning',
      code: 'x',
      place: '',
      message: msg`missing`,
      missing: { name: '../Tex/Wood%20a.PNG', lookedFor: ['tex/wood a.png'] },
    },
    { severity: 'info', code: 'y', place: '', message: msg`whatever` },
  ]);
  it.each([
    [['wood a.png'], false, true],
    [['else/WOOD A.png', 'other.usda'], false, false],
    [['else/WOOD A.png', 'else/Open.usda'], false, true],
    [['stone.png'], false, false],
    [['scene.usda'], false, false],
    [['data.bin'], true, true],
    [['scene.usda'], true, false],
  ])('%j, rejected: %s → %s', (paths, isRefused, result) =>
    expect(suppliesMissingFiles(paths, { name: 'open.usda', missing, failed: isRefused })).toBe(result),
  );
});
