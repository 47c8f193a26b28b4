import { describe, expect, it } from 'vitest';
import { FOUR_PIXELS_WEBP, PINK_WEBP } from '../../../tests/formats/pictures.ts';
import { GltfBuilder } from '../../../tests/support/gltfBuilder.ts';
import { solidKtx2 } from '../../../tests/support/ktx2Kit.ts';
import { memorySource } from '../../formats/files/fileSource.ts';
import { readGltf } from '../../formats/gltf/index.ts';
import { encodePng } from '../../formats/image/encodePng.ts';
import { decodeForeign, foreignKind } from '../../formats/image/foreignPictures.ts';
import type { Scene } from '../../scene/types.ts';
import { decodePicture } from './decodePicture.ts';

/** Made by ffmpeg 5.1 (libwebp, libaom): four pixels without loss; 16 × 16 of one colour. */
const bytesOf = (text: string) => new Uint8Array(Buffer.from(text, 'base64'));
const LOSSLESS = FOUR_PIXELS_WEBP;
const LOSSY = PINK_WEBP;
const AVIF = bytesOf(
  'AAAAIGZ0eXBhdmlmAAAAAGF2aWZtaWYxbWlhZk1BMUEAAAD5bWV0YQAAAAAAAAAvaGRscgAAAAAAAAAAcGljdAAAAAAAAAAAAAAAAFBpY3R1cmVIYW5kbGVyAAAAAA5waXRtAAAAAAABAAAAHmlsb2MAAAAARAAAAQABAAAAAQAAASEAAAAcAAAAKGlpbmYAAAAAAAEAAAAaaW5mZQIAAAAAAQAAYXYwMUNvbG9yAAAAAGppcHJwAAAAS2lwY28AAAAUaXNwZQAAAAAAAAAQAAAAEAAAABBwaXhpAAAAAAMICAgAAAAMYXYxQ4EgAAAAAAATY29scm5jbHgAAgACAAIAAAAAF2lwbWEAAAAAAAAAAQABBAECgwQAAAAkbWRhdAoFOAz/2wQyExKAAABAAAAAAFe2/eyCTVlud8A=',
);
const PIXELS = [255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 200, 100, 50, 128];
const BLUE = encodePng(1, 1, Uint8Array.of(0, 0, 255, 255));

const decoded = (bytes: Uint8Array) => decodeForeign(bytes, foreignKind(bytes)!, 'it', decodePicture);

describe('WebP and AVIF', () => {
  it('without loss: the pixels as they were, alpha not multiplied', async () => {
    expect(await decoded(LOSSLESS)).toEqual({ width: 2, height: 2, data: Uint8Array.from(PIXELS) });
  });

  it.each([
    ['WebP', LOSSY],
    ['AVIF', AVIF],
  ])('with loss, %s: within 3 of 255', async (kind, bytes) => {
    expect(foreignKind(bytes)).toBe(kind);
    const { width, height, data } = await decoded(bytes);
    expect([width, height]).toEqual([16, 16]);
    for (let i = 0; i < data.length; i++)
      expect(Math.abs(data[i]! - [200, 60, 120, 255][i % 4]!)).toBeLessThanOrEqual(3);
  });

  it('too large and damaged ones are refused with the reason, before and after decoding', async () => {
    const large = LOSSLESS.slice();
    large.set([0xff, 0xff, 0xff, 0x0f], 21);
    await expect(decoded(large)).rejects.toThrow(/it: the picture is 16384 × 16384 pixels/);
    const wide = AVIF.slice();
    wide.set([0, 1, 0, 0], Buffer.from(AVIF).indexOf('ispe') + 8);
    await expect(decoded(wide)).rejects.toThrow(/it: the picture is 65536 × 16 pixels/);
    await expect(decoded(LOSSY.slice(0, 40))).rejects.toThrow(
      /it: the WebP is damaged or cut off \(.+\); export it again/,
    );
    await expect(decoded(LOSSY.slice(0, 20))).rejects.toThrow(/it: the WebP is damaged or cut off \(no size\)/);
    await expect(decoded(AVIF.slice(0, 200))).rejects.toThrow(/it: the AVIF is damaged or cut off/);
  });
});

