import type { Vec3 } from '../../../../math/vec3.ts';
import { listed, msg } from '../../../../messages/message.ts';
import type { Material } from '../../../../scene/types.ts';
import { INVISIBLE_BANDS, parseSpectralHints, REFLECTANCE_ATTRIBUTE } from '../../../attributes/hints.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, numberOf, textOf, valueAt } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import { primAt, targetsOf } from '../../layer/query.ts';
import type { StageContext } from '../context.ts';
import { reflectanceOfFile } from '../spectrumFiles.ts';
import { foreignMaterial, shaderName, surfaceShaders } from './foreignShaders.ts';
import type { ShadingNetwork } from './network/network.ts';
import { isAnimated, type ResolvedInput, resolveInput, shaderId } from './shaderInputs.ts';
import { fromSpecularWorkflow } from './specularWorkflow.ts';
import { type TextureLoader, textureOf } from './textureLoader.ts';
import { type ColorPrimvar, type ScalarInputValue, type SurfaceInputs, TextureReader } from './textureReader.ts';
import { isSameUv, type UvSource, withTiles } from './uvs.ts';

/** A material and the primvars it needs. */
export interface BoundMaterial {
  /** Index in `Scene.materials`. */
  readonly index: number;
  readonly uv?: UvSource;
  /** Source of its diffuse colour, if it is a primvar of the mesh. */
  readonly colors?: ColorPrimvar;
}

/** How a mesh light combines with its material (`light:materialSyncMode` of UsdLux). */
export type MaterialSyncMode = 'materialGlowTintsLight' | 'independent' | 'noMaterialResponse';

/** `primvars:displayColor` of a mesh. */
export interface DisplayColor {
  /** White if it varies. */
  readonly color: Vec3;
  readonly opacity: number;
  readonly varies: boolean;
}

/** The material that reads the mesh's varying colours. */
export const withDisplayColor = (material: BoundMaterial, { varies }: DisplayColor): BoundMaterial =>
  varies ? { ...material, colors: { name: 'displayColor', fallback: WHITE } } : material;

/** Unsupported inputs of UsdPreviewSurface. */
const UNSUPPORTED_INPUTS = ['displacement'];
/** Of UsdPreviewSurface. */
const DEFAULT_COAT_ROUGHNESS = 0.01;

/** UsdPreviewSurface and its MaterialX node; both have the same inputs. */
const PREVIEW_SURFACE_IDS = new Set(['UsdPreviewSurface', 'ND_UsdPreviewSurface_surfaceshader']);

const isMaterialX = (shader: PrimSpec): boolean => shaderId(shader).startsWith('ND_');

/** A key of a material's content, so that instances share materials; undefined if it is not known. */
function networkKey({ content, children, properties }: PrimSpec, root: string): string | undefined {
  const parts = [content];
  for (const property of properties.values())
    if (property.kind === 'attribute')
      for (const path of property.connections?.explicit ?? [])
        parts.push(path.startsWith(`${root}/`) ? path.slice(root.length) : path);
  for (const child of children.values()) parts.push(child.name, networkKey(child, root));
  return parts.includes(undefined) ? undefined : `(${parts.join(' ')})`;
}

/** The material of unbound meshes with the given colours. */
interface DisplayColorMaterial {
  readonly color: Vec3;
  readonly opacity: number;
  readonly bound: Promise<BoundMaterial>;
}

/** Reads and caches the scene's materials. */
export class MaterialTable {
  readonly materials: Material[] = [];
  private readonly context: StageContext;
  private readonly textures: TextureLoader;
  private readonly inputs: TextureReader;
  private readonly emissiveIndices = new Map<string, number>();
  private readonly byKey = new Map<string, Promise<BoundMaterial>>();
  private readonly baseColorIndices = new Map<string, number>();
  private lastDisplayColor: DisplayColorMaterial | undefined;

  constructor(context: StageContext, textures: TextureLoader) {
    this.context = context;
    this.textures = textures;
    this.inputs = new TextureReader(context, textures);
  }

  /** The material of an unbound mesh: its displayColor, or grey. */
  displayColorMaterial(color: Vec3, opacity: number): Promise<BoundMaterial> {
    const last = this.lastDisplayColor;
    if (last?.opacity === opacity && color.every((x, i) => x === last.color[i])) return last.bound;
    const key = `displayColor ${color.join(' ')} ${opacity}`;
    const material = { ...DEFAULTS, name: key, baseColor: color, opacity };
    const bound = this.memoized(key, async () => this.added(material, {}));
    this.lastDisplayColor = { color, opacity, bound };
    return bound;
  }

