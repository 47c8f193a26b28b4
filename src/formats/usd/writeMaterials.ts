import type { Material, Scene, Texture } from '../../scene/types.ts';
import { encodePng } from '../png.ts';
import type { PrimTree } from './primTree.ts';
import { block, double, float, floats, type Lines, quoted } from './usdaText.ts';

/** The scene's textures and the files they are written to: one for each picture, `textures/NAME.png`. */
export class TextureFiles {
  private readonly pathOf = new Map<Uint8Array, string>();
  private readonly textures = new Map<string, Texture>();

  constructor(scene: Scene) {
    for (const m of scene.materials) for (const t of [m.baseColorTexture, m.emissiveTexture]) if (t) this.add(t);
    for (const light of scene.lights) if (light.kind === 'dome' && light.texture) this.add(light.texture);
  }

  private add(texture: Texture): void {
    if (this.pathOf.has(texture.data)) return;
    const base =
      texture.name
        .split(/[/\\]/)
        .at(-1)!
        .replace(/\.[^.]*$/, '')
        .replaceAll(/[^\w-]/g, '_') || 'texture';
    let path = `textures/${base}.png`;
    for (let n = 1; this.textures.has(path); n++) path = `textures/${base}_${n}.png`;
    this.pathOf.set(texture.data, path);
    this.textures.set(path, texture);
  }

  path(texture: Texture): string {
    return this.pathOf.get(texture.data)!;
  }

  /** The PNGs by their paths. */
  encoded(): Map<string, Uint8Array> {
    return new Map([...this.textures].map(([path, t]) => [path, encodePng(t.width, t.height, t.data)]));
  }
}

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
    const properties = [`token outputs:surface.connect = <${path}/Surface.outputs:surface>`];
    this.tree.set(path, { type: 'Material', properties, inner: shaders });
    return path;
  }

  private network(path: string, m: Material, byColors: boolean): Lines[] {
    const { baseColorTexture: base, emissiveTexture: emissive } = m;
    const cutOut = base?.data.some((x, i) => i % 4 === 3 && x < 255);
    const diffuse = byColors ? `<${path}/Colors.outputs:result>` : base ? `<${path}/BaseColor.outputs:rgb>` : undefined;
    const surface = block('def Shader "Surface"', [
      'uniform token info:id = "UsdPreviewSurface"',
      input('color3f', 'diffuseColor', diffuse, floats(m.baseColor)),
      input('color3f', 'emissiveColor', emissive && `<${path}/Emissive.outputs:rgb>`, floats(m.emissive)),
      ...(m.ior === undefined ? [] : [`float inputs:ior = ${float(m.ior)}`]),
      `float inputs:metallic = ${float(m.metallic)}`,
      input('float', 'opacity', cutOut ? `<${path}/BaseColor.outputs:a>` : undefined, float(m.opacity)),
      `float inputs:opacityThreshold = ${float(m.opacityThreshold)}`,
      `float inputs:roughness = ${float(m.roughness)}`,
      'token outputs:surface',
    ]);
    return [
      surface,
      ...(byColors ? [colorReader()] : []),
      ...(base ? [this.texture(path, 'BaseColor', base, [...m.baseColor, m.opacity])] : []),
      ...(emissive ? [this.texture(path, 'Emissive', emissive, [...m.emissive, 1])] : []),
      ...(base || emissive ? [uvReader()] : []),
    ];
  }

  private texture(path: string, name: string, texture: Texture, scale: readonly number[]): Lines {
    return block(`def Shader "${name}"`, [
      'uniform token info:id = "UsdUVTexture"',
      `asset inputs:file = @${this.files.path(texture)}@`,
      `float4 inputs:scale = ${floats(scale)}`,
      `token inputs:sourceColorSpace = "${texture.colorSpace === 'srgb' ? 'sRGB' : 'raw'}"`,
      `float2 inputs:st.connect = <${path}/Uv.outputs:result>`,
      `token inputs:wrapS = "${texture.wrapS}"`,
      `token inputs:wrapT = "${texture.wrapT}"`,
      'float outputs:a',
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
