import type { Vec3 } from '../../math/vec3.ts';
import type { Material, Texture } from '../../scene/types.ts';
import { type DecodedImage, withAlphaFrom } from '../images.ts';
import { numberOf, numbersOf, vec3Of } from './attributes.ts';
import { primAt, report, type StageContext } from './context.ts';
import type { PrimSpec, Value } from './layer.ts';
import type { GlowMode } from './meshLights.ts';
import { type Input, resolveInput, shaderId } from './shading.ts';
import { meanOf, type TextureLoader, textureOf } from './textures.ts';
import { type UvSource, uvSourceOf } from './uvs.ts';

/** A material, and what it wants of the meshes that wear it. */
export interface BoundMaterial {
  /** Place in `Scene.materials`. */
  readonly index: number;
  readonly uv?: UvSource;
  /** Its diffuse colour is the mesh's displayColor. */
  readonly readsDisplayColor: boolean;
}

/** Inputs of UsdPreviewSurface that change the look and are not drawn. */
const NOT_DRAWN = ['normal', 'displacement', 'clearcoat', 'useSpecularWorkflow'];

/** The scene's materials, each read once. */
export class MaterialTable {
  readonly materials: Material[] = [];
  private readonly context: StageContext;
  private readonly textures: TextureLoader;
  private readonly glows = new Map<string, number>();
  private readonly byKey = new Map<string, Promise<BoundMaterial>>();

  constructor(context: StageContext, textures: TextureLoader) {
    this.context = context;
    this.textures = textures;
  }

  /** The material of a mesh without one: its displayColor, grey where there is none. */
  plain(color: Vec3, opacity: number): Promise<BoundMaterial> {
    const key = `displayColor ${color.join(' ')} ${opacity}`;
    const material = { ...DEFAULTS, name: key, baseColor: color, opacity };
    return this.once(key, async () => ({ index: this.materials.push(material) - 1, readsDisplayColor: false }));
  }

  /** The Material prim at a path; a plain one of the colour `fallback` where it cannot be read. */
  at(path: string, user: string, fallback: Vec3): Promise<BoundMaterial> {
    return this.once(path, async () => {
      const prim = primAt(this.context.layer, path);
      const shader = prim && this.surfaceShader(prim);
      if (shader) return this.preview(path, shader);
      const why = prim ? 'has no UsdPreviewSurface' : 'is not in this file';
      report(this.context, 'warning', 'usd.material', user, `its material ${path} ${why}; its displayColor is drawn`);
      return {
        index: this.materials.push({ ...DEFAULTS, name: path, baseColor: fallback }) - 1,
        readsDisplayColor: false,
      };
    });
  }

  /** The place of the material at `index` as it is on a light of a radiance. Its own glow tints the light, where that is asked for and it has any. */
  glowing(index: number, radiance: Vec3, mode: GlowMode): number {
    const key = `${index} ${mode} ${radiance.join(' ')}`;
    const known = this.glows.get(key);
    if (known !== undefined) return known;
    const { emissiveTexture, ...material } = this.materials[index];
    const name = `${material.name}_light`;
    const [r, g, b] = material.emissive;
    const tinted = mode === 'materialGlowTintsLight' && r + g + b > 0;
    const dark = mode === 'noMaterialResponse' ? { baseColor: BLACK, metallic: 0 } : {};
    const emissive: Vec3 = tinted ? [r * radiance[0], g * radiance[1], b * radiance[2]] : radiance;
    const textured = tinted && emissiveTexture ? { emissiveTexture } : {};
    const place = this.materials.push({ ...material, ...dark, ...textured, name, emissive }) - 1;
    this.glows.set(key, place);
    return place;
  }

  private once(key: string, make: () => Promise<BoundMaterial>): Promise<BoundMaterial> {
    let bound = this.byKey.get(key);
    if (!bound) {
      bound = make();
      this.byKey.set(key, bound);
    }
    return bound;
  }

  private surfaceShader(material: PrimSpec): PrimSpec | undefined {
    const { shader } = resolveInput(this.context.layer, material, 'outputs:surface', this.context.startCode);
    return shader && shaderId(shader) === 'UsdPreviewSurface' ? shader : undefined;
  }

  private async preview(path: string, shader: PrimSpec): Promise<BoundMaterial> {
    const input = (name: string): Input =>
      resolveInput(this.context.layer, shader, `inputs:${name}`, this.context.startCode);
    const opacity = await this.opacity(input('opacity'));
    const diffuse = await this.color(input('diffuseColor'), DEFAULTS.baseColor, opacity.alphaOf);
    const emissive = await this.color(input('emissiveColor'), [0, 0, 0], undefined);
    const ior = numberOf(input('ior').value);
    const material: Material = {
      name: path,
      baseColor: diffuse.color,
      ...(diffuse.texture ? { baseColorTexture: diffuse.texture } : {}),
      emissive: emissive.color,
      ...(emissive.texture ? { emissiveTexture: emissive.texture } : {}),
      roughness: await this.scalar(input('roughness'), DEFAULTS.roughness),
      metallic: await this.scalar(input('metallic'), DEFAULTS.metallic),
      opacity: opacity.value,
      opacityThreshold: numberOf(input('opacityThreshold').value) ?? 0,
      ...(ior !== undefined && { ior }),
    };
    this.noteWhatIsNotDrawn(path, input);
    const uv = diffuse.uv ?? emissive.uv ?? opacity.uv;
    if (emissive.uv && diffuse.uv && emissive.uv.name !== diffuse.uv.name)
      report(
        this.context,
        'warning',
        'usd.uv',
        path,
        `textures use ${diffuse.uv.name} and ${emissive.uv.name}; the first is used for both`,
      );
    const bound = { index: this.materials.push(material) - 1, readsDisplayColor: diffuse.readsDisplayColor };
    return uv ? { ...bound, uv } : bound;
  }

