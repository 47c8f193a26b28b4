import fc from 'fast-check';
import { decode } from 'fast-png';
import { zlibSync } from 'fflate';
import { encode as encodeJpeg } from 'jpeg-js';
import { describe, expect, it } from 'vitest';
import { concat } from '../../../tests/support/mp4Kit.ts';
import { MessageError } from '../../messages/messageError.ts';
import type { SphericalPicture } from '../../scene/view/sphericalPicture.ts';
import { encodePng } from '../image/encodePng.ts';
import { type ExrImage, writeExr } from '../image/exr.ts';
import { pngChunk, pngChunks, withPngChunks } from '../image/pngChunks.ts';
import { withPngText } from '../image/pngText.ts';
import { readExr } from '../image/readExr.ts';
import { memoryFile } from '../zip/zipSource.ts';
import { sphericalOf } from './sphericalOf.ts';
import { sphericalExr, withSphericalPng } from './sphericalPictures.ts';

const FULL: SphericalPicture = { projection: 'equirectangular', stereo: 'none' };
const PNG = encodePng(
  8,
  4,
  Uint8Array.from({ length: 128 }, (_, i) => i),
);
const told = (bytes: Uint8Array) => sphericalOf(memoryFile(bytes), 'a.picture');
const text = (words: string) => new TextEncoder().encode(words);

/** A packet as Google's documentation shows it: an element for each property. */
const packet = (properties: Readonly<Record<string, string | number>>) =>
  text(`<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">
    <rdf:Description rdf:about="" xmlns:GPano="http://ns.google.com/photos/1.0/panorama/">
      ${Object.entries(properties)
        .map(([name, value]) => `<GPano:${name}>${value}</GPano:${name}>`)
        .join('\n      ')}
    </rdf:Description></rdf:RDF></x:xmpmeta>`);
const CROPPED = {
  UsePanoramaViewer: 'True',
  ProjectionType: 'equirectangular',
  PoseHeadingDegrees: '90.0',
  CroppedAreaImageWidthPixels: 3000,
  CroppedAreaImageHeightPixels: 1500,
  FullPanoWidthPixels: 4000,
  FullPanoHeightPixels: 2000,
  CroppedAreaLeftPixels: 1000,
  CroppedAreaTopPixels: 250,
};

const PLAIN_JPEG = Uint8Array.from(encodeJpeg({ width: 8, height: 4, data: new Uint8Array(128) }, 50).data);

function jpegWith(xmp: Uint8Array): Uint8Array {
  const name = text('http://ns.adobe.com/xap/1.0/\0');
  const size = 2 + name.length + xmp.length;
  const segment = concat(Uint8Array.of(0xff, 0xff, 0xe1, size >> 8, size & 255), name, xmp);
  return concat(PLAIN_JPEG.subarray(0, 2), segment, PLAIN_JPEG.subarray(2));
}