  /** The material of the Material prim at a path; a plain one of the colour `fallback` if it cannot be read. */
  bound(path: string, user: string, fallback: DisplayColor): Promise<BoundMaterial> {
    const prim = primAt(this.context.layer, path);
    return this.memoized((prim && networkKey(prim, path)) ?? path, async () => {
      const shaders = prim ? surfaceShaders(this.context, prim) : [];
      const shader = shaders.find((candidate) => PREVIEW_SURFACE_IDS.has(shaderId(candidate)));
      if (prim && shader) return this.preview(prim, shader);
      const surface = prim && (await this.networkSurface(prim, shaders));
      if (surface) return surface;
      if (shaders.length > 0) return this.foreign(path, shaders[0], fallback);
      const why = prim ? msg`has no surface that can be read` : msg`is not in this file`;
      report(
        this.context,
        'warning',
        'usd.material',
        user,
        msg`its material ${path} ${why}; its displayColor is drawn`,
      );
      return withDisplayColor(this.added({ ...DEFAULTS, name: path, baseColor: fallback.color }, {}), fallback);
    });
  }

  /** Index of material `index` as an emitter of the given radiance, tinted by its own emission if requested and nonzero. */
  emissive(index: number, radiance: Vec3, mode: MaterialSyncMode): number {
    const key = `${index} ${mode} ${radiance.join(' ')}`;
    const cached = this.emissiveIndices.get(key);
    if (cached !== undefined) return cached;
    const { emissiveTexture, emissionTemperature, reflectance, ...material } = this.materials[index];
    const name = `${material.name}_light`;
    const [r, g, b] = material.emissive;
    const tinted = mode === 'materialGlowTintsLight' && r + g + b > 0;
    const dark =
      mode === 'noMaterialResponse' ? { baseColor: BLACK, metallic: 0 } : { ...(reflectance && { reflectance }) };
    const emissive: Vec3 = tinted ? [r * radiance[0], g * radiance[1], b * radiance[2]] : radiance;
    const own = {
      ...(emissiveTexture && { emissiveTexture }),
      ...(emissionTemperature !== undefined && { emissionTemperature }),
    };
    const place = this.materials.push({ ...material, ...dark, ...(tinted && own), name, emissive }) - 1;
    this.emissiveIndices.set(key, place);
    return place;
  }

  /** A material of the scene with another base colour. */
  withBaseColor(index: number, color: Vec3): number {
    const key = `${index} ${color.join(' ')}`;
    const cached = this.baseColorIndices.get(key);
    if (cached !== undefined) return cached;
    const { reflectance: _, ...material } = this.materials[index];
    const name = `${material.name} ${color.join(' ')}`;
    const made = this.materials.push({ ...material, name, baseColor: color }) - 1;
    this.baseColorIndices.set(key, made);
    return made;
  }

  private memoized(key: string, make: () => Promise<BoundMaterial>): Promise<BoundMaterial> {
    let bound = this.byKey.get(key);
    if (!bound) {
      bound = make();
      this.byKey.set(key, bound);
    }
    return bound;
  }

  private async preview(prim: PrimSpec, shader: PrimSpec): Promise<BoundMaterial> {
    const { path } = prim;
    const inputs = isMaterialX(shader) ? await this.networkInputs(shader) : this.inputs;
    const input = (name: string): ResolvedInput =>
      resolveInput(this.context.layer, shader, `inputs:${name}`, this.context.startCode);
    const opacity = await inputs.opacity(input('opacity'));
    const diffuse = await inputs.color(input('diffuseColor'), DEFAULTS.baseColor, opacity.alphaOf);
    const emissive = await inputs.color(input('emissiveColor'), BLACK);
    const normals = await inputs.normals(input('normal'));
    const roughness = await inputs.scalar(input('roughness'), DEFAULTS.roughness);
    const metallic = await inputs.scalar(input('metallic'), DEFAULTS.metallic);
    const occlusion = await inputs.scalar(input('occlusion'), 1);
    const { uvs: unseenUvs, ...unseen } = await this.invisibleLight(prim);
    const { clearcoat, uvs: coatUvs } = await this.clearcoat(inputs, input);
    const isSpecular = numberOf(input('useSpecularWorkflow').value) === 1;
    const specular = isSpecular ? await inputs.color(input('specularColor'), BLACK) : undefined;
    const ior = numberOf(input('ior').value);
    const material: Material = {
      name: path,
      ...(specular
        ? fromSpecularWorkflow(diffuse, specular)
        : {
            baseColor: diffuse.color,
            ...(diffuse.texture && { baseColorTexture: diffuse.texture }),
            metallic: metallic.value,
            ...(metallic.texture && { metallicTexture: metallic.texture }),
            ...(ior !== undefined && { ior }),
          }),
      ...(clearcoat && { clearcoat }),
      emissive: emissive.color,
      ...(emissive.texture && { emissiveTexture: emissive.texture }),
      roughness: roughness.value,
      ...(roughness.texture && { roughnessTexture: roughness.texture }),
      ...(normals && { normalTexture: normals.texture }),
      ...(occlusion.texture && { occlusionTexture: occlusion.texture }),
      opacity: opacity.value,
      opacityThreshold: numberOf(input('opacityThreshold').value) ?? 0,
      ...this.spectral(prim),
      ...(await this.measured(prim, diffuse.texture !== undefined || diffuse.primvar !== undefined)),
      ...unseen,
    };
    this.reportUnsupportedInputs(path, shader, input);
    const ofNumbers = [roughness.uv, metallic.uv, occlusion.uv, ...unseenUvs, ...coatUvs, specular?.uv];
    const uv = this.commonUv(path, [diffuse.uv, emissive.uv, opacity.uv, normals?.uv, ...ofNumbers]);
    return this.added(material, { ...(uv && { uv }), ...(diffuse.primvar && { colors: diffuse.primvar }) });
  }

