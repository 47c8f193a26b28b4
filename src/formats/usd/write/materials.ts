import type { Material, RadianceTexture, Scene, Texture, TextureChannel } from '../../../scene/types.ts';
import type { MeasuredReflectance } from '../../../spectrum/reflectance/measuredReflectance.ts';
import type { LightSpectrum, SampledSpectrum } from '../../../spectrum/sources/lightSpectrum.ts';
import { INVISIBLE_BANDS, REFLECTANCE_ATTRIBUTE, SPECTRAL_ATTRIBUTES } from '../../attributes/hints.ts';
import { formatSpectrum } from '../../attributes/spectrumAttribute.ts';
import { writeSpectrumCsv } from '../../attributes/spectrumCsv.ts';
import { encodePng } from '../../image/encodePng.ts';
import { encodeRadiance } from '../../image/radiance.ts';
import { pictureOf, spectrumOf } from './lights/lights.ts';
import type { PrimTree } from './primTree.ts';
import { block, double, float, floats, type Lines, quoted } from './usdaText.ts';

const texturesOf = (m: Material): readonly Texture[] =>
  [
    m.baseColorTexture,
    m.emissiveTexture,
    m.normalTexture?.texture,
    m.roughnessTexture?.texture,
    m.metallicTexture?.texture,
    m.occlusionTexture?.texture,
    m.uvTexture?.texture,
    m.irTexture?.texture,
  ].filter((texture) => texture !== undefined);

/** The scene's textures and spectra, and the files they are written to: one for each picture, `textures/NAME.png`, `.exr` of radiance, `spectra/spectrum.csv`. */
export class TextureFiles {
  private readonly pathOf = new Map<object, string>();
  private readonly textures = new Map<string, WrittenTexture>();
  private readonly tables = new Map<string, Uint8Array>();

  constructor(scene: Scene) {
    for (const material of scene.materials) {
      for (const texture of texturesOf(material)) this.add(texture);
      if (material.reflectance) this.addTable(material.reflectance, 'reflectance');
    }
    for (const light of scene.lights) {
      const [picture, spectrum] = [pictureOf(light), spectrumOf(light)];
      if (picture) this.add(picture);
      if (spectrum && isTable(spectrum)) this.addTable(spectrum, 'spectrum');
    }
  }

  private addTable(table: MeasuredReflectance, of: 'spectrum' | 'reflectance'): void {
    if (this.pathOf.has(table)) return;
    let path = `spectra/${of}.csv`;
    for (let n = 1; this.tables.has(path); n++) path = `spectra/${of}_${n}.csv`;
    this.pathOf.set(table, path);
    this.tables.set(path, writeSpectrumCsv(table, of === 'spectrum' ? 'relative radiance' : of));
  }

  /** The table of a spectrum that has no name of its own. */
  spectrum(spectrum: LightSpectrum): string | undefined {
    return isTable(spectrum) ? this.pathOf.get(spectrum) : undefined;
  }

  reflectance(reflectance: MeasuredReflectance): string {
    return this.pathOf.get(reflectance)!;
  }

  private add(texture: WrittenTexture): void {
    if (this.pathOf.has(texture.data)) return;
    const base =
      texture.name
        .split(/[/\\]/)
        .at(-1)!
        .replace(/\.[^.]*$/, '')
        .replaceAll(/[^\w-]/g, '_') || 'texture';
    const kind = isRadiance(texture) ? 'exr' : 'png';
    let path = `textures/${base}.${kind}`;
    for (let n = 1; this.textures.has(path); n++) path = `textures/${base}_${n}.${kind}`;
    this.pathOf.set(texture.data, path);
    this.textures.set(path, texture);
  }

  path(texture: WrittenTexture): string {
    return this.pathOf.get(texture.data)!;
  }

  /** The PNGs, EXRs and tables by their paths. */
  encoded(): Map<string, Uint8Array> {
    const pictures = [...this.textures].map(([path, texture]) => [path, encode(texture)] as const);
    return new Map([...pictures, ...this.tables]);
  }
}

const isTable = (spectrum: LightSpectrum): spectrum is SampledSpectrum =>
  spectrum.kind === 'sampled' && formatSpectrum(spectrum) === undefined;

