import type { Vec3 } from '../../../../../math/vec3.ts';
import { msg } from '../../../../../messages/message.ts';
import type { NormalTexture, Texture, TextureChannel } from '../../../../../scene/types.ts';
import type { DecodedImage } from '../../../../image/decodeImage.ts';
import { channelMean, withAlphaFrom } from '../../../../image/imageChannels.ts';
import { clampNormalStrength } from '../../../../read/limits.ts';
import type { PrimSpec } from '../../../layer/layer.ts';
import type { ResolvedInput } from '../shaderInputs.ts';
import { adjustedAlpha, adjustedColor, adjustedMean, adjustedNormals } from '../texturePixels.ts';
import type {
  AlphaSource,
  ColorInputValue,
  OpacityInputValue,
  ScalarInputValue,
  SurfaceInputs,
} from '../textureReader.ts';
import type { UvSource } from '../uvs.ts';
import { bakedImage } from './baked.ts';
import { type Expression, type Grid, picked, type ScaledPicture, scaled, type TexelField } from './expression.ts';
import type { ShadingNetwork } from './network.ts';

/** Turns what a shading network computes into colours, numbers and textures. */
export class NetworkReader implements SurfaceInputs {
  readonly network: ShadingNetwork;
  private readonly shader: PrimSpec;
  /** Textures of numbers, so that the channels of one picture share one. */
  private readonly scalarTextures = new Map<DecodedImage, Texture>();

  constructor(network: ShadingNetwork, shader: PrimSpec) {
    this.network = network;
    this.shader = shader;
  }

  async color(input: ResolvedInput, fallback: Vec3, alphaOf?: AlphaSource): Promise<ColorInputValue> {
    return this.colorOf(await this.network.of(input, this.shader), fallback, alphaOf);
  }

  colorOf(found: Expression | undefined, fallback: Vec3, alphaOf?: AlphaSource): ColorInputValue {
    if (found?.kind === 'vertex') {
      const [r, g, b] = found.fallback;
      return { color: vec3(found.gain), primvar: { name: found.name, fallback: [r ?? 0, g ?? 0, b ?? 0] } };
    }
    if (found?.kind !== 'texels') {
      const color = found?.kind === 'constant' ? vec3(found.values) : fallback;
      if (!alphaOf) return { color };
      const white = withAlphaFrom(undefined, alphaOf.image, alphaOf.channel);
      const wrap = { wrapS: alphaOf.wrap?.[0] ?? 'repeat', wrapT: alphaOf.wrap?.[1] ?? 'repeat' } as const;
      const texture = { name: this.shader.path, ...white, colorSpace: 'srgb', filter: 'linear', ...wrap } as const;
      return { color, texture };
    }
    const { image, gain, colorSpace } = colorPixels(found);
    const merged = alphaOf ? withAlphaFrom(image, alphaOf.image, alphaOf.channel) : withoutAlpha(image);
    const texture = textureOn(found, { ...image, ...merged }, colorSpace);
    return { color: vec3(gain), texture, uv: found.grid.uv };
  }

  async opacity(input: ResolvedInput): Promise<OpacityInputValue> {
    return this.opacityOf(await this.network.of(input, this.shader));
  }

  opacityOf(found: Expression | undefined): OpacityInputValue {
    const one = this.single(found);
    if (one?.kind !== 'texels') return { value: one ? unit(one.values[0]) : 1 };
    const { grid } = one;
    const picture = one.picture ?? pictureOf(one);
    const adjusted = adjustedAlpha(picture.image, picture.channels[0], reading(picture));
    return {
      value: adjusted.gain,
      alphaOf: {
        shader: this.shader,
        picture: picture.image,
        image: adjusted.image,
        channel: adjusted.channel,
        wrap: [grid.wrapS, grid.wrapT],
      },
      uv: grid.uv,
    };
  }

  async scalar(input: ResolvedInput, fallback: number): Promise<ScalarInputValue> {
    return this.scalarOf(await this.network.of(input, this.shader), fallback);
  }

  scalarOf(found: Expression | undefined, fallback: number): ScalarInputValue {
    const one = this.single(found);
    if (one?.kind !== 'texels') return { value: unit(one?.values[0] ?? fallback) };
    const picture = one.picture ?? pictureOf(one);
    const [channel, scale, bias] = [picture.channels[0], picture.scale[0], picture.bias[0]];
    const texture = this.scalarTextures.get(picture.image) ?? textureOn(one, picture.image, picture.colorSpace);
    this.scalarTextures.set(picture.image, texture);
    return {
      value: unit(adjustedMean(picture.image, channel, reading(picture))),
      texture: { texture, channel: channel as TextureChannel['channel'], scale, bias },
      uv: one.grid.uv,
    };
  }

  /** Numbers 0 … 1 of red, green and blue. */
  dataOf(texels: TexelField): { readonly texture: Texture; readonly uv: UvSource | undefined } {
    const picture = pictureOf(texels);
    return { texture: textureOn(texels, picture.image, picture.colorSpace), uv: texels.grid.uv };
  }