  /** A surface of MaterialX that is read; undefined if there is none. */
  private async networkSurface(prim: PrimSpec, shaders: readonly PrimSpec[]): Promise<BoundMaterial | undefined> {
    if (!shaders.some(isMaterialX)) return undefined;
    const { isNetworkSurface, networkMaterial } = await import('./network/surfaces.ts');
    const shader = shaders.find(isNetworkSurface);
    if (!shader) return undefined;
    const found = await networkMaterial(await this.network(), shader);
    const { path } = prim;
    const { uvs: unseenUvs, ...unseen } = await this.invisibleLight(prim);
    const material: Material = {
      name: path,
      ...found.material,
      ...this.spectral(prim),
      ...(await this.measured(prim, found.isPainted)),
      ...unseen,
    };
    if (targetsOf(prim, 'outputs:mtlx:displacement').length > 0)
      report(this.context, 'info', 'mtlx.input', path, msg`its displacement is not drawn`);
    const uv = this.commonUv(path, [...found.uvs, ...unseenUvs]);
    return this.added(material, { ...(uv && { uv }), ...(found.colors && { colors: found.colors }) });
  }

  /** Nodes of MaterialX are read by code of their own, which is loaded with the first. */
  private async network(): Promise<ShadingNetwork> {
    const { ShadingNetwork } = await import('./network/network.ts');
    return new ShadingNetwork(this.context, this.textures);
  }

  private async networkInputs(shader: PrimSpec): Promise<SurfaceInputs> {
    const { NetworkReader } = await import('./network/networkReader.ts');
    return new NetworkReader(await this.network(), shader);
  }

  /** Ultraviolet and infrared reflectance and emission of the Material's `slowlight:` attributes. */
  private spectral(prim: PrimSpec): Partial<Material> {
    const value = (name: string): unknown => {
      const attribute = attributeOf(prim, name);
      if (targetsOf(prim, name).length > 0) return undefined;
      const found = valueAt(attribute, this.context.startCode);
      return attribute && (numberOf(found) ?? textOf(found) ?? attribute.typeName);
    };
    return parseSpectralHints(value, (message) => report(this.context, 'warning', 'usd.slowlight', prim.path, message));
  }

  /** A measured reflectance; undefined if a texture or vertex colours determine the colour. */
  private async measured(prim: PrimSpec, isPainted: boolean): Promise<Partial<Material>> {
    const value = valueAt(attributeOf(prim, REFLECTANCE_ATTRIBUTE), this.context.startCode);
    if (value === undefined) return {};
    const refusal =
      value.type !== 'asset'
        ? msg`${REFLECTANCE_ATTRIBUTE} is no asset, as @leaf.csv@; it is left out`
        : isPainted
          ? msg`${REFLECTANCE_ATTRIBUTE} is left out, for the surface is painted by its diffuseColor`
          : undefined;
    if (refusal === undefined) return reflectanceOfFile(this.context, prim, value);
    report(this.context, 'warning', 'usd.slowlight', prim.path, refusal);
    return {};
  }