describe('a PNG', () => {
  it('says how it covers the sphere, beside its other texts and the same pixels', async () => {
    const marked = withSphericalPng(withPngText(PNG, { worldTime: '6.5 s' }), FULL);
    expect(await told(marked)).toEqual(FULL);
    const read = decode(marked, { checkCrc: true });
    expect(read.text).toEqual({ worldTime: '6.5 s' });
    expect(read.data).toEqual(decode(PNG).data);
  });

  it('has the size of one eye’s view, of what is there and of the full sphere', () => {
    const xmp = new TextDecoder().decode(
      withSphericalPng(PNG, {
        projection: 'equirectangular',
        stereo: 'top-bottom',
        crop: { left: 0.25, right: 0.25, top: 0, bottom: 0.5 },
        heading: Math.PI / 2,
      }),
    );
    for (const property of [
      'GPano:CroppedAreaImageWidthPixels="8"',
      'GPano:CroppedAreaImageHeightPixels="2"',
      'GPano:FullPanoWidthPixels="16"',
      'GPano:FullPanoHeightPixels="4"',
      'GPano:CroppedAreaLeftPixels="4"',
      'GPano:CroppedAreaTopPixels="0"',
      'GPano:PoseHeadingDegrees="90"',
      'GPano:UsePanoramaViewer="True"',
      'GSpherical:StereoMode="top-bottom"',
    ])
      expect(xmp).toContain(property);
  });

  it('has one packet, that of its last mark', async () => {
    const twice = withSphericalPng(withSphericalPng(PNG, FULL), { projection: 'cubemap', stereo: 'none' });
    expect([...pngChunks(twice)].map(({ type }) => type)).toEqual(['IHDR', 'iTXt', 'IDAT', 'IEND']);
    expect(await told(twice)).toEqual({ projection: 'cubemap', stereo: 'none' });
  });

  it('reads what it writes, whatever it is', () => {
    const margin = fc.nat(50);
    const stereo = fc.constantFrom('none' as const, 'top-bottom' as const, 'left-right' as const);
    const degrees = fc.integer({ min: 0, max: 359_999 }).map((n) => n / 1000);
    return fc.assert(
      fc.asyncProperty(
        stereo,
        margin,
        margin,
        margin,
        margin,
        degrees,
        async (layout, left, right, top, bottom, at) => {
          const [width, height] = [
            left + right + (layout === 'left-right' ? 4 : 8),
            top + bottom + (layout === 'top-bottom' ? 2 : 4),
          ];
          const crop = { left: left / width, right: right / width, top: top / height, bottom: bottom / height };
          const isWhole = left + right + top + bottom === 0;
          const picture = { projection: 'equirectangular', stereo: layout, ...(!isWhole && { crop }) } as const;
          const found = await told(withSphericalPng(PNG, { ...picture, heading: (at * Math.PI) / 180 }));
          expect(found).toEqual({ ...picture, heading: expect.closeTo((at * Math.PI) / 180, 8) });
        },
      ),
    );
  });

  it('with a compressed packet is read', async () => {
    const chunk = pngChunk('iTXt', concat(text('XML:com.adobe.xmp\0\x01\0en\0\0'), zlibSync(packet(CROPPED))));
    expect(await told(withPngChunks(PNG, [chunk]))).toMatchObject({
      crop: { left: 0.25, right: 0, top: 0.125, bottom: 0.125 },
    });
  });

  it('whose packet would unpack to gigabytes is refused', async () => {
    const bomb = zlibSync(new Uint8Array(2 ** 22).fill(32));
    const chunk = pngChunk('iTXt', concat(text('XML:com.adobe.xmp\0\x01\0\0\0'), bomb));
    await expect(told(withPngChunks(PNG, [chunk]))).rejects.toBeInstanceOf(MessageError);
  });

  it('is what is marked', () => {
    expect(() => withSphericalPng(text('hello, world'), FULL)).toThrow('this is no PNG');
    expect(() => withSphericalPng(PNG, { ...FULL, heading: Number.NaN })).toThrow('NaN is no heading');
  });
});

describe('a JPEG', () => {
  it('of a camera is read', async () => {
    expect(await told(jpegWith(packet(CROPPED)))).toEqual({
      projection: 'equirectangular',
      stereo: 'none',
      crop: { left: 0.25, right: 0, top: 0.125, bottom: 0.125 },
      heading: Math.PI / 2,
    });
  });

  it.each([
    ['without a packet', PLAIN_JPEG],
    ['of something else', jpegWith(packet({ CaptureSoftware: 'Camera' }))],
    ['to be shown flat', jpegWith(packet({ ...CROPPED, UsePanoramaViewer: 'False' }))],
  ])('%s is flat', async (_, jpeg) => {
    expect(await told(jpeg)).toBeUndefined();
  });

  it.each([
    ['another projection', { ProjectionType: 'cylindrical' }, 'a.picture: the projection cylindrical is not read'],
    ['an area outside', { ...CROPPED, CroppedAreaLeftPixels: 1001 }, '3000 × 1500 pixels at (1001, 250) is not in'],
    ['no number', { ...CROPPED, FullPanoWidthPixels: 'wide' }, 'GPano:FullPanoWidthPixels is “wide”'],
    ['tags that do not close', { ProjectionType: '<b>' }, 'a.picture: the XML is not well-formed'],
    ['entities', { ProjectionType: '&lol9;' }, 'the XML is not well-formed'],
    ['deep elements', { ProjectionType: '<b>'.repeat(70) }, 'nested more than 64 deep'],
  ])('with %s is refused', async (_, properties, words) => {
    await expect(told(jpegWith(packet(properties)))).rejects.toThrow(words);
  });
});