  private noteWhatIsNotDrawn(path: string, input: (name: string) => Input): void {
    const isWritten = (name: string): boolean =>
      input(name).shader !== undefined || (numberOf(input(name).value) ?? 0) > 0;
    const left = NOT_DRAWN.filter(isWritten);
    const means = ['roughness', 'metallic'].filter((name) => input(name).shader);
    const notes = [
      ...(left.length > 0 ? [`${left.join(', ')} of this material is not drawn`] : []),
      ...(means.length > 0 ? [`the texture of its ${means.join(' and ')} is drawn as its mean`] : []),
    ];
    if (notes.length > 0) report(this.context, 'info', 'usd.material-input', path, notes.join('; '));
  }

  private async color(input: Input, fallback: Vec3, alphaOf: AlphaSource | undefined): Promise<Colored> {
    const { shader } = input;
    const id = shader && shaderId(shader);
    if (id === 'UsdUVTexture') return this.texturedColor(shader!, fallback, alphaOf);
    if (id?.startsWith('UsdPrimvarReader_float3')) return { color: [1, 1, 1], readsDisplayColor: true };
    if (shader) this.unsupported(shader);
    const color = vec3Of(input.value) ?? fallback;
    return alphaOf ? this.alphaOnly(color, alphaOf) : { color, readsDisplayColor: false };
  }

  private async texturedColor(shader: PrimSpec, fallback: Vec3, alphaOf: AlphaSource | undefined): Promise<Colored> {
    const image = await this.textures.image(shader);
    const value = (name: string): Value | undefined =>
      resolveInput(this.context.layer, shader, `inputs:${name}`, this.context.startCode).value;
    if (!image) return { color: vec3Of(value('fallback')) ?? fallback, readsDisplayColor: false };
    if (numbersOf(value('bias'))?.some((x) => x !== 0))
      report(this.context, 'warning', 'usd.texture-bias', shader.path, 'the bias of a colour texture is not applied');
    const ownAlpha = alphaOf?.shader === shader && alphaOf.channel === 3;
    const merged = alphaOf && !ownAlpha ? withAlphaFrom(image, alphaOf.image, alphaOf.channel) : image;
    const texture = textureOf(this.context, shader, merged, alphaOf !== undefined);
    const uv = uvSourceOf(this.context, shader);
    return { color: vec3Of(value('scale')) ?? [1, 1, 1], texture, uv, readsDisplayColor: false };
  }

  /** A plain colour cut out by a texture: white pixels that carry the alpha. */
  private alphaOnly(color: Vec3, alpha: AlphaSource): Colored {
    const image = withAlphaFrom(undefined, alpha.image, alpha.channel);
    const texture = textureOf(this.context, alpha.shader, image, true);
    return { color, texture, uv: uvSourceOf(this.context, alpha.shader), readsDisplayColor: false };
  }

  private async opacity(input: Input): Promise<{ value: number; alphaOf?: AlphaSource; uv?: UvSource }> {
    const { shader, output } = input;
    if (!shader) return { value: numberOf(input.value) ?? 1 };
    if (shaderId(shader) !== 'UsdUVTexture') {
      this.unsupported(shader);
      return { value: 1 };
    }
    const image = await this.textures.image(shader);
    if (!image) return { value: 1 };
    const channel = channelOf(output);
    const scale = resolveInput(this.context.layer, shader, 'inputs:scale', this.context.startCode).value;
    const uv = uvSourceOf(this.context, shader);
    return { value: numbersOf(scale)?.[channel] ?? 1, alphaOf: { shader, image, channel }, uv };
  }

  /** A number; of a texture its mean. */
  private async scalar(input: Input, fallback: number): Promise<number> {
    const { shader } = input;
    if (!shader) return numberOf(input.value) ?? fallback;
    if (shaderId(shader) !== 'UsdUVTexture') {
      this.unsupported(shader);
      return fallback;
    }
    const image = await this.textures.image(shader);
    if (!image) return fallback;
    const channel = channelOf(input.output);
    const part = (which: string, otherwise: number): number => {
      const { value } = resolveInput(this.context.layer, shader, `inputs:${which}`, this.context.startCode);
      return numbersOf(value)?.[channel] ?? otherwise;
    };
    return Math.min(1, Math.max(0, meanOf(image, channel) * part('scale', 1) + part('bias', 0)));
  }

  private unsupported(shader: PrimSpec): void {
    const message = `a shader '${shaderId(shader)}' is not read; the input that it drives keeps its own value`;
    report(this.context, 'warning', 'usd.shader', shader.path, message);
  }
}

/** What UsdPreviewSurface is where nothing is written; the grey is that of a mesh without a material. */
const DEFAULTS: Omit<Material, 'name'> = {
  baseColor: [0.18, 0.18, 0.18],
  emissive: [0, 0, 0],
  roughness: 0.5,
  metallic: 0,
  opacity: 1,
  opacityThreshold: 0,
};

const BLACK: Vec3 = [0, 0, 0];

interface Colored {
  readonly color: Vec3;
  readonly texture?: Texture;
  readonly uv?: UvSource | undefined;
  readonly readsDisplayColor: boolean;
}

interface AlphaSource {
  readonly shader: PrimSpec;
  readonly image: DecodedImage;
  readonly channel: number;
}

const channelOf = (output: string | undefined): number => Math.max(0, 'rgba'.indexOf(output ?? 'r'));