  /** Textured ultraviolet and infrared reflectances, with their means and uvs. */
  private async invisibleLight(
    prim: PrimSpec,
  ): Promise<Partial<Material> & { readonly uvs: readonly ScalarInputValue['uv'][] }> {
    const { layer, startCode } = this.context;
    const found = await Promise.all(
      INVISIBLE_BANDS.map(async ({ of, texture, name }) => {
        const input = resolveInput(layer, prim, name, startCode);
        const scalar = input.shader ? await this.inputs.scalar(input, 0) : undefined;
        return { scalar, values: scalar?.texture ? { [of]: scalar.value, [texture]: scalar.texture } : {} };
      }),
    );
    return { ...Object.assign({}, ...found.map(({ values }) => values)), uvs: found.map(({ scalar }) => scalar?.uv) };
  }

  private added(material: Material, wants: Omit<BoundMaterial, 'index'>): BoundMaterial {
    return { index: this.materials.push(material) - 1, ...wants };
  }

  private async clearcoat(
    inputs: SurfaceInputs,
    input: (name: string) => ResolvedInput,
  ): Promise<{
    readonly clearcoat?: NonNullable<Material['clearcoat']>;
    readonly uvs: readonly ScalarInputValue['uv'][];
  }> {
    const factor = await inputs.scalar(input('clearcoat'), 0);
    if (factor.value <= 0 && !factor.texture) return { uvs: [] };
    const roughness = await inputs.scalar(input('clearcoatRoughness'), DEFAULT_COAT_ROUGHNESS);
    return {
      clearcoat: {
        factor: factor.value,
        ...(factor.texture && { factorTexture: factor.texture }),
        roughness: roughness.value,
        ...(roughness.texture && { roughnessTexture: roughness.texture }),
      },
      uvs: [factor.uv, roughness.uv],
    };
  }

  /** The uvs of the first texture: a mesh has only one set. */
  private commonUv(path: string, uvs: readonly (UvSource | undefined)[]): UvSource | undefined {
    const [first, ...more] = uvs.filter((uv) => uv !== undefined);
    const other = more.find((uv) => !isSameUv(uv, first));
    if (other) {
      const message =
        other.name === first.name
          ? msg`its textures use ${first.name} in two ways; the first is used for both`
          : msg`its textures use ${first.name} and ${other.name}; the first is used for both`;
      report(this.context, 'warning', 'usd.uv', path, message);
    }
    return first;
  }

  private reportUnsupportedInputs(path: string, shader: PrimSpec, input: (name: string) => ResolvedInput): void {
    const isWritten = (name: string): boolean =>
      input(name).shader !== undefined || (numberOf(input(name).value) ?? 0) > 0;
    const left = UNSUPPORTED_INPUTS.filter(isWritten);
    if (left.length > 0)
      report(this.context, 'info', 'usd.material-input', path, msg`${listed(left)} of this material is not drawn`);
    if (isAnimated(shader))
      report(
        this.context,
        'warning',
        'usd.animated-material',
        path,
        msg`it changes with time; it is held at the start`,
      );
  }

  /** A material of another renderer by its colours, metalness, roughness and one texture. */
  private async foreign(path: string, shader: PrimSpec, fallback: DisplayColor): Promise<BoundMaterial> {
    const surface = foreignMaterial(this.context, shader);
    const { texture: picture, color, ...finish } = surface ?? {};
    const image = picture && (await this.textures.file(picture, shader.path));
    const drawn = image
      ? msg`its picture and finish are`
      : color
        ? msg`its base colour and finish are`
        : msg`the displayColor is`;
    const message = msg`it is made of '${shaderName(shader)}', which is not read, and has no UsdPreviewSurface; ${drawn} drawn`;
    report(this.context, 'warning', 'usd.material', path, message);
    const baseColor = image ? WHITE : (color ?? fallback.color);
    const material = { ...DEFAULTS, ...finish, name: path, baseColor };
    if (!image) return color ? this.added(material, {}) : withDisplayColor(this.added(material, {}), fallback);
    const texture = { ...textureOf(this.context, shader, image, false), name: textOf(picture) ?? path };
    return this.added(
      { ...material, baseColorTexture: texture },
      image.tiles ? { uv: withTiles({ name: 'st' }, image.tiles) } : {},
    );
  }
}

/** Defaults of UsdPreviewSurface; grey for unbound meshes. */
const DEFAULTS: Omit<Material, 'name'> = {
  baseColor: [0.18, 0.18, 0.18],
  emissive: [0, 0, 0],
  roughness: 0.5,
  metallic: 0,
  opacity: 1,
  opacityThreshold: 0,
};

const BLACK: Vec3 = [0, 0, 0];
const WHITE: Vec3 = [1, 1, 1];
