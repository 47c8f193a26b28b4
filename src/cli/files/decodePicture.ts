import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import type { Picture } from '@jsquash/webp/decode.js';
import type { DecodePicture, ForeignKind } from '../../formats/image/foreignPictures.ts';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';

const { resolve } = createRequire(import.meta.url);

type Codec = (bytes: ArrayBuffer) => Promise<Picture | null>;

const codecs = new Map<ForeignKind, Promise<Codec>>();

/** Decodes with the codecs' own libraries (libwebp, libavif), in WebAssembly; loaded with the first picture of each kind. */
export const decodePicture: DecodePicture = async (bytes, kind) => {
  provideImageData();
  let codec = codecs.get(kind);
  if (!codec) {
    codec = kind === 'WebP' ? loadWebp() : loadAvif();
    codecs.set(kind, codec);
  }
  const picture = await (await codec)(bytes.buffer);
  if (!picture) throw new MessageError(msg`the decoder gives no picture`);
  const { width, height, data } = picture;
  return { width, height, data: new Uint8Array(data.buffer, data.byteOffset, data.byteLength) };
};

async function loadWebp(): Promise<Codec> {
  const { init, default: decode } = await import('@jsquash/webp/decode.js');
  await init(await compiled('@jsquash/webp/codec/dec/webp_dec.wasm'));
  return decode;
}

async function loadAvif(): Promise<Codec> {
  const { init, default: decode } = await import('@jsquash/avif/decode.js');
  await init(await compiled('@jsquash/avif/codec/dec/avif_dec.wasm'));
  return decode;
}

const compiled = async (path: string): Promise<WebAssembly.Module> =>
  WebAssembly.compile(new Uint8Array(await readFile(resolve(path))));

/** The codecs return their pictures as browsers have them. */
class PictureData {
  readonly data: Uint8ClampedArray;
  readonly width: number;
  readonly height: number;
  constructor(data: Uint8ClampedArray, width: number, height: number) {
    this.data = data;
    this.width = width;
    this.height = height;
  }
}

function provideImageData(): void {
  globalThis.ImageData ??= PictureData as unknown as typeof ImageData;
}
