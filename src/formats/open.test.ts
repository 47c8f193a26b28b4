import { describe, expect, it } from 'vitest';
import { InputError } from '../scene/types.ts';
import { extensionOf, memorySource, normalizePath, resolvePath } from './files/fileSource.ts';
import { openScene } from './open.ts';

const text = (value: string): Uint8Array => new TextEncoder().encode(value);
const empty = text('{"asset":{"version":"2.0"}}');

describe('openScene', () => {
  it('chooses the reader by the extension, case-insensitively', async () => {
    const scene = await openScene(memorySource({ 'a/Empty.GLTF': empty }), './a/b/../Empty.GLTF');
    expect([scene.name, scene.objects.length, scene.upAxis]).toEqual(['Empty', 0, 'Y']);
  });

  it.each([
    ['a.blend', /^a\.blend: \.blend is not a scene format that can be opened; .*glTF \(\.gltf, \.glb\).* can$/],
    ['a.slowlight.json', /^a\.slowlight\.json: this is a project, not a scene; render, .* \?project=/],
    ['scene', /^scene: the name has no extension; /],
    ['b.gltf', /^b\.gltf: no such file; there is empty\.glb, good\.gltf$/],
    ['empty.glb', /^empty\.glb: the file is empty \(0 bytes\); export or copy it again$/],
  ])('%s: rejected with a remedy', async (path, message) => {
    const files = memorySource({ 'a.blend': empty, 'good.gltf': empty, 'empty.glb': new Uint8Array(0), scene: empty });
    const error = await openScene(files, path).catch((thrown) => thrown);
    expect(error).toBeInstanceOf(InputError);
    expect(error.message).toMatch(message);
  });

  it('has a remedy where files cannot be listed', async () => {
    const nowhere = openScene({ read: async () => undefined }, 'b.gltf');
    await expect(nowhere).rejects.toThrow(/^b\.gltf: no such file; check its name, and where it is$/);
  });

  it('limits the total size of a scene’s files', async () => {
    const json = { asset: { version: '2.0' }, buffers: [{ byteLength: 900, uri: 'b.bin' }] };
    const files = memorySource({ 'a.gltf': text(JSON.stringify(json)), 'b.bin': new Uint8Array(900) });
    await expect(openScene(files, 'a.gltf', { maxBytes: 900 })).rejects.toThrow(
      /^b\.bin: with this file the scene takes \d+ bytes/,
    );
    expect((await openScene(files, 'a.gltf', { maxBytes: 1000 })).objects).toEqual([]);
  });

  it('turns a failing source into an InputError', async () => {
    const files = { read: async (path: string) => (path === 'a.gltf' ? text('{') : undefined) };
    await expect(openScene(files, 'a.gltf')).rejects.toBeInstanceOf(InputError);
  });
});

describe('paths', () => {
  it('are normalised and resolved', () => {
    expect(normalizePath('./a//b/../c\\d.png')).toBe('a/c/d.png');
    expect(normalizePath('../../x')).toBe('../../x');
    expect(normalizePath('/a/./b')).toBe('/a/b');
    expect(resolvePath('scenes/car/car.gltf', '../textures/red.png')).toBe('scenes/textures/red.png');
    expect(resolvePath('car.gltf', 'red.png')).toBe('red.png');
    expect(resolvePath('scenes/car.usda', '/abs/red.png')).toBe('/abs/red.png');
    expect([extensionOf('a.b/C.USDA'), extensionOf('a.b/c'), extensionOf('.glb')]).toEqual(['usda', '', '']);
  });
});
