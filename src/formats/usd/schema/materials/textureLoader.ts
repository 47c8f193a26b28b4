import { scale, type Vec3 } from '../../../../math/vec3.ts';
import { msg } from '../../../../messages/message.ts';
import { messageOf } from '../../../../messages/messageError.ts';
import type { DomeLight, Texture, TextureWrap } from '../../../../scene/types.ts';
import { decodeSrgb } from '../../../../spectrum/display/srgb.ts';
import { missingTexture } from '../../../diagnostics/missingFiles.ts';
import { report } from '../../diagnostics.ts';
import { textAt, textOf } from '../../layer/attributes.ts';
import type { PrimSpec, Value } from '../../layer/layer.ts';
import type { StageContext } from '../context.ts';
import { resolveInput } from './shaderInputs.ts';
import type { LoadedImage } from './textureFiles.ts';

/** Reads and caches textures. */
export class TextureLoader {
  private readonly context: StageContext;
  private readonly images = new Map<string, Promise<LoadedImage | undefined>>();

  constructor(context: StageContext) {
    this.context = context;
  }

  /** The texture of a UsdUVTexture; undefined, with a diagnostic, if missing or invalid. */
  async image(shader: PrimSpec): Promise<LoadedImage | undefined> {
    const input = resolveInput(this.context.layer, shader, 'inputs:file', this.context.startCode);
    if (!textOf(input.value)) {
      report(this.context, 'warning', 'usd.texture', shader.path, msg`the texture names no file`);
      return undefined;
    }
    const picture = await this.file(input.value, shader.path);
    const written = textOf(
      resolveInput(this.context.layer, shader, 'inputs:sourceColorSpace', this.context.startCode).value,
    );
    return picture?.numbers && (written === 'raw' || written === 'sRGB')
      ? { ...picture, data: picture.numbers, looksLikeColor: false }
      : picture;
  }

  /** The texture of an asset value. */
  file(value: Value | undefined, user: string): Promise<LoadedImage | undefined> {
    const asked = this.requestFor(value, user);
    const key = asked.paths.join('\n');
    let image = this.images.get(key);
    if (!image) {
      image = this.load(asked);
      this.images.set(key, image);
    }
    return image;
  }

  /** The environment map of a dome: HDR or an ordinary texture. */
  async domeTexture(value: Value | undefined, prim: PrimSpec): Promise<DomeLight['texture']> {
    const asked = this.requestFor(value, prim.path);
    const { readRadiance } = await import('./textureFiles.ts');
    const radiance = await this.nullIfUnreadable(asked, () => readRadiance(this.context.files, asked));
    if (radiance) return { name: asked.asset, ...radiance, colorSpace: 'linear', filter: 'linear', ...PANORAMA_WRAP };
    if (radiance === null) return undefined;
    const image = await this.file(value, prim.path);
    return image && { ...textureOf(this.context, prim, image, false), name: asked.asset, ...PANORAMA_WRAP };
  }

  private requestFor(value: Value | undefined, user: string): TextureRequest {
    const asset = textOf(value) ?? '';
    const anchor = (value?.type === 'asset' && value.anchor) || this.context.layer.name;
    return { asset, anchor, user, paths: this.context.files.candidates(anchor, asset) };
  }

  private async load(asked: TextureRequest): Promise<LoadedImage | undefined> {
    const { asset, user, paths } = asked;
    // Codecs are loaded with the first texture.
    const { readImage } = await import('./textureFiles.ts');
    const picture = await this.nullIfUnreadable(asked, () => readImage(this.context.files, asked));
    if (picture !== undefined) return picture ?? undefined;
    const { code, message, missing } = missingTexture(asset, paths);
    report(this.context, 'warning', code, user, message, { missing });
    return undefined;
  }

  /** The result of `read`; null, with a diagnostic, if it throws. */
  private async nullIfUnreadable<T>({ user }: TextureRequest, read: () => Promise<T>): Promise<T | null> {
    try {
      return await read();
    } catch (thrown) {
      report(this.context, 'warning', 'file.unreadable-texture', user, messageOf(thrown));
      return null;
    }
  }
}

/** An asset with its referrer and candidate paths. */
interface TextureRequest {
  readonly asset: string;
  readonly anchor: string;
  readonly user: string;
  readonly paths: readonly string[];
}

/** Panoramas wrap around horizontally. */
const PANORAMA_WRAP = { wrapS: 'repeat', wrapT: 'clamp' } as const;

/** How a UsdUVTexture is read. `alpha: false`: opacity comes from elsewhere, so its own alpha is ignored. */
export function textureOf(context: StageContext, shader: PrimSpec, image: LoadedImage, alpha: boolean): Texture {
  const text = (name: string): string | undefined =>
    textOf(resolveInput(context.layer, shader, `inputs:${name}`, context.startCode).value);
  return {
    name: text('file') ?? shader.path,
    width: image.width,
    height: image.height,
    data: alpha ? image.data : opaque(image.data),
    colorSpace: colorSpaceOf(context, shader, image),
    filter: textAt(shader, 'slowlight:filter', undefined) === 'nearest' ? 'nearest' : 'linear',
    wrapS: image.tiles ? 'clamp' : wrapOf(text('wrapS')),
    wrapT: image.tiles ? 'clamp' : wrapOf(text('wrapT')),
  };
}

/** `auto` depends on the image. */
export function colorSpaceOf(context: StageContext, shader: PrimSpec, picture: LoadedImage): Texture['colorSpace'] {
  const written = textOf(resolveInput(context.layer, shader, 'inputs:sourceColorSpace', context.startCode).value);
  if (written === 'raw' || written === 'sRGB') return written === 'raw' ? 'linear' : 'srgb';
  return picture.looksLikeColor ? 'srgb' : 'linear';
}

/** `useMetadata` repeats, as images without metadata do in most viewers. */
function wrapOf(mode: string | undefined): TextureWrap {
  return mode === 'clamp' || mode === 'black' || mode === 'mirror' ? mode : 'repeat';
}

/** The texture without alpha; the same object if it is opaque, so that materials share it. */
function opaque(rgba: Uint8Array): Uint8Array {
  let i = 3;
  while (i < rgba.length && rgba[i] === 255) i += 4;
  if (i >= rgba.length) return rgba;
  const out = rgba.slice();
  for (; i < out.length; i += 4) out[i] = 255;
  return out;
}

/** Mean colour in linear light. */
export function meanColor({ width, height, data, colorSpace }: Texture): Vec3 {
  const sum: [number, number, number] = [0, 0, 0];
  for (let i = 0; i < data.length; i += 4)
    for (let k = 0; k < 3; k++) sum[k] += colorSpace === 'srgb' ? decodeSrgb(data[i + k] / 255) : data[i + k] / 255;
  return scale(sum, 1 / (width * height));
}
