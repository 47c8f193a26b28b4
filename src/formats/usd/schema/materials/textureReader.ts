import type { Vec3 } from '../../../../math/vec3.ts';
import { msg } from '../../../../messages/message.ts';
import type { NormalTexture, Texture, TextureChannel, TextureWrap } from '../../../../scene/types.ts';
import type { DecodedImage } from '../../../image/decodeImage.ts';
import { withAlphaFrom } from '../../../image/imageChannels.ts';
import { report } from '../../diagnostics.ts';
import { numberOf, numbersOf, vec3Of } from '../../layer/attributes.ts';
import type { PrimSpec, Value } from '../../layer/layer.ts';
import type { StageContext } from '../context.ts';
import { isAnimated, type ResolvedInput, resolveInput, shaderId } from './shaderInputs.ts';
import type { LoadedImage } from './textureFiles.ts';
import { colorSpaceOf, type TextureLoader, textureOf } from './textureLoader.ts';
import { adjustedAlpha, adjustedColor, adjustedMean, adjustedNormals, type TexelReading } from './texturePixels.ts';
import { type UvSource, uvSourceOf, withTiles } from './uvs.ts';

/** A colour primvar and its fallback. */
export interface ColorPrimvar {
  readonly name: string;
  readonly fallback: Vec3;
}

export interface ColorInputValue {
  readonly color: Vec3;
  readonly texture?: Texture;
  readonly uv?: UvSource | undefined;
  readonly primvar?: ColorPrimvar;
}

/** Source of opacity, for the alpha of another texture. */
export interface AlphaSource {
  readonly shader: PrimSpec;
  readonly image: DecodedImage;
  readonly picture: LoadedImage;
  readonly channel: number;
  /** Outside the picture, if the shader does not say so as a UsdUVTexture does. */
  readonly wrap?: readonly [s: TextureWrap, t: TextureWrap];
}

export interface OpacityInputValue {
  readonly value: number;
  readonly alphaOf?: AlphaSource;
  readonly uv?: UvSource | undefined;
}

/** A number, with the texture that it is the mean of. */
export interface ScalarInputValue {
  readonly value: number;
  readonly texture?: TextureChannel;
  readonly uv?: UvSource | undefined;
}

/** Reads the inputs of a surface. */
export interface SurfaceInputs {
  color(input: ResolvedInput, fallback: Vec3, alphaOf?: AlphaSource): Promise<ColorInputValue>;
  opacity(input: ResolvedInput): Promise<OpacityInputValue>;
  /** A number from 0 to 1, with a texture if it is connected to one. */
  scalar(input: ResolvedInput, fallback: number): Promise<ScalarInputValue>;
  /** The normal map; undefined if no texture is connected, since a constant normal has no effect. */
  normals(
    input: ResolvedInput,
  ): Promise<{ readonly texture: NormalTexture; readonly uv?: UvSource | undefined } | undefined>;
}

/** Resolves shader inputs to values, textures and primvars. */
export class TextureReader implements SurfaceInputs {
  private readonly context: StageContext;
  private readonly textures: TextureLoader;
  /** Scalar textures by shader, so that channels of one image share a texture. */
  private readonly scalarTextures = new Map<PrimSpec, Texture>();

  constructor(context: StageContext, textures: TextureLoader) {
    this.context = context;
    this.textures = textures;
  }

  async color(input: ResolvedInput, fallback: Vec3, alphaOf?: AlphaSource): Promise<ColorInputValue> {
    const { shader } = input;
    const id = shader && shaderId(shader);
    if (id === 'UsdUVTexture') return this.texturedColor(shader!, input.output, fallback, alphaOf);
    const primvar = shader && this.colorPrimvar(shader, id!);
    if (primvar) return { color: [1, 1, 1], primvar };
    if (shader) this.unsupported(shader);
    const color = vec3Of(input.value) ?? fallback;
    return alphaOf ? this.alphaOnly(color, alphaOf) : { color };
  }

  private colorPrimvar(reader: PrimSpec, id: string): ColorPrimvar | undefined {
    if (!/^UsdPrimvarReader_(float3|vector|point|normal|float4)/.test(id)) return undefined;
    const value = (name: string): Value | undefined =>
      resolveInput(this.context.layer, reader, `inputs:${name}`, this.context.startCode).value;
    const name = value('varname');
    const fallback = vec3Of(value('fallback')) ?? [1, 1, 1];
    return { name: name && 'data' in name && typeof name.data === 'string' ? name.data : 'displayColor', fallback };
  }

  private async texturedColor(
    shader: PrimSpec,
    output: string | undefined,
    fallback: Vec3,
    alphaOf: AlphaSource | undefined,
  ): Promise<ColorInputValue> {
    const picture = await this.textures.image(shader);
    if (!picture) return { color: vec3Of(this.value(shader, 'fallback')) ?? fallback };
    const single = 'rgba'.indexOf(output ?? 'rgb');
    const channels = output?.length === 1 && single >= 0 ? ([single, single, single] as const) : ([0, 1, 2] as const);
    const { image, gain } = adjustedColor(picture, this.reading(shader, picture, channels));
    const ownAlpha = alphaOf?.shader === shader && alphaOf.channel === 3 && alphaOf.image === alphaOf.picture;
    const merged = alphaOf && !ownAlpha ? withAlphaFrom(image, alphaOf.image, alphaOf.channel) : image;
    const texture = textureOf(this.context, shader, { ...picture, ...merged }, alphaOf !== undefined);
    return { color: gain, texture, uv: this.uvOf(shader, picture) };
  }

