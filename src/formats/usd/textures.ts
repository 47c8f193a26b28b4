import { scale, type Vec3 } from '../../math/vec3.ts';
import type { Texture, TextureWrap } from '../../scene/types.ts';
import { InputError } from '../../scene/types.ts';
import { decodeSrgb } from '../../spectrum/srgb.ts';
import { messageOf } from '../fail.ts';
import { type DecodedImage, decodeImage } from '../images.ts';
import { textAt, textOf } from './attributes.ts';
import { report, type StageContext } from './context.ts';
import type { PrimSpec, Value } from './layer.ts';
import { resolveInput } from './shading.ts';

/** Reads pictures, each once. */
export class TextureLoader {
  private readonly context: StageContext;
  private readonly images = new Map<string, Promise<DecodedImage | undefined>>();

  constructor(context: StageContext) {
    this.context = context;
  }

  /** The picture of a UsdUVTexture; undefined, with a diagnostic, where there is none. */
  async image(shader: PrimSpec): Promise<DecodedImage | undefined> {
    const input = resolveInput(this.context.layer, shader, 'inputs:file', this.context.startCode);
    if (!textOf(input.value)) {
      report(this.context, 'warning', 'usd.missing-texture', shader.path, 'the texture names no file');
      return undefined;
    }
    return this.file(input.value, shader.path);
  }

  /** The picture that an asset value leads to. */
  file(value: Value | undefined, user: string): Promise<DecodedImage | undefined> {
    const asset = textOf(value) ?? '';
    const anchor = (value?.type === 'asset' && value.anchor) || this.context.layer.name;
    if (asset.includes('<UDIM>'))
      report(this.context, 'warning', 'usd.udim', user, `${asset} is a set of tiles; only tile 1001 is used`);
    const [path, ...more] = this.context.files.candidates(anchor, asset.replaceAll('<UDIM>', '1001'));
    const key = [path, ...more].join('\n');
    let image = this.images.get(key);
    if (!image) {
      image = this.load([path, ...more], anchor, user);
      this.images.set(key, image);
    }
    return image;
  }

  private async load(paths: readonly string[], anchor: string, user: string): Promise<DecodedImage | undefined> {
    const { files } = this.context;
    let path = paths[0];
    try {
      for (path of paths) {
        const bytes = await files.read(path);
        if (bytes) return decodeImage(bytes, path);
      }
      const message = `the texture ${paths[0]} is not there; put it beside ${anchor} or open the folder that holds both`;
      report(this.context, 'warning', 'usd.missing-texture', user, message);
      return undefined;
    } catch (thrown) {
      const message = thrown instanceof InputError ? thrown.message : messageOf(thrown);
      report(this.context, 'warning', 'usd.unreadable-texture', user, message);
      return undefined;
    }
  }
}

/** How a UsdUVTexture reads its picture. `alpha: false`: opacity does not come from it, so that it is opaque. */
export function textureOf(context: StageContext, shader: PrimSpec, image: DecodedImage, alpha: boolean): Texture {
  const text = (name: string): string | undefined =>
    textOf(resolveInput(context.layer, shader, `inputs:${name}`, context.startCode).value);
  return {
    name: text('file') ?? shader.path,
    width: image.width,
    height: image.height,
    data: alpha ? image.data : opaque(image.data),
    colorSpace: text('sourceColorSpace') === 'raw' ? 'linear' : 'srgb',
    filter: textAt(shader, 'slowlight:filter', undefined) === 'nearest' ? 'nearest' : 'linear',
    wrapS: wrapOf(text('wrapS')),
    wrapT: wrapOf(text('wrapT')),
  };
}

/** `black` outside the picture is clamped; `useMetadata` repeats, as pictures without metadata do in most viewers. */
function wrapOf(mode: string | undefined): TextureWrap {
  if (mode === 'clamp' || mode === 'black') return 'clamp';
  return mode === 'mirror' ? 'mirror' : 'repeat';
}

/** The picture without transparency; itself where it has none, so that materials share it. */
function opaque(rgba: Uint8Array): Uint8Array {
  let i = 3;
  while (i < rgba.length && rgba[i] === 255) i += 4;
  if (i >= rgba.length) return rgba;
  const out = rgba.slice();
  for (; i < out.length; i += 4) out[i] = 255;
  return out;
}

/** Mean of one channel, 0 … 1. */
export function meanOf(image: DecodedImage, channel: number): number {
  let sum = 0;
  for (let i = channel; i < image.data.length; i += 4) sum += image.data[i];
  return sum / (255 * image.width * image.height);
}

/** Mean colour in linear light. */
export function meanColor({ width, height, data, colorSpace }: Texture): Vec3 {
  const sum: [number, number, number] = [0, 0, 0];
  for (let i = 0; i < data.length; i += 4)
    for (let k = 0; k < 3; k++) sum[k] += colorSpace === 'srgb' ? decodeSrgb(data[i + k] / 255) : data[i + k] / 255;
  return scale(sum, 1 / (width * height));
}
