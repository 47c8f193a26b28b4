import type { Vec3 } from '../../../math/vec3.ts';
import type { Material, RadianceTexture, Scene, Texture, TextureChannel } from '../../../scene/types.ts';
import type { MeasuredReflectance } from '../../../spectrum/reflectance/measuredReflectance.ts';
import type { LightSpectrum, SampledSpectrum } from '../../../spectrum/sources/lightSpectrum.ts';
import { INVISIBLE_BANDS, REFLECTANCE_ATTRIBUTE, SPECTRAL_ATTRIBUTES } from '../../attributes/hints.ts';
import { formatSpectrum } from '../../attributes/spectrumAttribute.ts';
import { writeSpectrumCsv } from '../../attributes/spectrumCsv.ts';
import { encodeTexture } from '../../image/encodeTexture.ts';
import { encodeRadiance } from '../../image/radiance/radiance.ts';
import type { AttributeSpec, Value } from '../layer/layer.ts';
import { attribute, connected, custom, type PrimContent, type Properties, uniform } from '../layer/specs.ts';
import { asset, double, float, int, string, token, tuple } from '../layer/values.ts';
import { pictureOf, spectrumOf } from './lights/lights.ts';
import { isSpecularWorkflow } from './losses.ts';
import type { PrimTree } from './primTree.ts';

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
    m.clearcoat?.factorTexture?.texture,
    m.clearcoat?.roughnessTexture?.texture,
    isSpecularWorkflow(m) ? m.specular?.colorTexture : undefined,
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
  isRadiance(texture) ? encodeRadiance(texture) : encodeTexture(texture.width, texture.height, texture.data);

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
    const network = this.network(path, material, byColors);
    const unseen = INVISIBLE_BANDS.flatMap(({ texture, name, shader }) => {
      const from = material[texture];
      if (!from) return [];
      return [{ ...connected('double', name, network.output(shader, 'rgba'[from.channel])), custom: true }];
    });
    const told = SPECTRAL_ATTRIBUTES.flatMap(({ of, name }) => {
      const value = material[of];
      return value === undefined ? [] : [custom('double', name, double(value))];
    });
    const hints = new Map([...told, ...unseen].map((one) => [one.name, one]));
    const measured =
      material.reflectance && !byColors && !material.baseColorTexture
        ? [custom('asset', REFLECTANCE_ATTRIBUTE, asset(this.files.reflectance(material.reflectance)))]
        : [];
    const surface = connected('token', 'outputs:surface', network.output('Surface', 'surface'));
    this.tree.set(path, {
      type: 'Material',
      properties: [surface, ...hints.values(), ...measured],
      inner: network.shaders,
    });
    return path;
  }

  private network(path: string, m: Material, byColors: boolean): ShaderNetwork {
    const { baseColorTexture: base, emissiveTexture: emissive, normalTexture: normal } = m;
    const { roughnessTexture: roughness, metallicTexture: metallic, occlusionTexture: occlusion } = m;
    const { clearcoat: coat } = m;
    const tint = isSpecularWorkflow(m) ? specularColor(m) : undefined;
    const { factorTexture: factor, roughnessTexture: coatRoughness } = coat ?? {};
    const cutOut = base?.data.some((x, i) => i % 4 === 3 && x < 255);
    const network = new ShaderNetwork(path, this.tree);
    const from = (shader: string, output: string): string => network.output(shader, output);
    const diffuse = byColors ? from('Colors', 'result') : base && from('BaseColor', 'rgb');
    const rgb = (x: Vec3): Value => tuple('float3', x);
    network.add('Surface', [
      uniform('token', 'info:id', token('UsdPreviewSurface')),
      ...(coat
        ? [
            input('float', 'clearcoat', factor && from('Clearcoat', 'rgba'[factor.channel]), float(coat.factor)),
            input(
              'float',
              'clearcoatRoughness',
              coatRoughness && from('ClearcoatRoughness', 'rgba'[coatRoughness.channel]),
              float(coat.roughness),
            ),
          ]
        : []),
      input('color3f', 'diffuseColor', diffuse, rgb(m.baseColor)),
      input('color3f', 'emissiveColor', emissive && from('Emissive', 'rgb'), rgb(m.emissive)),
      ...(m.ior === undefined ? [] : [attribute('float', 'inputs:ior', float(m.ior))]),
      input('float', 'metallic', metallic && from('Metallic', 'rgba'[metallic.channel]), float(m.metallic)),
      ...(normal ? [connected('normal3f', 'inputs:normal', from('Normal', 'rgb'))] : []),
      ...(occlusion ? [connected('float', 'inputs:occlusion', from('Occlusion', 'rgba'[occlusion.channel]))] : []),
      input('float', 'opacity', cutOut ? from('BaseColor', 'a') : undefined, float(m.opacity)),
      attribute('float', 'inputs:opacityThreshold', float(m.opacityThreshold)),
      input('float', 'roughness', roughness && from('Roughness', 'rgba'[roughness.channel]), float(m.roughness)),
      ...(tint
        ? [
            input('color3f', 'specularColor', tint.texture && from('Specular', 'rgb'), rgb(tint.color)),
            attribute('int', 'inputs:useSpecularWorkflow', int(1)),
          ]
        : []),
      attribute('token', 'outputs:surface'),
    ]);
    if (tint?.texture) this.texture(network, 'Specular', tint.texture, [...tint.color, 1]);
    const [x, y] = normal?.strength ?? [1, 1];
    if (factor) this.channel(network, 'Clearcoat', factor);
    if (coatRoughness) this.channel(network, 'ClearcoatRoughness', coatRoughness);
    if (base) this.texture(network, 'BaseColor', base, [...m.baseColor, m.opacity]);
    if (emissive) this.texture(network, 'Emissive', emissive, [...m.emissive, 1]);
    if (normal) this.texture(network, 'Normal', normal.texture, [2 * x, 2 * y, 2, 1], [-x, -y, -1, 0]);
    if (roughness) this.channel(network, 'Roughness', roughness);
    if (metallic) this.channel(network, 'Metallic', metallic);
    if (occlusion) this.channel(network, 'Occlusion', occlusion);
    for (const { texture, shader } of INVISIBLE_BANDS) if (m[texture]) this.channel(network, shader, m[texture]);
    const textured = network.shaders.size > 1;
    if (byColors) network.add('Colors', reader('float3', 'displayColor'));
    if (textured) network.add('Uv', reader('float2', 'st'));
    return network;
  }

  private channel(network: ShaderNetwork, name: string, { texture, channel, scale, bias }: TextureChannel): void {
    const only = (value: number, otherwise: number) => [0, 1, 2, 3].map((k) => (k === channel ? value : otherwise));
    this.texture(network, name, texture, only(scale, 1), only(bias, 0));
  }

  private texture(
    network: ShaderNetwork,
    name: string,
    texture: Texture,
    scale: readonly number[],
    bias: readonly number[] = [0, 0, 0, 0],
  ): void {
    network.add(name, [
      uniform('token', 'info:id', token('UsdUVTexture')),
      ...(bias.some((x) => x !== 0) ? [attribute('float4', 'inputs:bias', tuple('float4', bias))] : []),
      attribute('asset', 'inputs:file', asset(this.files.path(texture))),
      attribute('float4', 'inputs:scale', tuple('float4', scale)),
      attribute('token', 'inputs:sourceColorSpace', token(texture.colorSpace === 'srgb' ? 'sRGB' : 'raw')),
      connected('float2', 'inputs:st', network.output('Uv', 'result')),
      attribute('token', 'inputs:wrapS', token(texture.wrapS)),
      attribute('token', 'inputs:wrapT', token(texture.wrapT)),
      ...['a', 'b', 'g', 'r'].map((channel) => attribute('float', `outputs:${channel}`)),
      attribute('float3', 'outputs:rgb'),
      custom('token', 'slowlight:filter', token(texture.filter)),
    ]);
  }
}