type WrittenTexture = Texture | RadianceTexture;
const isRadiance = (texture: WrittenTexture): texture is RadianceTexture => texture.data instanceof Uint16Array;
const encode = (texture: WrittenTexture): Uint8Array =>
  isRadiance(texture) ? encodeRadiance(texture) : encodePng(texture.width, texture.height, texture.data);

/**
 * Writes materials as UsdPreviewSurface networks, each when it is first bound. One that is worn with vertex colours is
 * written apart, because there its diffuse colour is the mesh's displayColor.
 */
export class MaterialWriter {
  private readonly scene: Scene;
  private readonly tree: PrimTree;
  private readonly files: TextureFiles;
  private readonly paths = new Map<string, string>();

  constructor(scene: Scene, tree: PrimTree, files: TextureFiles) {
    this.scene = scene;
    this.tree = tree;
    this.files = files;
  }

  /** The path of material `index`, as it is on meshes with or without vertex colours. */
  path(index: number, colored: boolean): string {
    const material = this.scene.materials[index];
    const byColors = colored && !material.baseColorTexture;
    const key = `${index} ${byColors}`;
    const known = this.paths.get(key);
    if (known !== undefined) return known;
    const wanted = material.name.startsWith('/') ? material.name : `/Materials/${material.name || 'Material'}`;
    const path = this.tree.claim(byColors ? `${wanted}_vertexColors` : wanted);
    this.paths.set(key, path);
    const shaders = this.network(path, material, byColors);
    const unseen = INVISIBLE_BANDS.flatMap(({ texture, name, shader }) => {
      const from = material[texture];
      return from ? [[name, `.connect = <${path}/${shader}.outputs:${'rgba'[from.channel]}>`] as const] : [];
    });
    const told = SPECTRAL_ATTRIBUTES.flatMap(({ of, name }) => {
      const value = material[of];
      return value === undefined ? [] : [[name, ` = ${double(value)}`] as const];
    });
    const hints = [...new Map<string, string>([...told, ...unseen])].map(([name, is]) => `custom double ${name}${is}`);
    const measured =
      material.reflectance && !byColors && !material.baseColorTexture
        ? [`custom asset ${REFLECTANCE_ATTRIBUTE} = @${this.files.reflectance(material.reflectance)}@`]
        : [];
    const properties = [`token outputs:surface.connect = <${path}/Surface.outputs:surface>`, ...hints, ...measured];
    this.tree.set(path, { type: 'Material', properties, inner: shaders });
    return path;
  }

  private network(path: string, m: Material, byColors: boolean): Lines[] {
    const { baseColorTexture: base, emissiveTexture: emissive, normalTexture: normal } = m;
    const { roughnessTexture: roughness, metallicTexture: metallic, occlusionTexture: occlusion } = m;
    const cutOut = base?.data.some((x, i) => i % 4 === 3 && x < 255);
    const from = (shader: string, output: string): string => `<${path}/${shader}.outputs:${output}>`;
    const diffuse = byColors ? from('Colors', 'result') : base && from('BaseColor', 'rgb');
    const surface = block('def Shader "Surface"', [
      'uniform token info:id = "UsdPreviewSurface"',
      input('color3f', 'diffuseColor', diffuse, floats(m.baseColor)),
      input('color3f', 'emissiveColor', emissive && from('Emissive', 'rgb'), floats(m.emissive)),
      ...(m.ior === undefined ? [] : [`float inputs:ior = ${float(m.ior)}`]),
      input('float', 'metallic', metallic && from('Metallic', 'rgba'[metallic.channel]), float(m.metallic)),
      ...(normal ? [`normal3f inputs:normal.connect = ${from('Normal', 'rgb')}`] : []),
      ...(occlusion ? [`float inputs:occlusion.connect = ${from('Occlusion', 'rgba'[occlusion.channel])}`] : []),
      input('float', 'opacity', cutOut ? from('BaseColor', 'a') : undefined, float(m.opacity)),
      `float inputs:opacityThreshold = ${float(m.opacityThreshold)}`,
      input('float', 'roughness', roughness && from('Roughness', 'rgba'[roughness.channel]), float(m.roughness)),
      'token outputs:surface',
    ]);
    const [x, y] = normal?.strength ?? [1, 1];
    const textures = [
      ...(base ? [this.texture(path, 'BaseColor', base, [...m.baseColor, m.opacity])] : []),
      ...(emissive ? [this.texture(path, 'Emissive', emissive, [...m.emissive, 1])] : []),
      ...(normal ? [this.texture(path, 'Normal', normal.texture, [2 * x, 2 * y, 2, 1], [-x, -y, -1, 0])] : []),
      ...(roughness ? [this.channel(path, 'Roughness', roughness)] : []),
      ...(metallic ? [this.channel(path, 'Metallic', metallic)] : []),
      ...(occlusion ? [this.channel(path, 'Occlusion', occlusion)] : []),
      ...INVISIBLE_BANDS.flatMap(({ texture, shader }) => (m[texture] ? [this.channel(path, shader, m[texture])] : [])),
    ];
    const readers = [...(byColors ? [colorReader()] : []), ...(textures.length > 0 ? [uvReader()] : [])];
    return [surface, ...textures, ...readers];
  }

