import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { inEnglish } from '../../../messages/message.ts';
import type { Material, Scene } from '../../../scene/types.ts';
import { memorySource } from '../../files/fileSource.ts';
import { decodeImage } from '../../image/decodeImage.ts';
import { encodePng } from '../../image/encodePng.ts';
import { readUsd } from '../read.ts';
import { MAX_DOCUMENTS } from './documents.ts';
import { MAX_XML_DEPTH } from './xml.ts';

const corpus = (name: string): Uint8Array =>
  new Uint8Array(readFileSync(new URL(`../../../../tests/fuzz/corpus/${name}`, import.meta.url)));
const LOOK = { 'look.mtlx': corpus('look.mtlx'), 'wood.png': corpus('wood.png') };

/** A square with uvs and a colour, bound to a material of `look.mtlx`. */
const stage = (material: string, file = 'look.mtlx'): string => `#usda 1.0
( metersPerUnit = 1 )
def Mesh "A" ( prepend apiSchemas = ["MaterialBindingAPI"] ) {
  int[] faceVertexCounts = [4]
  int[] faceVertexIndices = [0, 1, 2, 3]
  point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
  uniform token subdivisionScheme = "none"
  texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] ( interpolation = "vertex" )
  color3f[] primvars:displayColor = [(0.5, 0.25, 0.125), (1, 0, 0), (0, 1, 0), (0, 0, 1)] ( interpolation = "vertex" )
  rel material:binding = </Looks/${material}>
}
def NameScope "Looks" ( references = @${file}@</MaterialX/Materials> ) {
}
`;
const read = (material: string, files: Record<string, string | Uint8Array> = LOOK): Promise<Scene> =>
  readUsd(memorySource({ ...bytes(files), 'a.usda': encoded(stage(material)) }), 'a.usda');
const encoded = (text: string): Uint8Array => new TextEncoder().encode(text);
const bytes = (files: Record<string, string | Uint8Array>): Record<string, Uint8Array> =>
  Object.fromEntries(Object.entries(files).map(([name, x]) => [name, typeof x === 'string' ? encoded(x) : x]));
const worn = ({ materials, objects }: Scene): Material => materials[objects[0].mesh.groups[0].material];
const said = ({ diagnostics }: Scene): string[] =>
  diagnostics.map(({ code, message, place }) => `${code} ${inEnglish(place)}: ${inEnglish(message)}`);

/** A document whose material has the given inputs of standard_surface. */
const document = (inputs: string, more = ''): string => `<?xml version="1.0"?>
<materialx version="1.39">${more}
  <standard_surface name="S" type="surfaceshader">${inputs}</standard_surface>
  <surfacematerial name="M" type="material">
    <input name="surfaceshader" type="surfaceshader" nodename="S" />
  </surfacematerial>
</materialx>`;
const readDocument = (text: string, more: Record<string, string | Uint8Array> = {}): Promise<Scene> =>
  read('M', { ...more, 'look.mtlx': text });

/** A picture of 2 × 1 texels. */
const TWO = encodePng(2, 1, Uint8Array.of(51, 102, 255, 255, 0, 204, 153, 255));

