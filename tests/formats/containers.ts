import { zipSync } from 'fflate';
import { encode } from 'jpeg-js';
import { expect } from 'vitest';
import { encodePng } from '../../src/formats/image/encodePng.ts';
import { type ClaimGroup, type Files, leftOut, read, refused } from './claim.ts';
import { withMaterial } from './obj.ts';
import { PIXEL, WEBP } from './pictures.ts';

const shown = (bytes: Uint8Array): Files => withMaterial('map_Kd a.png', { 'a.png': bytes });

/** Changes the width in the header. */
function wider(png: Uint8Array): Uint8Array {
  const out = png.slice();
  new DataView(out.buffer).setUint32(16, 2 ** 20);
  return out;
}

const JPEG = new Uint8Array(encode({ width: 8, height: 8, data: new Uint8Array(256).fill(255) }, 90).data);

/** Magic numbers of unsupported image formats. */
const STRANGE = [
  WEBP,
  ...['    ftypavif    ', '\xabKTX 20\xbb', '\x76\x2f\x31\x01\x02', '#?RADIANCE\n'].map((start) =>
    Uint8Array.from(start, (c) => c.charCodeAt(0)),
  ),
];

const pictures: ClaimGroup = {
  title: 'Pictures',
  rows: [
    read(
      'PNG: every colour type and depth, interlaced or not',
      '8-bit RGBA',
      shown(encodePng(2, 1, new Uint8Array(8).fill(255))),
      (s) => expect(s.materials[0].baseColorTexture).toMatchObject({ width: 2, height: 1 }),
    ),
    read(
      'JPEG: baseline and progressive',
      'the same; distinguished from PNG by content, whatever the file is called',
      shown(JPEG),
      (s) => expect(s.materials[0].baseColorTexture?.width).toBe(8),
    ),
    leftOut(
      'OpenEXR and Radiance except in USD, KTX2, WebP and AVIF except in glTF',
      'reported with what it is',
      'file.unreadable-texture',
      STRANGE.map(shown),
    ),
    leftOut(
      'a picture that is damaged, truncated or empty',
      'reported',
      'file.unreadable-texture',
      [PIXEL.slice(0, 40), JPEG.slice(0, 90), new Uint8Array(0)].map(shown),
    ),
    leftOut(
      'a picture with more pixels than the limit',
      'reported before memory is allocated for it',
      'file.unreadable-texture',
      shown(wider(PIXEL)),
    ),
  ],
};

const text = (content: string): Uint8Array => new TextEncoder().encode(content);
const CUBE = text('#usda 1.0\n( metersPerUnit = 1 )\ndef Cube "A" {}');
const zip = (files: Record<string, Uint8Array>): Files => ({ 'set.zip': zipSync(files) });
/** Sets a byte in the first file's local header and in its directory entry. */
function changed(local: number, central: number, value: number): Files {
  const bytes = zipSync({ 'a.usda': CUBE });
  bytes[local] = value;
  bytes[new DataView(bytes.buffer).getUint32(bytes.length - 6, true) + central] = value;
  return { 'set.zip': bytes };
}

const archives: ClaimGroup = {
  title: 'Archives (`.zip`)',
  rows: [
    read(
      'stored and deflated files, also in folders',
      'treated as a folder; of several scenes the least deeply nested is opened, USD before glTF before meshes, or the one given as `set.zip[a/scene.usda]`',
      zip({ 'b/b.usda': text('no'), 'a.usda': CUBE }),
      (s) => expect(s.objects.map(({ path }) => path)).toEqual(['/A']),
    ),
    refused('a damaged or truncated archive', 'with the location', 'zip.damaged', {
      'set.zip': zipSync({ 'a.usda': CUBE }).slice(0, 60),
    }),
    refused('a path that leads out of the archive', 'with the path', 'zip.path', zip({ '../a.usda': CUBE })),
    refused('password-protected files', 'with the file', 'zip.encrypted', changed(6, 8, 1)),
    refused('other compression methods', 'with the file and the method', 'zip.method', changed(8, 10, 12)),
    refused('an archive that claims to unpack to far more than its data can hold', 'with the sizes', 'zip.bomb', {
      'set.zip': bomb(),
    }),
  ],
};

/** A zip that claims to hold a gigabyte. */
function bomb(): Uint8Array {
  const bytes = zipSync({ 'a.usda': CUBE });
  const view = new DataView(bytes.buffer);
  view.setUint32(view.getUint32(bytes.length - 6, true) + 24, 2 ** 30, true);
  return bytes;
}

const whole: ClaimGroup = {
  title: 'Any file',
  rows: [
    refused('an empty file', 'reported', 'file.empty', { 'a.usda': '' }),
    refused('an unknown file type', 'with the types that can be opened', 'file.unknown-format', { 'a.fbx': 'x' }),
    refused('a line longer than any in a valid file', 'with the location', 'text.long-line', {
      'a.obj': 'v'.repeat(2 ** 25),
    }),
    refused('several files with the same path in an archive', 'with the path', 'zip.duplicate', {
      'set.zip': twice(),
    }),
  ],
};

/** A zip with two files named `a.usda`. */
function twice(): Uint8Array {
  const bytes = zipSync({ 'a.usda': CUBE, 'b.usda': CUBE });
  for (let i = 0; i < bytes.length; i++)
    if (String.fromCharCode(...bytes.subarray(i, i + 6)) === 'b.usda') bytes[i] = 97;
  return bytes;
}

export const containerGroups: readonly ClaimGroup[] = [whole, pictures, archives];