/** A triangle whose texture has `extensions`, and PNG beside where `own` says so. */
async function scene(
  images: Record<string, Uint8Array>,
  extensions: object,
  own?: number,
  host = true,
): Promise<Scene> {
  const kit = new GltfBuilder();
  const uvs = kit.values('VEC2', [0, 0, 1, 0, 0, 1]);
  const material = kit.doc
    .createMaterial('Painted')
    .setBaseColorTexture(kit.doc.createTexture().setImage(BLUE).setMimeType('image/png'));
  kit.scene.addChild(kit.meshNode('A', kit.triangle().setAttribute('TEXCOORD_0', uvs).setMaterial(material)));
  const glb = await kit.glb();
  const length = new DataView(glb.buffer, glb.byteOffset).getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + length)));
  Object.assign(json, {
    images: Object.keys(images).map((uri) => ({ uri })),
    textures: [{ extensions, ...(own !== undefined && { source: own }) }],
    extensionsUsed: Object.keys(extensions),
    buffers: [{ ...json.buffers[0], uri: 'a.bin' }],
  });
  const files = {
    'a.gltf': new TextEncoder().encode(JSON.stringify(json)),
    'a.bin': glb.slice(28 + length),
    ...images,
  };
  return readGltf(memorySource(files), 'a.gltf', host ? { decodePicture } : {});
}
const texture = ({ materials }: Scene) => materials.find(({ name }) => name === 'Painted')!.baseColorTexture;

describe('glTF textures', () => {
  it.each([
    ['EXT_texture_webp', { 'a.webp': LOSSLESS }],
    ['EXT_texture_avif', { 'a.avif': AVIF }],
  ])('%s is read where the host decodes it', async (name, images) => {
    const read = await scene(images, { [name]: { source: 0 } });
    expect(read.diagnostics).toEqual([]);
    const data = texture(read)!.data as Uint8Array;
    if (name === 'EXT_texture_webp') expect([...data.subarray(0, 3)]).toEqual([255, 0, 0]);
    else expect(Math.abs(data[0]! - 200)).toBeLessThan(4);
  });

  it('one that cannot be read leaves the picture beside it, and is told', async () => {
    const images = { 'a.png': BLUE, 'a.webp': LOSSLESS.slice(0, 24) };
    const read = await scene(images, { EXT_texture_webp: { source: 1 } }, 0);
    expect([...texture(read)!.data.subarray(0, 3)]).toEqual([0, 0, 255]);
    expect(read.diagnostics).toMatchObject([
      { code: 'file.unreadable-texture', place: { values: ['a.gltf', 'a.webp'] } },
    ]);
  });

  it('a WebP that no extension names is read too', async () => {
    expect([...texture(await scene({ 'a.webp': LOSSLESS }, {}, 0))!.data.subarray(0, 3)]).toEqual([255, 0, 0]);
  });

  it('KTX2 needs no host, and is what an extension, or nothing, names', async () => {
    const ktx2 = { 'a.ktx2': solidKtx2(200, 10, 20, 255) };
    for (const read of [
      await scene(ktx2, { KHR_texture_basisu: { source: 0 } }, undefined, false),
      await scene({ ...ktx2, 'a.png': BLUE }, { KHR_texture_basisu: { source: 0 } }, 1),
      await scene(ktx2, {}, 0, false),
    ]) {
      expect(read.diagnostics).toEqual([]);
      expect([...texture(read)!.data.subarray(0, 4)]).toEqual([200, 10, 20, 255]);
    }
  });

  it('a KTX2 that is damaged leaves the picture beside it, and is told', async () => {
    const images = { 'a.png': BLUE, 'a.ktx2': solidKtx2(200, 10, 20, 255).slice(0, 200) };
    const read = await scene(images, { KHR_texture_basisu: { source: 1 } }, 0, false);
    expect([...texture(read)!.data.subarray(0, 3)]).toEqual([0, 0, 255]);
    expect(read.diagnostics).toMatchObject([
      { code: 'file.unreadable-texture', place: { values: ['a.gltf', 'a.ktx2'] } },
    ]);
  });

  it('without a host that decodes, it is told what is missing', async () => {
    const read = await scene({ 'a.webp': LOSSLESS }, { EXT_texture_webp: { source: 0 } }, undefined, false);
    expect(texture(read)).toBeUndefined();
    expect(read.diagnostics.map(({ code }) => code)).toEqual(['gltf.ignored-extension', 'file.unreadable-texture']);
  });
});