describe('a MaterialX document in a USD layer', () => {
  it('keeps the texture of a colour, and what it is multiplied by', async () => {
    const material = worn(await read('wood'));
    expect(material.baseColorTexture).toMatchObject({ name: './wood.png', colorSpace: 'srgb', wrapS: 'mirror' });
    // base · faded · tint; the tint is in ACEScg, its matrix as MaterialX has it.
    const [r, g, b] = [0.5, 0.25, 1];
    const tint = [
      1.705050992658 * r - 0.621792120657 * g - 0.083258872001 * b,
      -0.130256417507 * r + 1.140804736575 * g - 0.010548319068 * b,
      -0.024003356805 * r - 0.128968976065 * g + 1.15297233287 * b,
    ];
    for (const [k, x] of tint.entries()) expect(material.baseColor[k]).toBeCloseTo(0.5 * 0.25 * x, 6);
  });

  it('inverts a texture of numbers, scales normals, and weakens reflection', async () => {
    const material = worn(await read('wood'));
    expect(material.roughnessTexture).toMatchObject({ channel: 0, scale: -1, bias: 1 });
    expect(material.normalTexture?.strength).toEqual([0.5, 0.5]);
    expect(material.specular).toEqual({ factor: 0.25, color: [1, 1, 1] });
    expect(material.clearcoat).toEqual({ factor: 1, roughness: 0.1 });
  });

  it('places a texture as place2d does', async () => {
    const { objects } = await read('wood');
    const { uvs } = objects[0].mesh;
    const [cos, sin] = [Math.cos(Math.PI / 6), Math.sin(Math.PI / 6)];
    const expected = [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ].map(([u, v]) => {
      const [x, y] = [u / 0.5, v / 2];
      return [cos * x + sin * y - 0.25, -sin * x + cos * y + 0.5];
    });
    const found = Array.from({ length: uvs.length / 2 }, (_, k) => [uvs[2 * k], uvs[2 * k + 1]]);
    for (const [u, v] of expected)
      expect(
        found.some(([x, y]) => Math.abs(x - u) + Math.abs(y - v) < 1e-6),
        `${u}, ${v}`,
      ).toBe(true);
  });

  it('computes constants, reads vertex colours and opacity', async () => {
    const scene = await read('glow');
    expect(worn(scene)).toMatchObject({ emissive: [2, 0, 2], metallic: 0.5, opacity: 0.5, roughness: 1 });
    expect([...scene.objects[0].mesh.colors!.subarray(0, 3)]).toEqual([0.5, 0.25, 0.125]);
  });

  it('lets light pass: a sheet that is thin, a body that absorbs', async () => {
    const sheet = worn(await read('glass'));
    expect(sheet).toMatchObject({ opacity: 1, ior: 1.25, transmission: { factor: 0.75 } });
    expect(sheet).not.toHaveProperty('volume');
    // A quarter of the base, three quarters of the tint: 0.8/4 + 0.75.
    for (const x of sheet.baseColor) expect(x).toBeCloseTo(0.95, 6);
    const bodyOf = (inputs: string): Promise<Scene> =>
      readDocument(document(`<input name="transmission" type="float" value="1" />${inputs}`));
    const tint = '<input name="transmission_color" type="color3" value="0.5, 0.25, 1" />';
    const dyed = worn(await bodyOf(tint));
    expect(dyed).toMatchObject({
      baseColor: [0.5, 0.25, 1],
      volume: { attenuationDistance: Number.POSITIVE_INFINITY },
    });
    const deep = worn(
      await bodyOf(
        `${tint}<input name="transmission_depth" type="float" value="2" /><input name="transmission_dispersion" type="float" value="40" />`,
      ),
    );
    expect(deep).toMatchObject({
      baseColor: [1, 1, 1],
      volume: { attenuationColor: [0.5, 0.25, 1], attenuationDistance: 2 },
      dispersion: 0.5,
    });
  });

  it('reads thin films, in nanometres', async () => {
    const film =
      '<input name="thin_film_thickness" type="float" value="400" /><input name="thin_film_IOR" type="float" value="1.25" />';
    const scene = await readDocument(document(film));
    expect(said(scene)).toEqual([]);
    const { iridescence } = worn(scene);
    expect(iridescence).toMatchObject({ factor: 1, ior: 1.25 });
    for (const x of iridescence!.thickness) expect(x).toBeCloseTo(4e-7, 15);
    expect(worn(await readDocument(document('')))).not.toHaveProperty('iridescence');
  });

  it('reads sheen, whose roughness is the width of its distribution', async () => {
    const sheen =
      '<input name="sheen" type="float" value="0.5" /><input name="sheen_color" type="color3" value="1, 0.5, 0" /><input name="sheen_roughness" type="float" value="0.25" />';
    const scene = await readDocument(document(sheen));
    expect(said(scene)).toEqual([]);
    // α = roughness².
    expect(worn(scene).sheen).toEqual({ color: [0.5, 0.25, 0], roughness: 0.5 });
    expect(worn(await readDocument(document('')))).not.toHaveProperty('sheen');
  });

  it('reads UsdPreviewSurface', async () => {
    expect(worn(await read('plain'))).toMatchObject({ baseColor: [0.25, 0.5, 0.75], roughness: 0.125 });
  });

  it('computes a picture where a factor is not enough', async () => {
    const graph = `<nodegraph name="N"><image name="i" type="color3"><input name="file" type="filename" value="two.png" /></image>
      <power name="p" type="color3"><input name="in1" type="color3" nodename="i" /><input name="in2" type="float" value="2" /></power>
      <output name="out" type="color3" nodename="p" /></nodegraph>`;
    const text = document('<input name="base_color" type="color3" nodegraph="N" output="out" />', graph);
    const { baseColorTexture } = worn(await readDocument(text, { 'two.png': TWO }));
    // Linear: (0.2, 0.4, 1)² and (0, 0.8, 0.6)², stored as sRGB.
    const srgb = (x: number): number => Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
    const [a, b] = [
      [0.2, 0.4, 1],
      [0, 0.8, 0.6],
    ].map((rgb) => rgb.map((x) => srgb(x * x)));
    expect([...baseColorTexture!.data]).toEqual([...a, 255, ...b, 255]);
  });

  it('takes a picture as it is where it is mixed with itself', async () => {
    const image = (name: string): string =>
      `<image name="${name}" type="color3"><input name="file" type="filename" value="two.png" /></image>`;
    const of = (node: string): Promise<Scene> =>
      readDocument(
        document(
          `<input name="base_color" type="color3" nodename="i" /><input name="subsurface" type="float" nodename="w" />
           <input name="subsurface_color" type="color3" nodename="${node}" />`,
          `${image('i')}${image('same')}<invert name="other" type="color3"><input name="in" type="color3" nodename="i" /></invert>
           <image name="w" type="float"><input name="file" type="filename" value="two.png" /></image>`,
        ),
        { 'two.png': TWO },
      );
    for (const node of ['i', 'same'])
      expect(worn(await of(node)).baseColorTexture).toMatchObject({ name: 'two.png', data: decodeImage(TWO, '').data });
    // x (1 − w) + (1 − x) w, with w the first number of each texel, 0.2 and 0.
    const { data } = worn(await of('other')).baseColorTexture!;
    const linear = (byte: number): number =>
      byte / 255 <= 0.04045 ? byte / 3294.6 : ((byte / 255 + 0.055) / 1.055) ** 2.4;
    const expected = [0.32, 0.44, 0.8, 0, 0.8, 0.6];
    for (const [k, x] of expected.entries()) expect(linear(data[k + Math.floor(k / 3)])).toBeCloseTo(x, 2);
  });

  it('says what it does not draw, with node and value', async () => {
    const text = document(
      '<input name="base_color" type="color3" nodename="n" /><input name="diffuse_roughness" type="float" value="0.5" /><input name="metalness" type="float" value="much" />',
      '<wavy name="n" type="color3" />',
    );
    const scene = await readDocument(text);
    const all = said(scene).join('\n');
    expect(all).toContain("mtlx.node a.usda</Looks/M/NodeGraphs/n>: the node 'ND_wavy_color3' is not read");
    expect(all).toContain('diffuse_roughness of this material is not drawn');
    expect(all).toMatch(
      /mtlx\.value look\.mtlx: look\.mtlx, line 3: .*'metalness' of <standard_surface> 'S' has the value 'much', which is no float/,
    );
    expect(worn(scene)).toMatchObject({ metallic: 0, roughness: expect.closeTo(0.2, 6) });
  });

  describe('anisotropy has the widths of GGX along and across its direction', () => {
    const number = (name: string, value: number): string => `<input name="${name}" type="float" value="${value}" />`;
    const widths = ({ anisotropy, roughness }: Material): number[] => {
      const across = roughness ** 2;
      return [across + (1 - across) * anisotropy!.strength ** 2, across];
    };

    // As MaterialX's pbrlib and bxdf libraries have them.
    it.each([
      [
        'standard_surface',
        ['specular_roughness', 'specular_anisotropy', 'specular_rotation'],
        [0.25 / Math.SQRT1_2, 0.25 * Math.SQRT1_2],
        -Math.PI,
      ],
      [
        'open_pbr_surface',
        ['specular_roughness', 'specular_roughness_anisotropy'],
        [0.25 * Math.sqrt(1.6), 0.125 * Math.sqrt(1.6)],
        0,
      ],
      ['gltf_pbr', ['roughness', 'anisotropy_strength', 'anisotropy_rotation'], [0.25 + 0.75 * 0.25, 0.25], 0.5],
      ['disney_principled', ['roughness', 'anisotropic'], [0.25 / Math.SQRT1_2, 0.25 * Math.SQRT1_2], 0],
    ] as const)('of %s', async (surface, inputs, expected, rotation) => {
      const text = document(inputs.map((name) => number(name, 0.5)).join('')).replaceAll('standard_surface', surface);
      const material = worn(await readDocument(text));
      for (const [k, width] of widths(material).entries()) expect(width).toBeCloseTo(expected[k], 6);
      expect(material.anisotropy!.rotation).toBeCloseTo(rotation, 6);
    });

    it('and varies with pictures', async () => {
      const image = '<image name="i" type="float"><input name="file" type="filename" value="two.png" /></image>';
      const of = (input: string, other: string): string =>
        document(`<input name="${input}" type="float" nodename="i" />${number(other, 0.5)}`, image);
      const rough = worn(await readDocument(of('specular_roughness', 'specular_anisotropy'), { 'two.png': TWO }));
      const directed = worn(await readDocument(of('specular_anisotropy', 'specular_roughness'), { 'two.png': TWO }));
      // The first numbers of the texels: 0.2 and 0, of roughness and then of anisotropy.
      for (const [{ anisotropy, roughnessTexture: texture }, texels] of [
        [
          rough,
          [
            [0.2, 0.5],
            [0, 0.5],
          ],
        ],
        [
          directed,
          [
            [0.5, 0.2],
            [0.5, 0],
          ],
        ],
      ] as const)
        for (const [k, [r, s]] of texels.entries()) {
          const direction = anisotropy!.directionTexture!.data;
          const drawn = texture!.scale * (texture!.texture.data[4 * k + texture!.channel] / 255) + texture!.bias;
          const strength = anisotropy!.strength * (direction[4 * k + 2] / 255);
          expect([direction[4 * k], direction[4 * k + 1]]).toEqual([255, 128]);
          expect(drawn).toBeCloseTo(r * (1 - s) ** 0.25, 2);
          expect(drawn ** 2 + (1 - drawn ** 2) * strength ** 2).toBeCloseTo(r ** 2 / Math.sqrt(1 - s), 2);
        }
    });
  });

  it('includes documents', async () => {
    const shader =
      '<materialx version="1.39"><constant name="c" type="color3"><input name="value" type="color3" value="0, 1, 0" /></constant></materialx>';
    const text = document(
      '<input name="base_color" type="color3" nodename="c" />',
      '<xi:include href="more/c.mtlx" />',
    );
    expect(worn(await readDocument(text, { 'more/c.mtlx': shader })).baseColor).toEqual([0, 1, 0]);
  });

  const including = (href: string): string => document('', `<xi:include href="${href}" />`);
  const chain = Object.fromEntries(
    Array.from({ length: MAX_DOCUMENTS }, (_, k) => [`c${k}.mtlx`, including(`c${k + 1}.mtlx`)]),
  );
  it.each([
    ['an element that is not closed', '<materialx version="1.39"><a>', {}, 'line 1'],
    [
      'entities of its own',
      '<!DOCTYPE a [<!ENTITY b "c">]><materialx version="1.39">&b;</materialx>',
      {},
      'undefined entity',
    ],
    ['another root', '<html />', {}, 'its first element is <html>'],
    ['an unknown version', '<materialx version="2.0" />', {}, "version '2.0'"],
    [
      'deep elements',
      `<materialx version="1.39">${'<a>'.repeat(MAX_XML_DEPTH)}${'</a>'.repeat(MAX_XML_DEPTH)}</materialx>`,
      {},
      'nested more than',
    ],
    ['an inclusion of itself', including('look.mtlx'), {}, 'includes itself'],
    ['a missing inclusion', including('none.mtlx'), {}, "includes 'none.mtlx', which is not there"],
    ['an inclusion from the network', including('https://a.example/b.mtlx'), {}, 'no path of a file'],
    ['too many inclusions', including('c0.mtlx'), chain, `more than ${MAX_DOCUMENTS} documents`],
  ])('refuses %s', async (_, text, more, why) => {
    const scene = await readDocument(text, more);
    expect(said(scene).find((line) => line.startsWith('usd.unreadable-layer'))).toContain(why);
  });
});