  private channel(path: string, name: string, { texture, channel, scale, bias }: TextureChannel): Lines {
    const only = (value: number, otherwise: number) => [0, 1, 2, 3].map((k) => (k === channel ? value : otherwise));
    return this.texture(path, name, texture, only(scale, 1), only(bias, 0));
  }

  private texture(
    path: string,
    name: string,
    texture: Texture,
    scale: readonly number[],
    bias: readonly number[] = [0, 0, 0, 0],
  ): Lines {
    return block(`def Shader "${name}"`, [
      'uniform token info:id = "UsdUVTexture"',
      ...(bias.some((x) => x !== 0) ? [`float4 inputs:bias = ${floats(bias)}`] : []),
      `asset inputs:file = @${this.files.path(texture)}@`,
      `float4 inputs:scale = ${floats(scale)}`,
      `token inputs:sourceColorSpace = "${texture.colorSpace === 'srgb' ? 'sRGB' : 'raw'}"`,
      `float2 inputs:st.connect = <${path}/Uv.outputs:result>`,
      `token inputs:wrapS = "${texture.wrapS}"`,
      `token inputs:wrapT = "${texture.wrapT}"`,
      ...['a', 'b', 'g', 'r'].map((channel) => `float outputs:${channel}`),
      'float3 outputs:rgb',
      `custom token slowlight:filter = "${texture.filter}"`,
    ]);
  }
}

const input = (type: string, name: string, connection: string | undefined, value: string): string =>
  connection ? `${type} inputs:${name}.connect = ${connection}` : `${type} inputs:${name} = ${value}`;

const uvReader = (): Lines => reader('Uv', 'float2', 'st');
const colorReader = (): Lines => reader('Colors', 'float3', 'displayColor');

const reader = (name: string, type: string, primvar: string): Lines =>
  block(`def Shader "${name}"`, [
    `uniform token info:id = "UsdPrimvarReader_${type}"`,
    `string inputs:varname = "${primvar}"`,
    `${type} outputs:result`,
  ]);

/** What the author suggests, as the layer's `customLayerData`. */
export function hintLines({ hints }: Scene): Lines {
  const { speedOfLight, title, lookFor, beta, openAt } = hints;
  const entries = [
    ...(beta ? [`double3 beta = (${beta.map(double).join(', ')})`] : []),
    ...(lookFor !== undefined ? [`string lookFor = ${quoted(lookFor)}`] : []),
    ...(openAt !== undefined ? [`double openAt = ${double(openAt)}`] : []),
    ...(speedOfLight !== undefined ? [`double speedOfLight = ${double(speedOfLight)}`] : []),
    ...(title !== undefined ? [`string title = ${quoted(title)}`] : []),
  ];
  if (entries.length === 0) return [];
  const inner = ['    dictionary slowlight = {', ...entries.map((e) => `        ${e}`), '    }'];
  return ['customLayerData = {', ...inner, '}'];
}