  /** White pixels with the alpha of an opacity texture, for a constant colour. */
  private alphaOnly(color: Vec3, { shader, picture, image, channel }: AlphaSource): ColorInputValue {
    const white = withAlphaFrom(undefined, image, channel);
    const texture = textureOf(this.context, shader, { ...picture, ...white }, true);
    return { color, texture, uv: this.uvOf(shader, picture) };
  }

  async opacity(input: ResolvedInput): Promise<OpacityInputValue> {
    const found = await this.scalarImage(input);
    if (found === undefined || typeof found === 'number') return { value: found ?? 1 };
    const { shader, picture, channel } = found;
    const adjusted = adjustedAlpha(picture, channel, this.reading(shader, picture));
    const alphaOf = { shader, picture, image: adjusted.image, channel: adjusted.channel };
    return { value: adjusted.gain, alphaOf, uv: this.uvOf(shader, picture) };
  }

  async scalar(input: ResolvedInput, fallback: number): Promise<ScalarInputValue> {
    const found = await this.scalarImage(input);
    if (found === undefined || typeof found === 'number') return { value: found ?? fallback };
    const { shader, picture, channel } = found;
    const reading = this.reading(shader, picture);
    const texture = this.scalarTextures.get(shader) ?? textureOf(this.context, shader, picture, true);
    this.scalarTextures.set(shader, texture);
    return {
      value: Math.min(1, adjustedMean(picture, channel, reading)),
      texture: { texture, channel, scale: reading.scale[channel], bias: reading.bias[channel] },
      uv: this.uvOf(shader, picture),
    };
  }

  async normals(
    input: ResolvedInput,
  ): Promise<{ readonly texture: NormalTexture; readonly uv?: UvSource | undefined } | undefined> {
    const { shader } = input;
    if (!shader) return undefined;
    if (shaderId(shader) !== 'UsdUVTexture') {
      this.unsupported(shader);
      return undefined;
    }
    const picture = await this.textures.image(shader);
    if (!picture) return undefined;
    const { image, strength } = adjustedNormals(picture, this.reading(shader, picture));
    const texture = {
      ...textureOf(this.context, shader, { ...picture, ...image }, false),
      colorSpace: 'linear',
    } as const;
    return { texture: { texture, strength }, uv: this.uvOf(shader, picture) };
  }

  /** The texture connected to a scalar input, or its value; undefined if neither exists. */
  private async scalarImage(
    input: ResolvedInput,
  ): Promise<{ shader: PrimSpec; picture: LoadedImage; channel: TextureChannel['channel'] } | number | undefined> {
    const { shader } = input;
    if (!shader) return numberOf(input.value);
    const id = shaderId(shader);
    if (id === 'UsdUVTexture') {
      const channel = Math.max(0, 'rgba'.indexOf(input.output ?? 'r')) as TextureChannel['channel'];
      const picture = await this.textures.image(shader);
      return picture ? { shader, picture, channel } : numbersOf(this.value(shader, 'fallback'))?.[channel];
    }
    if (!id.startsWith('UsdPrimvarReader_float')) this.unsupported(shader);
    else {
      const message = msg`a primvar drives a number of this material; its fallback is drawn`;
      report(this.context, 'info', 'usd.material-input', shader.path, message);
    }
    return numberOf(this.value(shader, 'fallback'));
  }

  private uvOf(shader: PrimSpec, { tiles }: LoadedImage): UvSource | undefined {
    const uv = uvSourceOf(this.context, shader);
    return tiles ? withTiles(uv ?? { name: 'st' }, tiles) : uv;
  }

  private reading(
    shader: PrimSpec,
    picture: LoadedImage,
    channels: TexelReading['channels'] = [0, 1, 2],
  ): TexelReading {
    if (isAnimated(shader))
      report(
        this.context,
        'warning',
        'usd.animated-material',
        shader.path,
        msg`it changes with time; it is held at the start`,
      );
    const four = (name: string, otherwise: number): number[] => {
      const written = numbersOf(this.value(shader, name));
      return [0, 1, 2, 3].map((k) => (Number.isFinite(written?.[k]) ? written![k] : otherwise));
    };
    return {
      scale: four('scale', 1),
      bias: four('bias', 0),
      channels,
      colorSpace: colorSpaceOf(this.context, shader, picture),
    };
  }

  private value(shader: PrimSpec, name: string): Value | undefined {
    return resolveInput(this.context.layer, shader, `inputs:${name}`, this.context.startCode).value;
  }

  private unsupported(shader: PrimSpec): void {
    const message = msg`a shader '${shaderId(shader)}' is not read; the input that it drives keeps its own value`;
    report(this.context, 'warning', 'usd.shader', shader.path, message);
  }
}
