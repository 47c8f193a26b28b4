import { describe, expect, it } from 'vitest';
import { inEnglish } from '../../../../messages/message.ts';
import type { Material, Scene, SceneObject } from '../../../../scene/types.ts';
import { decodeSrgb } from '../../../../spectrum/display/srgb.ts';
import { memorySource } from '../../../files/fileSource.ts';
import { encodePng } from '../../../image/encodePng.ts';
import { readUsd } from '../../read.ts';

type Rgba = readonly [number, number, number, number];
/** A texture of one row. */
const row = (...pixels: readonly Rgba[]): Uint8Array => encodePng(pixels.length, 1, Uint8Array.from(pixels.flat()));
const PICTURES = { 'a.png': row([0, 64, 255, 128], [255, 64, 0, 255]) };

const MESH = `def Mesh "Quads" {
  uniform token subdivisionScheme = "none"
  rel material:binding = </M>
  int[] faceVertexCounts = [4, 4]
  int[] faceVertexIndices = [0, 1, 2, 3, 0, 1, 2, 3]
  point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
  texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] ( interpolation = "vertex" )
  color3f[] primvars:paint = [(1, 0, 0), (0, 1, 0)] ( interpolation = "uniform" )
`;

interface Read {
  readonly scene: Scene;
  readonly material: Material;
  readonly object: SceneObject;
  readonly said: readonly string[];
}

async function read(
  shaders: string,
  mesh = '}',
  files: Readonly<Record<string, Uint8Array>> = PICTURES,
): Promise<Read> {
  const text = `#usda 1.0\n(metersPerUnit = 1)\n${MESH}${mesh}\ndef Material "M" { token outputs:surface.connect = </M/S.outputs:surface>\n${shaders} }\n`;
  const scene = await readUsd(memorySource({ ...files, 'a.usda': new TextEncoder().encode(text) }), 'a.usda');
  const [object] = scene.objects;
  const said = scene.diagnostics.map((d) => `${d.code}: ${inEnglish(d.message)}`);
  return { scene, object, said, material: scene.materials[object.mesh.groups[0].material] };
}

const surface = (...lines: string[]): string =>
  `def Shader "S" { uniform token info:id = "UsdPreviewSurface"\n${lines.join('\n')}\ntoken outputs:surface }\n`;
const texture = (...lines: string[]): string =>
  `def Shader "T" { uniform token info:id = "UsdUVTexture"\nasset inputs:file = @a.png@\n${lines.join('\n')}\nfloat3 outputs:rgb\nfloat outputs:r\nfloat outputs:a }\n`;
const DIFFUSE = 'color3f inputs:diffuseColor.connect = </M/T.outputs:rgb>';

/** The value of a texel: linear, times the material's colour. */
function texels({ baseColor, baseColorTexture }: Material): number[][] {
  const { data, colorSpace } = baseColorTexture!;
  const linear = (x: number) => (colorSpace === 'srgb' ? decodeSrgb(x / 255) : x / 255);
  return [0, 4].map((i) => [0, 1, 2].map((k) => baseColor[k] * linear(data[i + k])));
}
const about = (v: readonly number[]) => v.map((x) => expect.closeTo(x, 2));

