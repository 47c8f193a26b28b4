import fc from 'fast-check';
import { zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { entryOf } from '../entry.ts';
import { memorySource } from '../files/fileSource.ts';
import { readZipDirectory } from './directory.ts';
import { memoryFile, splitArchive, zipSource } from './zipSource.ts';

const text = (words: string) => new TextEncoder().encode(words);
const FILES = {
  'set/scene.usda': text('#usda 1.0\n'.repeat(200)),
  'set/tex/wood.png': text('wood'),
  '__MACOSX/set/._scene.usda': text('fork'),
};
const opened = (bytes: Uint8Array, around = {}) => zipSource(memoryFile(bytes), 'set.zip', memorySource(around));

/** A copy with a number of two or four bytes set at an offset. */
function with2(bytes: Uint8Array, at: number, value: number): Uint8Array {
  const copy = bytes.slice();
  new DataView(copy.buffer).setUint16(at, value, true);
  return copy;
}
function with4(bytes: Uint8Array, at: number, value: number): Uint8Array {
  const copy = bytes.slice();
  new DataView(copy.buffer).setUint32(at, value, true);
  return copy;
}
const CENTRAL = [0x50, 0x4b, 1, 2];
const central = (bytes: Uint8Array, n = 0): number => {
  const found = [...bytes].flatMap((_, i) => (CENTRAL.every((b, k) => bytes[i + k] === b) ? [i] : []));
  return found[n]!;
};
const refusal = (bytes: Uint8Array) =>
  opened(bytes)
    .then(async (source) => {
      for (const path of await source.list()) await source.read(path);
      return 'read';
    })
    .catch((error: { diagnostic?: { code: string } }) => error.diagnostic?.code);

describe('a zip', () => {
  it.each([0, 6] as const)('is read as a folder of files (level %d)', async (level) => {
    const source = await opened(zipSync(FILES, { level }), { 'beside.png': text('beside') });
    expect(await source.list()).toEqual(['set.zip/set/scene.usda', 'set.zip/set/tex/wood.png']);
    expect(entryOf(await source.list())).toBe('set.zip/set/scene.usda');
    expect(await source.read('set.zip/set/scene.usda')).toEqual(FILES['set/scene.usda']);
    expect(await source.read('set.zip/elsewhere/wood.png')).toEqual(text('wood'));
    expect(await source.read('set.zip/../beside.png')).toEqual(text('beside'));
    expect(await source.read('set.zip/none.png')).toBeUndefined();
  });

  it('round-trips any files', () =>
    fc.assert(
      fc.asyncProperty(fc.uint8Array({ maxLength: 5000 }), fc.integer({ min: 0, max: 9 }), async (bytes, level) => {
        const source = await opened(zipSync({ a: bytes }, { level: level as 0 | 9 }));
        expect(await source.read('set.zip/a')).toEqual(bytes);
      }),
      { numRuns: 30 },
    ));

  it('has entry paths in USD’s notation', () => {
    expect(splitArchive('a/set.zip')).toEqual({ archive: 'a/set.zip' });
    expect(splitArchive('a/set.ZIP[b/c.usda]')).toEqual({ archive: 'a/set.ZIP', inner: 'b/c.usda' });
    expect(splitArchive('a/set.usdz')).toBeUndefined();
  });
});

describe('an invalid zip', () => {
  const good = zipSync({ 'a.usda': text('x'.repeat(5000)), 'b.usda': text('y'.repeat(5000)) });
  const first = central(good);
  const second = central(good, 1);

  it.each([
    ['leads out of it', zipSync({ '../a.usda': text('x') }), 'zip.path'],
    ['is absolute', zipSync({ '/etc/a.usda': text('x') }), 'zip.path'],
    ['is absolute on Windows', zipSync({ 'C:\\a.usda': text('x') }), 'zip.path'],
    ['has a name twice', zipSync({ 'a.usda': text('x'), './a.usda': text('y') }), 'zip.duplicate'],
    ['is encrypted', with2(good, first + 8, 1), 'zip.encrypted'],
    ['is packed by bzip2', with2(good, first + 10, 12), 'zip.method'],
    ['claims what deflate cannot', with4(good, first + 24, 2 ** 31), 'zip.bomb'],
    ['holds more than it says', with4(good, first + 24, 100), 'zip.damaged'],
    ['has another check sum', with4(good, first + 16, 1), 'zip.damaged'],
    ['shares bytes with another file', with4(good, second + 42, 0), 'zip.bomb'],
    ['is zip64', with4(good, good.length - 6, 0xffffffff), 'zip.zip64'],
    ['is one part of several', with2(good, good.length - 18, 1), 'zip.parts'],
    ['is no zip', text('no zip at all'), 'zip.damaged'],
    ['is empty', new Uint8Array(0), 'zip.damaged'],
  ])('%s', async (_, bytes, code) => {
    expect(await refusal(bytes)).toBe(code);
  });

  it('a bomb of zeros is rejected before unpacking', async () => {
    const zeros = zipSync({ a: new Uint8Array(2 ** 24) }, { level: 9 });
    const from = zeros.subarray(0, central(zeros));
    const entry = zeros.slice(central(zeros), zeros.length - 22);
    const size = from.length;
    const bomb = new Uint8Array(20 * (from.length + entry.length) + 22);
    const view = new DataView(bomb.buffer);
    for (let i = 0; i < 20; i++) {
      bomb.set(from, i * size);
      bomb.set(entry, 20 * size + i * entry.length);
      view.setUint32(20 * size + i * entry.length + 42, i * size, true);
      bomb[20 * size + i * entry.length + 46] = 97 + i;
    }
    bomb.set(zeros.subarray(zeros.length - 22), bomb.length - 22);
    for (const at of [8, 10]) view.setUint16(bomb.length - 22 + at, 20, true);
    view.setUint32(bomb.length - 10, 20 * entry.length, true);
    view.setUint32(bomb.length - 6, 20 * size, true);
    expect(await refusal(bomb)).toBe('zip.bomb');
  });

  it('truncated or changed anywhere is rejected or read correctly', async () => {
    const whole = zipSync(FILES, { level: 6 });
    await fc.assert(
      fc.asyncProperty(fc.nat(whole.length - 1), fc.nat(255), fc.boolean(), async (at, value, cut) => {
        const bytes = cut ? whole.slice(0, at) : whole.slice();
        if (!cut) bytes[at] = value;
        expect(await refusal(bytes)).toMatch(/^(read|zip\..*)$/);
      }),
      { numRuns: 300 },
    );
  });

  it('only its directory is read until a file is requested', async () => {
    const bytes = zipSync({ a: new Uint8Array(1_000_000) }, { level: 0 });
    let read = 0;
    const part = async (from: number, to: number) => {
      read += to - from;
      return bytes.subarray(from, to);
    };
    await readZipDirectory({ size: bytes.length, read: part }, 'a.zip');
    expect(read).toBeLessThan(100_000);
  });
});