describe('an EXR', () => {
  const channels = [{ name: 'Y', type: 'half' as const, data: new Float32Array(32) }];
  const exr = (picture: SphericalPicture, size = { width: 8, height: 4 }, more: Partial<ExrImage> = {}) => {
    const told = sphericalExr(picture, size);
    return writeExr({ ...size, channels, ...told, attributes: { ...told.attributes, scene: 'Cube' }, ...more });
  };

  it('is the latitude–longitude map of OpenEXR where it is the full sphere, in one view, twice as wide as high', () => {
    const envmap = (picture: SphericalPicture, size = { width: 8, height: 4 }) =>
      readExr(exr(picture, size), 'a').envmap;
    expect(envmap(FULL)).toBe('latlong');
    expect(envmap(FULL, { width: 4, height: 8 })).toBeUndefined();
    expect(envmap({ ...FULL, stereo: 'top-bottom' })).toBeUndefined();
    expect(envmap({ projection: 'cubemap', stereo: 'none' })).toBeUndefined();
    const crop = { left: 0, right: 0.5, top: 0, bottom: 0 };
    expect(envmap({ projection: 'equirectangular', stereo: 'none', crop })).toBeUndefined();
  });

  it('says the rest in XMP, beside its other texts', async () => {
    for (const picture of [
      FULL,
      { projection: 'cubemap', stereo: 'top-bottom' },
      { projection: 'equirectangular', stereo: 'left-right', crop: { left: 0, right: 0.5, top: 0.5, bottom: 0 } },
    ] satisfies SphericalPicture[]) {
      expect(await told(exr(picture))).toEqual(picture);
      expect(readExr(exr(picture), 'a').attributes?.scene).toBe('Cube');
    }
  });

  it('of other programs is read by its envmap, and is flat without', async () => {
    expect(await told(exr(FULL, undefined, { attributes: {} }))).toEqual(FULL);
    expect(await told(writeExr({ width: 8, height: 4, channels }))).toBeUndefined();
    const cube = exr(FULL, undefined, { attributes: {}, envmap: 'cube' });
    await expect(told(cube)).rejects.toThrow('a.picture: a cube map in a column is not read');
  });
});

it.each([
  ['nothing', new Uint8Array(0)],
  ['text', text('#usda 1.0\n(\n)\n')],
  ['an AVIF', text('\0\0\0\x20ftypavif\0\0\0\0')],
])('%s says nothing', async (_, bytes) => {
  expect(await told(bytes)).toBeUndefined();
});

describe('damaged pictures', () => {
  const channels = [{ name: 'Y', type: 'half' as const, data: new Float32Array(32) }];
  const size = { width: 8, height: 4 };
  it.each([
    ['PNG', withSphericalPng(PNG, FULL)],
    ['JPEG', jpegWith(packet(CROPPED))],
    ['EXR', writeExr({ ...size, channels, ...sphericalExr(FULL, size) })],
  ])('%s: cut off or changed anywhere is read or refused', async (_, bytes) => {
    const attempt = (broken: Uint8Array) =>
      told(broken).then(
        () => undefined,
        (error) => (error instanceof MessageError ? undefined : error),
      );
    for (let n = 0; n < bytes.length; n++) expect(await attempt(bytes.subarray(0, n))).toBeUndefined();
    for (let i = 0; i < bytes.length; i++)
      for (const value of [0, 255, bytes[i] ^ (1 << (i % 8))])
        expect(await attempt(bytes.with(i, value))).toBeUndefined();
  });
});