describe('textures', () => {
  it('are scaled, and shifted by a bias', async () => {
    const raw = 'token inputs:sourceColorSpace = "raw"';
    const { material, said } = await read(
      surface(DIFFUSE) + texture(raw, 'float4 inputs:scale = (2, 1, -1, 1)', 'float4 inputs:bias = (0.5, 0.25, 1, 0)'),
    );
    expect(texels(material)).toEqual([about([0.5, 0.5, 0]), about([2.5, 0.5, 1])]);
    expect(said).toEqual([]);
  });

  it('are read in their colour space, the bias in linear light', async () => {
    const { material } = await read(surface(DIFFUSE) + texture('float4 inputs:bias = (0.1, 0.1, 0.1, 0)'));
    expect(material.baseColorTexture!.colorSpace).toBe('srgb');
    expect(texels(material)[0]).toEqual(about([0.1, decodeSrgb(64 / 255) + 0.1, 1.1]));
  });

  it('can be read by a single channel', async () => {
    const { material } = await read(surface('color3f inputs:diffuseColor.connect = </M/T.outputs:r>') + texture());
    expect(texels(material)).toEqual([about([0, 0, 0]), about([1, 1, 1])]);
  });

  it('of one grey channel default to linear', async () => {
    // 1 × 1, grey, 8 bits (PNG, color type 0).
    const gray = Uint8Array.from(
      atob('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVQI12NoAAAAggCB3UNq9AAAAABJRU5ErkJggg=='),
      (c) => c.charCodeAt(0),
    );
    const space = async (...lines: string[]) =>
      (await read(surface(DIFFUSE) + texture(...lines), '}', { 'a.png': gray })).material.baseColorTexture?.colorSpace;
    expect(await space()).toBe('linear');
    expect(await space('token inputs:sourceColorSpace = "sRGB"')).toBe('srgb');
  });

  it('drive scalar inputs, with the mean as the constant value', async () => {
    const shaders =
      surface('float inputs:roughness.connect = </M/T.outputs:r>', 'float inputs:metallic.connect = </M/T.outputs:a>') +
      texture('float4 inputs:scale = (0.5, 1, 1, 2)', 'float4 inputs:bias = (0.25, 0, 0, -0.5)');
    const { material, said } = await read(shaders);
    expect(material.roughness).toBeCloseTo(0.5, 6);
    expect(material.roughnessTexture).toMatchObject({ channel: 0, scale: 0.5, bias: 0.25 });
    expect(material.metallicTexture).toMatchObject({ channel: 3, scale: 2, bias: -0.5 });
    expect(material.metallicTexture!.texture).toBe(material.roughnessTexture!.texture);
    expect(said).toEqual([]);
  });

  it('are normal maps: used unchanged with the usual scale and bias, otherwise converted', async () => {
    const normal = 'normal3f inputs:normal.connect = </M/T.outputs:rgb>';
    const raw = 'token inputs:sourceColorSpace = "raw"';
    const usual = await read(
      surface(normal) + texture(raw, 'float4 inputs:scale = (1, -3, 2, 1)', 'float4 inputs:bias = (-0.5, 1.5, -1, 0)'),
    );
    expect(usual.material.normalTexture).toMatchObject({ strength: [0.5, -1.5] });
    expect([...usual.material.normalTexture!.texture.data.subarray(0, 3)]).toEqual([0, 64, 255]);
    // Without a scale texels are normals: (0, 64/255, 1) and (1, 64/255, 0).
    const { strength, texture: made } = (await read(surface(normal) + texture(raw))).material.normalTexture!;
    const length = Math.hypot(64 / 255, 1);
    expect(strength).toEqual([1, 1]);
    expect(Array.from(made.data, (byte) => byte / 127.5 - 1)).toEqual([
      ...about([0, 64 / 255 / length, 1 / length, 1]),
      ...about([1 / length, 64 / 255 / length, 0, 1]),
    ]);
  });

  it('slowlight attributes set the reflectance of invisible light; invalid values are reported', async () => {
    const own = (...lines: string[]) => read(`${lines.map((line) => `custom ${line}`).join('\n')}\n${surface()}`);
    const { material } = await own('double slowlight:albedo:uv = 0.25', 'float slowlight:emission:temperature = 2000');
    expect(material).toMatchObject({ uv: 0.25, emissionTemperature: 2000 });
    const { material: bad, said } = await own(
      'double slowlight:albedo:uv = 7',
      'token slowlight:albedo:ir = "much"',
      'double slowlight:emission:temperature = nan',
    );
    expect([bad.uv, bad.ir, bad.emissionTemperature]).toEqual([undefined, undefined, undefined]);
    expect(said).toEqual([
      'usd.slowlight: slowlight:albedo:uv is 7, which is not a number from 0 to 1; it is left out',
      'usd.slowlight: slowlight:albedo:ir is "much", which is not a number from 0 to 1; it is left out',
      'usd.slowlight: slowlight:emission:temperature is NaN, which is not a number from 1 to 1e9 K; it is left out',
    ]);
  });

  it('can be cut-outs by any channel', async () => {
    const shaders = surface(
      DIFFUSE,
      'float inputs:opacity.connect = </M/T.outputs:r>',
      'float inputs:opacityThreshold = 0.5',
    );
    const { material } = await read(
      shaders + texture('float4 inputs:scale = (-1, 1, 1, 1)', 'float4 inputs:bias = (1, 0, 0, 0)'),
    );
    expect([3, 7].map((i) => material.baseColorTexture!.data[i])).toEqual([255, 0]);
    expect(material).toMatchObject({ opacity: 1, opacityThreshold: 0.5 });
  });

  it('that are missing are replaced by their fallback', async () => {
    const lines = ['float4 inputs:fallback = (0.2, 0.4, 0.6, 0.8)', 'asset inputs:file = @none.png@'];
    const shaders = surface(
      DIFFUSE,
      'float inputs:opacity.connect = </M/T.outputs:a>',
      'float inputs:roughness.connect = </M/T.outputs:r>',
    );
    const { material } = await read(shaders + texture(...lines).replace('asset inputs:file = @a.png@', ''));
    expect(material).toMatchObject({ opacity: expect.closeTo(0.8, 6), roughness: expect.closeTo(0.2, 6) });
    expect(material.baseColor).toEqual(about([0.2, 0.4, 0.6]));
  });

  it('follow their wrap modes', async () => {
    for (const [written, wrap] of [
      ['black', 'black'],
      ['clamp', 'clamp'],
      ['mirror', 'mirror'],
      ['useMetadata', 'repeat'],
    ]) {
      const { material } = await read(surface(DIFFUSE) + texture(`token inputs:wrapS = "${written}"`));
      expect(material.baseColorTexture).toMatchObject({ wrapS: wrap, wrapT: 'repeat' });
    }
  });

  it('that change with time, or have two transforms, are reported', async () => {
    const turned = (name: string, angle: string) =>
      `def Shader "${name}" { uniform token info:id = "UsdTransform2d"\nfloat2 inputs:in.connect = </M/R.outputs:result>\nfloat inputs:rotation${angle}\nfloat2 outputs:result }\n`;
    const reader =
      'def Shader "R" { uniform token info:id = "UsdPrimvarReader_float2"\nstring inputs:varname = "st"\nfloat2 outputs:result }\n';
    const second = texture('float2 inputs:st.connect = </M/B.outputs:result>').replace('"T"', '"U"');
    const { said } = await read(
      surface(DIFFUSE, 'color3f inputs:emissiveColor.connect = </M/U.outputs:rgb>') +
        texture('float2 inputs:st.connect = </M/A.outputs:result>') +
        second +
        turned('A', '.timeSamples = { 0: 0, 1: 90 }') +
        turned('B', ' = 45') +
        reader,
    );
    expect(said).toEqual([
      'usd.animated-material: it changes with time; it is held at the start',
      'usd.uv: its textures use st in two ways; the first is used for both',
    ]);
  });
});