  async normals(input: ResolvedInput) {
    const found = await this.network.of(input, this.shader);
    // UsdPreviewSurface takes −1 … 1, a normalmap 0 … 1.
    if (found?.kind === 'texels') return this.normalsOf(scaled(found, [0.5], [0.5]), [1, 1]);
    return found?.kind === 'normals' ? this.normalsOf(found.encoded, found.strength) : undefined;
  }

  /** The normal map of an encoded texture; undefined, with a diagnostic where that is more than nothing, for others. */
  normalsOf(
    encoded: Expression | undefined,
    strength: readonly [x: number, y: number],
  ): { readonly texture: NormalTexture; readonly uv?: UvSource | undefined } | undefined {
    if (encoded?.kind !== 'texels') return undefined;
    const picture = encoded.picture ?? pictureOf(encoded);
    const of = (list: readonly number[], k: number): number => list[k] ?? 0;
    // Components that are exchanged need pixels of their own.
    const straight = picture.channels.every((channel, k) => channel === k) ? picture : pictureOf(encoded);
    const scale = [0, 1, 2].map((k) => 2 * of(straight.scale, k));
    const bias = [0, 1, 2].map((k) => 2 * of(straight.bias, k) - 1);
    const factor = [strength[0], strength[1], 1];
    const made = adjustedNormals(straight.image, {
      channels: [0, 1, 2],
      colorSpace: straight.colorSpace,
      scale: scale.map((s, k) => s * factor[k]),
      bias: bias.map((b, k) => b * factor[k]),
    });
    const texture = textureOn(encoded, { ...made.image, data: withoutAlpha(made.image).data }, 'linear');
    const [x, y] = made.strength;
    return { texture: { texture, strength: [clampNormalStrength(x), clampNormalStrength(y)] }, uv: encoded.grid.uv };
  }

  /** The one number of an expression: the mean of the components of a colour. */
  private single(found: Expression | undefined): Extract<Expression, { kind: 'constant' | 'texels' }> | undefined {
    if (found?.kind === 'vertex') {
      const message = msg`a primvar drives a number of this material; its fallback is drawn`;
      this.network.tell('mtlx.node', this.shader, message);
      return { kind: 'constant', values: [found.fallback[0] * found.gain[0]] };
    }
    if (found?.kind === 'constant')
      return { kind: 'constant', values: [found.values.reduce((sum, x) => sum + x, 0) / found.values.length] };
    if (found?.kind !== 'texels' || found.size === 1) return found?.kind === 'texels' ? found : undefined;
    return picked(found, [0]) as TexelField;
  }
}

/** The pixels of a colour: those of its picture where a factor is enough, else computed ones. */
function colorPixels(texels: TexelField): BakedColor {
  const { picture } = texels;
  if (!picture) return { ...bakedImage(texels, 'srgb'), colorSpace: 'srgb' };
  const three = (list: readonly number[]): [number, number, number] =>
    [0, 1, 2].map((k) => list[list.length === 1 ? 0 : k]) as never;
  const { image, gain } = adjustedColor(picture.image, {
    channels: three(picture.channels),
    scale: three(picture.scale),
    bias: three(picture.bias),
    colorSpace: picture.colorSpace,
  });
  return { image, gain, colorSpace: picture.colorSpace };
}

interface BakedColor {
  readonly image: DecodedImage;
  readonly gain: readonly number[];
  readonly colorSpace: Texture['colorSpace'];
}

/** What is computed, as a picture of its own. */
function pictureOf(texels: TexelField): ScaledPicture {
  const { image, gain } = bakedImage(texels, 'linear');
  return {
    name: 'computed',
    image: { ...image, looksLikeColor: false },
    colorSpace: 'linear',
    channels: [0, 1, 2],
    scale: gain,
    bias: [0, 0, 0],
  };
}

/** Scale and bias by channel of the picture, as texturePixels.ts has them. */
function reading({ channels, scale, bias, colorSpace }: ScaledPicture) {
  const by = (list: readonly number[], otherwise: number): number[] => {
    const out = [otherwise, otherwise, otherwise, otherwise];
    out[channels[0]] = list[0];
    return out;
  };
  return { channels: [0, 1, 2] as const, scale: by(scale, 1), bias: by(bias, 0), colorSpace };
}

function textureOn(texels: TexelField, image: DecodedImage, colorSpace: Texture['colorSpace']): Texture {
  const { wrapS, wrapT, filter }: Grid = texels.grid;
  const { width, height, data } = image;
  return { name: texels.picture?.name ?? 'computed', width, height, data, colorSpace, filter, wrapS, wrapT };
}

/** The same pixels, opaque; the image itself if it is. */
function withoutAlpha(image: DecodedImage): DecodedImage {
  if (channelMean(image, 3) === 1) return image;
  const data = image.data.slice();
  for (let i = 3; i < data.length; i += 4) data[i] = 255;
  return { ...image, data };
}

const vec3 = (values: readonly number[]): Vec3 =>
  values.length < 3 ? [values[0], values[0], values[0]] : [values[0], values[1], values[2]];
const unit = (x: number): number => Math.min(1, Math.max(0, x));
