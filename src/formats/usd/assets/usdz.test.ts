import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { memorySource } from '../../files/fileSource.ts';
import { readUsd } from '../read.ts';
import { packUsdz } from '../write/packUsdz.ts';

const fixture = (name: string): Uint8Array =>
  new Uint8Array(readFileSync(new URL(`../fixtures/${name}`, import.meta.url)));

describe('packages', () => {
  const layer = new TextEncoder().encode('#usda 1.0\ndef Cube "A"\n{\n}\n');
  const refusal = (bytes: Uint8Array): Promise<string> =>
    readUsd(memorySource({ 'a.usdz': bytes }), 'a.usdz').then(
      () => 'read',
      (e: Error) => e.message,
    );
  const patched = (offset: number, value: number): Uint8Array => {
    const bytes = packUsdz(new Map([['a.usda', layer]]));
    const directory = new DataView(bytes.buffer).getUint32(bytes.length - 6, true);
    bytes[directory + offset] = value;
    return bytes;
  };

  it('can be opened', async () => {
    const scene = await readUsd(memorySource({ 'a.usdz': packUsdz(new Map([['a.usda', layer]])) }), 'a.usdz');
    expect(scene.objects.map((o) => o.path)).toEqual(['/A']);
  });

  it('are rejected if encrypted, compressed or with paths outside', async () => {
    expect(await refusal(patched(8, 1))).toContain('a.usda in it is encrypted');
    expect(await refusal(patched(10, 8))).toContain('compressed (method 8), which usdz does not allow');
    for (const path of ['../a.usda', '/a.usda', 'b/../../a.usda', 'C:\\a.usda', '..\\a.usda'])
      expect(await refusal(packUsdz(new Map([[path, layer]])))).toContain('leads out of it');
  });

  it('may hold a package that holds the layer, but not without end', async () => {
    const nested = (depth: number): Uint8Array =>
      packUsdz(new Map([depth === 0 ? ['a.usda', layer] : ['b.usdz', nested(depth - 1)]]));
    const scene = await readUsd(memorySource({ 'a.usdz': nested(3) }), 'a.usdz');
    expect(scene.objects.map((o) => o.path)).toEqual(['/A']);
    expect(await refusal(nested(9))).toContain('packages are nested more than 4 deep in it');
  });

  it('without a layer are rejected', async () => {
    expect(await refusal(packUsdz(new Map([['a.png', layer]])))).toContain('holds no USD layer');
  });

  it('may contain a crate, which is named if damaged', async () => {
    const crate = new Uint8Array(readFileSync(new URL('../crate/fixtures/meshes.usdc', import.meta.url)));
    const read = async (name: string, bytes: Uint8Array) => readUsd(memorySource({ [name]: bytes }), name);
    const packed = await read('a.usdz', packUsdz(new Map([['a.usdc', crate]])));
    expect(packed.objects).toEqual((await read('a.usda', fixture('meshes.usda'))).objects);
    expect(packed.objects).toEqual((await read('a.usd', crate)).objects);
    const short = packUsdz(new Map([['a.usdc', crate.subarray(0, 100)]]));
    expect(await refusal(short)).toMatch(/^a\.usdz\[a\.usdc\] \(.*the file ends at byte 100; it is cut off or damaged/);
  });
});