describe('tiles', () => {
  const files = {
    't.1001.png': row([255, 0, 0, 255]),
    't.1002.png': row([0, 255, 0, 255], [0, 255, 0, 255]),
    't.1011.png': row([0, 0, 255, 255]),
  };
  const shaders = surface(DIFFUSE) + texture().replace('@a.png@', '@t.<UDIM>.png@');

  it('are combined, and their uvs adapted', async () => {
    const { material, object, said } = await read(shaders, '}', files);
    expect(said).toEqual([]);
    const { width, height, data, wrapS } = material.baseColorTexture!;
    expect([width, height, wrapS]).toEqual([4, 4, 'clamp']);
    const at = (x: number, y: number) => [...data.subarray(4 * (y * width + x), 4 * (y * width + x) + 3)];
    // Rows run from the top: 1011 is above 1001, 1002 on its right, nothing above that.
    expect([at(0, 3), at(3, 3), at(0, 0), at(3, 0)]).toEqual([
      [255, 0, 0],
      [0, 255, 0],
      [0, 0, 255],
      [0, 0, 0],
    ]);
    expect(Math.max(...object.mesh.uvs)).toBe(0.5);
  });

  it('that are missing are reported once', async () => {
    const { said } = await read(shaders, '}', {});
    expect(said).toEqual([expect.stringMatching(/^file.missing-texture: .*t.<UDIM>.png/)]);
  });
});

describe('colours of the mesh', () => {
  const reader = (name: string) =>
    `def Shader "C" { uniform token info:id = "UsdPrimvarReader_float3"\nstring inputs:varname = "${name}"\nfloat3 inputs:fallback = (0, 0, 1)\nfloat3 outputs:result }\n`;
  const shaders = surface('color3f inputs:diffuseColor.connect = </M/C.outputs:result>');

  it('are those that the material reads, or its fallback', async () => {
    const { object } = await read(shaders + reader('paint'));
    const { colors, indices } = object.mesh;
    const at = (corner: number) => [0, 1, 2].map((k) => colors![3 * indices[corner] + k]);
    expect([at(0), at(6)]).toEqual([
      [1, 0, 0],
      [0, 1, 0],
    ]);
    const { mesh } = (await read(shaders + reader('nothing'))).object;
    expect([...mesh.colors!.subarray(0, 3)]).toEqual([0, 0, 1]);
  });

  it('do not tint faces whose material reads none', async () => {
    const subset =
      'def GeomSubset "Part" { int[] indices = [1]\nrel material:binding = </N> } }\ndef Material "N" { token outputs:surface.connect = </N/S.outputs:surface>\ndef Shader "S" { uniform token info:id = "UsdPreviewSurface"\ntoken outputs:surface } }';
    const { object } = await read(shaders + reader('paint'), subset);
    const { colors, indices, groups } = object.mesh;
    const plain = groups.find(({ material }) => material !== groups[0].material)!;
    const colorAt = (corner: number) => [0, 1, 2].map((k) => colors![3 * indices[corner] + k]);
    expect([colorAt(groups[0].start), colorAt(plain.start)]).toContainEqual([1, 1, 1]);
    expect([colorAt(groups[0].start), colorAt(plain.start)]).toContainEqual([1, 0, 0]);
  });
});