/** F₀ of a dielectric, its colour in the specular workflow. */
function specularColor({ specular, ior = 1.5 }: Material): { readonly color: Vec3; readonly texture?: Texture } {
  const F0 = ((ior - 1) / (ior + 1)) ** 2;
  const { factor, color, colorTexture } = specular!;
  const [r, g, b] = color.map((x) => Math.min(F0 * x, 1) * factor);
  return { color: [r, g, b], ...(colorTexture && { texture: colorTexture }) };
}

/** The shaders of one material, by the names of their prims. */
class ShaderNetwork {
  readonly shaders = new Map<string, PrimContent>();
  private readonly path: string;
  private readonly tree: PrimTree;

  constructor(path: string, tree: PrimTree) {
    this.path = path;
    this.tree = tree;
  }

  /** The path of what comes out of a shader. */
  output(shader: string, name: string): string {
    return `${this.path}/${this.tree.innerName(this.path, shader)}.outputs:${name}`;
  }

  add(name: string, properties: Properties): void {
    this.shaders.set(this.tree.innerName(this.path, name), { type: 'Shader', properties });
  }
}

const input = (type: string, name: string, connection: string | undefined, value: Value): AttributeSpec =>
  connection ? connected(type, `inputs:${name}`, connection) : attribute(type, `inputs:${name}`, value);

const reader = (type: string, primvar: string): Properties => [
  uniform('token', 'info:id', token(`UsdPrimvarReader_${type}`)),
  attribute('string', 'inputs:varname', string(primvar)),
  attribute(type, 'outputs:result'),
];
