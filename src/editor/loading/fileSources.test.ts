import { afterEach, describe, expect, it, vi } from 'vitest';
import { localSource, splitAddress, urlSource } from './fileSources.ts';

const text = async (bytes: Promise<Uint8Array | undefined>) => new TextDecoder().decode(await bytes);

describe('user files', () => {
  const files = new Map([
    ['set/scene.usda', new Blob(['scene'])],
    ['set/textures/wood.png', new Blob(['wood'])],
    ['a/same.png', new Blob(['1'])],
    ['b/same.png', new Blob(['2'])],
  ]);
  const source = localSource(files, () => {});

  it('are found by path, or by name if folders were flattened', async () => {
    expect(await text(source.read('./set/scene.usda'))).toBe('scene');
    expect(await text(source.read('set/../set/textures/wood.png'))).toBe('wood');
    expect(await text(source.read('elsewhere/wood.png'))).toBe('wood');
    expect(await source.list?.()).toHaveLength(4);
  });

  it('can be opened for partial reads', async () => {
    const opened = await source.open?.('elsewhere/wood.png');
    expect(opened?.size).toBe(4);
    expect(opened?.file.handle).toBe(files.get('set/textures/wood.png'));
    expect(await source.open?.('gone.png')).toBeUndefined();
  });

  it('are not found by an ambiguous name', async () => {
    expect(await source.read('same.png')).toBeUndefined();
    expect(await source.read('gone.png')).toBeUndefined();
  });
});

describe('files on the server', () => {
  it('have a folder URL and a name', () => {
    const address = new URL('http://host/a/b%20c/my%20scene.usda?x=1');
    expect(splitAddress(address)).toEqual({ base: 'http://host/a/b%20c/', entry: 'my scene.usda' });
  });

  afterEach(() => vi.unstubAllGlobals());

  it('are read beside the entry, with progress', async () => {
    const asked: string[] = [];
    vi.stubGlobal('fetch', async (url: URL) => {
      asked.push(url.href);
      return new Response('hello', { headers: { 'content-length': '5' } });
    });
    const reports: number[][] = [];
    const source = urlSource('http://host/examples/', (...numbers) => reports.push(numbers));
    expect(await text(source.read('textures/a.png'))).toBe('hello');
    expect(asked).toEqual(['http://host/examples/textures/a.png']);
    expect(reports.at(-1)).toEqual([5, 5]);
  });

  it('that are missing are undefined, and a failing server is an error', async () => {
    const source = urlSource('http://host/', () => {});
    vi.stubGlobal('fetch', async () => new Response('', { status: 404 }));
    expect(await source.read('a.usda')).toBeUndefined();
    vi.stubGlobal('fetch', async () => new Response('', { status: 500, statusText: 'broken' }));
    await expect(source.read('a.usda')).rejects.toThrow(/a\.usda.*500 broken/);
  });
});