describe('a specular workflow', () => {
  const shaders = (diffuse: string, specular: string) =>
    surface(
      'int inputs:useSpecularWorkflow = 1',
      `color3f inputs:diffuseColor = ${diffuse}`,
      `color3f inputs:specularColor = ${specular}`,
    );

  it('is a metal that scatters nothing, a refractive index of a grey one, and a tinted reflection of others', async () => {
    const gold = await read(shaders('(0, 0, 0)', '(1, 0.8, 0.3)'));
    expect(gold.material).toMatchObject({ metallic: 1, baseColor: about([1, 0.8, 0.3]) });
    expect(gold.said).toEqual([]);
    expect((await read(shaders('(0.5, 0, 0)', '(0.04, 0.04, 0.04)'))).material).toMatchObject({
      metallic: 0,
      ior: expect.closeTo(1.5, 5),
      baseColor: [0.5, 0, 0],
    });
    // F₀ = 0.04 times the tint, at the refractive index 1.5.
    expect((await read(shaders('(0.5, 0, 0)', '(0.2, 0.4, 1)'))).material).toMatchObject({
      metallic: 0,
      baseColor: [0.5, 0, 0],
      specular: { factor: 1, color: about([5, 10, 25]) },
    });
  });
});

it('a varnish is read with its roughness, 0.01 by default', async () => {
  const { material } = await read(surface('float inputs:clearcoat = 0.5'));
  expect(material.clearcoat).toEqual({ factor: 0.5, roughness: 0.01 });
});

describe('materials of other renderers', () => {
  const other = (id: string, ...lines: string[]) =>
    `def Shader "S" { uniform token info:id = "${id}"\n${lines.join('\n')}\ntoken outputs:surface }\n`;

  it('yield base colour, roughness and emission, and are reported once', async () => {
    const { material, said } = await read(
      other(
        'ai_standard_surface',
        'float inputs:base = 0.5',
        'color3f inputs:base_color = (1, 0.5, 0)',
        'float inputs:specular_roughness = 0.3',
        'float inputs:metalness = 1',
        'float inputs:emission = 2',
        'color3f inputs:emission_color = (0, 0, 1)',
      ),
    );
    expect(material).toMatchObject({
      baseColor: [0.5, 0.25, 0],
      metallic: 1,
      roughness: expect.closeTo(0.3, 6),
      emissive: [0, 0, 2],
    });
    expect(said).toEqual([
      "usd.material: it is made of 'ai_standard_surface', which is not read, and has no UsdPreviewSurface; its base colour and finish are drawn",
    ]);
  });

  it('yield the texture of their base colour', async () => {
    const { material, said } = await read(
      `${other('ai_standard_surface', 'color3f inputs:base_color.connect = </M/X.outputs:out>')}
      def Shader "X" { uniform token info:id = "ai_multiply"\ncolor3f inputs:in1.connect = </M/I.outputs:out>\ncolor3f outputs:out }
      def Shader "I" { uniform token info:id = "ai_image"\nasset inputs:file = @a.png@\ncolor3f outputs:out }`,
    );
    expect(material.baseColorTexture).toMatchObject({ name: 'a.png', width: 2 });
    expect(said).toEqual([expect.stringMatching(/its picture and finish are drawn$/)]);
  });

  it('are ignored if another context has a UsdPreviewSurface', async () => {
    const { material, said } = await read(
      `${other('PxrSurface')}token outputs:glslfx:surface.connect = </M/P.outputs:surface>\n${surface('color3f inputs:diffuseColor = (0, 1, 0)').replace('"S"', '"P"')}`,
    );
    expect(material.baseColor).toEqual([0, 1, 0]);
    expect(said).toEqual([]);
  });

  it('without any of these leave the displayColor', async () => {
    const mesh = 'color3f[] primvars:displayColor = [(0.1, 0.2, 0.3)] }';
    const { material, said } = await read(other('Weird'), mesh);
    expect(material.baseColor).toEqual(about([0.1, 0.2, 0.3]));
    expect(said).toEqual([expect.stringMatching(/'Weird', .* the displayColor is drawn$/)]);
  });
});

it('unsupported and animated inputs are reported', async () => {
  const { said } = await read(
    surface('float inputs:displacement = 1', 'float inputs:roughness.timeSamples = { 0: 0, 1: 1 }') + texture(),
  );
  expect(said).toEqual([
    'usd.material-input: displacement of this material is not drawn',
    'usd.animated-material: it changes with time; it is held at the start',
  ]);
});
