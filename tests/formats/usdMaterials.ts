import { expect } from 'vitest';
import { writeExr } from '../../src/formats/image/exr.ts';
import { toHalf } from '../../src/math/half.ts';
import { inEnglish } from '../../src/messages/message.ts';
import type { Material, Scene } from '../../src/scene/types.ts';
import { approximated, type ClaimGroup, type Files, leftOut, read } from './claim.ts';
import { GRAY_EXR, PIXEL, WEBP } from './pictures.ts';
import { def, FACE, material, usd } from './usdKit.ts';

/** A square bound to the material `/M`. */
const worn = (looks: string, uvs = ''): string => def('Mesh', `${FACE}\nrel material:binding = </M>\n${uvs}`) + looks;
const UVS = 'texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] ( interpolation = "vertex" )';

const wears = (inputs: string, more = ''): Files => usd(worn(material('M', inputs, more), UVS));
const texture = (name: string, lines = ''): string => `def Shader "${name}" { uniform token info:id = "UsdUVTexture"
    asset inputs:file = @./a.png@
    ${lines}
    float3 outputs:rgb
    float outputs:r }`;
const DIFFUSE = 'color3f inputs:diffuseColor.connect = </M/T.outputs:rgb>';
const reader = (type: string, lines = ''): string =>
  `def Shader "R" { uniform token info:id = "UsdPrimvarReader_${type}"\n${lines}\n${type} outputs:result }`;

const base = (scene: Scene): Material => scene.materials[scene.objects[0].mesh.groups[0].material];
const red = (scene: Scene): void => expect(base(scene).baseColor).toEqual([1, 0, 0]);

/** The material `/M` of look.mtlx. */
const MATERIALX_SCOPE = 'def "M" ( references = @look.mtlx@</MaterialX/Materials/M> ) {\n}\n';
/** A document whose material M has the given inputs of standard_surface. */
const document = (inputs: string, more = ''): string =>
  `<?xml version="1.0"?><materialx version="1.39">${more}<standard_surface name="S" type="surfaceshader">${inputs}</standard_surface>
  <surfacematerial name="M" type="material"><input name="surfaceshader" type="surfaceshader" nodename="S" /></surfacematerial></materialx>`;

const ANIMATED = 'color3f inputs:diffuseColor.timeSamples = { 0: (1, 0, 0), 9: (0, 1, 0) }';

const materials: ClaimGroup = {
  title: 'Materials and textures',
  rows: [
    read(
      '`UsdPreviewSurface` (also as a MaterialX node): diffuse and emissive colour, opacity and its threshold, roughness, metallic, ior',
      'a material',
      wears(
        'color3f inputs:diffuseColor = (1, 0, 0)\nfloat inputs:roughness = 0.25\nfloat inputs:ior = 1.25\nfloat inputs:opacity = 0.5',
      ),
      (s) => expect(base(s)).toMatchObject({ baseColor: [1, 0, 0], roughness: 0.25, ior: 1.25, opacity: 0.5 }),
    ),
    read(
      '`UsdUVTexture` for colours and opacity, with `UsdPrimvarReader_float2` and `UsdTransform2d`',
      'textures with colour space, scale, bias, channel, wrap mode, fallback',
      { ...wears(DIFFUSE, texture('T', 'token inputs:wrapS = "mirror"')), 'a.png': PIXEL },
      (s) => expect(base(s).baseColorTexture).toMatchObject({ width: 1, wrapS: 'mirror', colorSpace: 'srgb' }),
    ),
    read(
      '`<UDIM>` tiles, 1001 to 1100',
      'combined into one picture',
      { ...wears(DIFFUSE, texture('T').replace('a.png', 'a.<UDIM>.png')), 'a.1001.png': PIXEL, 'a.1002.png': PIXEL },
      (s) => expect(base(s).baseColorTexture?.width).toBeGreaterThan(1),
    ),
    read(
      '`UsdPrimvarReader_float3` (`_vector`, `_point`, `_normal`) for the diffuse colour',
      'the mesh’s vertex colours, or the reader’s fallback if there are none',
      wears(
        'color3f inputs:diffuseColor.connect = </M/R.outputs:result>',
        reader('float3', 'string inputs:varname = "none"\nfloat3 inputs:fallback = (1, 0, 0)'),
      ),
      (s) => expect([...s.objects[0].mesh.colors!.subarray(0, 3)]).toEqual([1, 0, 0]),
    ),
    read(
      'roughness and metallic textures, each from one channel with scale and bias',
      'applied per pixel',
      {
        ...wears(
          'float inputs:roughness.connect = </M/T.outputs:g>',
          texture('T', 'float4 inputs:scale = (1, 0.5, 1, 1)\ntoken inputs:sourceColorSpace = "raw"'),
        ),
        'a.png': PIXEL,
      },
      (s) => expect(base(s).roughnessTexture).toMatchObject({ channel: 1, scale: 0.5, bias: 0 }),
    ),
    read(
      'normal maps, with scale and bias',
      'applied per pixel, in the tangent frame of the uvs',
      {
        ...wears(
          'normal3f inputs:normal.connect = </M/T.outputs:rgb>',
          texture(
            'T',
            'float4 inputs:scale = (2, -2, 2, 1)\nfloat4 inputs:bias = (-1, 1, -1, 0)\ntoken inputs:sourceColorSpace = "raw"',
          ),
        ),
        'a.png': PIXEL,
      },
      (s) => expect(base(s).normalTexture).toMatchObject({ strength: [1, -1], texture: { colorSpace: 'linear' } }),
    ),
    read(
      '`slowlight:albedo:uv`, `slowlight:albedo:ir`, `slowlight:emission:temperature` [K] on the Material',
      'the reflectance of invisible light, and emission that shifts as that of a blackbody',
      usd(
        worn(
          material(
            'M',
            '',
            'custom double slowlight:albedo:ir = 0.5\ncustom double slowlight:emission:temperature = 3000',
          ),
        ),
      ),
      (s) => expect(base(s)).toMatchObject({ ir: 0.5, emissionTemperature: 3000 }),
    ),
    read(
      'an `asset slowlight:reflectance` on the Material, a CSV of wavelengths in nm and reflectances from 0 to 1',
      'the reflectance at each wavelength. The reference renderer uses it exactly; the fast one uses its colour and its means in the ultraviolet and infrared',
      {
        ...usd(worn(material('M', '', 'custom asset slowlight:reflectance = @./grey.csv@'))),
        'grey.csv': '# nm, share\n300, 0.25\n900, 0.25\n1500, 0.25\n',
      },
      (s) =>
        expect(base(s)).toMatchObject({
          reflectance: { values: [0.25, 0.25, 0.25] },
          baseColor: [expect.closeTo(0.25, 4), expect.closeTo(0.25, 4), expect.closeTo(0.25, 4)],
          uv: expect.closeTo(0.25, 9),
          ir: expect.closeTo(0.25, 9),
        }),
    ),
    leftOut(
      'such a table with values in percent',
      'reported with its greatest value',
      'spectrum.csv',
      {
        ...usd(worn(material('M', '', 'custom asset slowlight:reflectance = @leaf.csv@'))),
        'leaf.csv': '400, 5\n700, 50\n',
      },
      (s) => {
        expect(base(s)).not.toHaveProperty('reflectance');
        expect(s.diagnostics.map(({ message }) => inEnglish(message)).join()).toContain('divide percents by 100');
      },
    ),
    read(
      '`useSpecularWorkflow` with `specularColor`',
      'F₀: a metal where the diffuse colour is black, else a tinted reflection of a dielectric',
      wears(
        'int inputs:useSpecularWorkflow = 1\ncolor3f inputs:diffuseColor = (1, 0, 0)\ncolor3f inputs:specularColor = (1, 0.5, 0.25)',
      ),
      (s) => expect(base(s)).toMatchObject({ metallic: 0, specular: { color: [25, 12.5, 6.25] } }),
    ),
    read(
      '`clearcoat`, `clearcoatRoughness`, with textures',
      'a varnish over the material',
      wears('float inputs:clearcoat = 0.5\nfloat inputs:clearcoatRoughness = 0.25'),
      (s) => expect(base(s).clearcoat).toEqual({ factor: 0.5, roughness: 0.25 }),
    ),
    leftOut(
      'displacement',
      'reported; the rest of the material applies',
      'usd.material-input',
      wears('color3f inputs:diffuseColor = (1, 0, 0)\nfloat inputs:displacement = 0.1'),
      red,
    ),
    read(
      'occlusion textures, and textures of the reflectance of invisible light (`slowlight:albedo:uv.connect`, `:ir`)',
      'applied per pixel; occlusion dims the light from the sky and from other surfaces',
      [{ ...wears('float inputs:occlusion.connect = </M/T.outputs:r>', texture('T')), 'a.png': PIXEL }],
      (s) => expect(base(s).occlusionTexture).toMatchObject({ channel: 0, scale: 1, bias: 0 }),
    ),
    leftOut(
      'a primvar that drives a number',
      'its fallback is used',
      'usd.material-input',
      wears(
        'color3f inputs:diffuseColor = (1, 0, 0)\nfloat inputs:roughness.connect = </M/R.outputs:result>',
        reader('float', 'float inputs:fallback = 0.25'),
      ),
      (s) => expect(base(s).roughness).toBe(0.25),
    ),
    read(
      'MaterialX documents (`.mtlx`, 1.38 and 1.39) by reference, sublayer or payload, with the paths of OpenUSD (`</MaterialX/Materials/NAME>`): node graphs, interface inputs, own definitions made of graphs, `xi:include`, `fileprefix`, colour spaces',
      'materials, in which layers above may change inputs',
      {
        ...usd(worn(MATERIALX_SCOPE)),
        'look.mtlx': document('<input name="base_color" type="color3" value="1, 0, 0" />'),
      },
      red,
    ),
    read(
      '`ND_*` shaders in documents and layers: `standard_surface`, `open_pbr_surface`, `gltf_pbr`, `UsdPreviewSurface`, `disney_principled`, `surface_unlit`',
      'base colour (weighted), metalness, roughness, ior, strength, colour and anisotropy of reflection, coat, transmission with volume and dispersion, thin films, sheen, emission, opacity, normal, occlusion',
      usd(
        worn(
          material(
            'M',
            'color3f inputs:base_color = (1, 0, 0)\nfloat inputs:base = 1\nfloat inputs:specular = 0',
            '',
            'ND_standard_surface_surfaceshader',
            'outputs:mtlx:surface',
          ),
        ),
      ),
      (s) => expect(base(s)).toMatchObject({ baseColor: [1, 0, 0], specular: { factor: 0 } }),
    ),
    read(
      'MaterialX pictures (`image`, `tiledimage`, `gltf_image`, `gltf_colorimage`, `UsdUVTexture`), `normalmap`, texture coordinates (`texcoord`, `geompropvalue`, `place2d`, products and sums), and over 60 nodes of arithmetic, channels and colour',
      'constants are computed; a picture times a factor stays as it is; other computations become a picture of their own',
      {
        ...usd(worn(MATERIALX_SCOPE)),
        'a.png': PIXEL,
        'look.mtlx': document(
          '<input name="base_color" type="color3" nodename="p" />',
          '<image name="i" type="color3"><input name="file" type="filename" value="a.png" /></image><power name="p" type="color3"><input name="in1" type="color3" nodename="i" /><input name="in2" type="float" value="2" /></power>',
        ),
      },
      (s) => expect(base(s).baseColorTexture).toMatchObject({ width: 1, name: 'computed' }),
    ),
    approximated(
      'noise and other patterns of MaterialX, and nodes that are not read',
      'the mean of a pattern; the default of the input that another node drives',
      'mtlx.node',
      {
        ...usd(worn(MATERIALX_SCOPE)),
        'look.mtlx': document(
          '<input name="base_color" type="color3" nodename="p" />',
          '<noise3d name="n" type="float" /><mix name="p" type="color3"><input name="bg" type="color3" value="1, 0, 0" /><input name="mix" type="float" nodename="n" /></mix>',
        ),
      },
      red,
    ),
    approximated(
      'subsurface, scattering inside, tint and refractive index of the coat of MaterialX surfaces',
      'subsurface is a diffuse colour; the rest is left out',
      'mtlx.input',
      {
        ...usd(worn(MATERIALX_SCOPE)),
        'look.mtlx': document(
          '<input name="base_color" type="color3" value="1, 0, 0" /><input name="coat" type="float" value="0.5" /><input name="coat_color" type="color3" value="1, 0, 0" />',
        ),
      },
      red,
    ),
    leftOut(
      'looks of a MaterialX document, and materials of MaterialX before 1.38',
      'reported; materials are bound in USD',
      'mtlx.left-out',
      {
        ...usd(worn(MATERIALX_SCOPE)),
        'look.mtlx': document('<input name="base_color" type="color3" value="1, 0, 0" />', '<look name="l" />'),
      },
      red,
    ),
    leftOut(
      'a MaterialX value that does not have the type of its input',
      'reported with line, node and value',
      'mtlx.value',
      {
        ...usd(worn(MATERIALX_SCOPE)),
        'look.mtlx': document(
          '<input name="base_color" type="color3" value="1, 0, 0" /><input name="metalness" type="float" value="much" />',
        ),
      },
      red,
    ),
    leftOut(
      'a MaterialX document that is damaged, larger than 16 MiB, of more than 100,000 elements, nested more than 32 deep, or that includes more than 64 others',
      'an unreadable layer, with the line',
      'usd.unreadable-layer',
      { ...usd(worn(MATERIALX_SCOPE)), 'look.mtlx': '<materialx version="1.39"><nodegraph>' },
    ),
    approximated(
      'materials of other renderers (MDL, RenderMan, Arnold …)',
      'their `UsdPreviewSurface` if there is one; else base colour or the only picture connected to it, and roughness, metalness, emission and opacity if constant; else the displayColor',
      'usd.material',
      usd(worn(material('M', 'color3f inputs:baseColor = (1, 0, 0)', '', 'PxrSurface', 'outputs:ri:surface'))),
      red,
    ),
    approximated(
      'a missing material',
      'the displayColor',
      'usd.material',
      usd(worn('', 'color3f[] primvars:displayColor = [(1, 0, 0)]')),
      red,
    ),
    approximated(
      'an unsupported shader, or a network that is too long to follow',
      'the value set on the input is used',
      'usd.shader',
      wears(
        'color3f inputs:diffuseColor = (1, 0, 0)\ncolor3f inputs:diffuseColor.connect = </M/T.outputs:rgb>',
        'def Shader "T" { uniform token info:id = "Noise"\nfloat3 outputs:rgb }',
      ),
    ),
    approximated(
      'textures of one material with different uv sets',
      'the uvs of the first; a mesh has one set',
      'usd.uv',
      {
        ...usd(
          worn(
            material(
              'M',
              `${DIFFUSE}\ncolor3f inputs:emissiveColor.connect = </M/U.outputs:rgb>`,
              [
                texture('T', 'float2 inputs:st.connect = </M/Q.outputs:result>'),
                texture('U', 'float2 inputs:st.connect = </M/R.outputs:result>'),
                reader('float2', 'string inputs:varname = "st"').replace('"R"', '"Q"'),
                reader('float2', 'string inputs:varname = "uv2"'),
              ].join('\n'),
            ),
            UVS,
          ),
        ),
        'a.png': PIXEL,
      },
    ),
    approximated('an animated material', 'held at its initial value', 'usd.animated-material', wears(ANIMATED), red),
    leftOut(
      'a missing picture',
      'reported with the places that were searched; the file can be dropped on the page',
      'file.missing-texture',
      wears(DIFFUSE, texture('T')),
      (s) => expect(s.diagnostics[0].missing?.name).toBe('./a.png'),
    ),
    read(
      'a picture as OpenEXR or Radiance',
      'linear, where no colour space is written; what is beyond 0 … 1 is cut',
      [
        { ...wears(DIFFUSE, texture('T')), 'a.png': GRAY_EXR },
        { ...wears(DIFFUSE, texture('T', 'token inputs:sourceColorSpace = "raw"')), 'a.png': GRAY_EXR },
      ],
      (s) => {
        // 0.5, and 0.7354 encoded.
        const { data, colorSpace } = base(s).baseColorTexture!;
        expect([colorSpace, data[0]]).toEqual(colorSpace === 'srgb' ? ['srgb', 188] : ['linear', 128]);
      },
    ),
    leftOut(
      'a picture that is damaged, too large, or of another format',
      'reported with what it is',
      'file.unreadable-texture',
      { ...wears(DIFFUSE, texture('T')), 'a.png': WEBP },
    ),
    leftOut(
      'a texture without a file',
      'its fallback is used',
      'usd.texture',
      wears(DIFFUSE, texture('T', 'float4 inputs:fallback = (1, 0, 0, 1)').replace('@./a.png@', '@@')),
      red,
    ),
  ],
};

const shines = (type: string, lines = ''): Files => usd(def(type, lines));

/** One pixel of radiance 16.0625 = 2^(133 − 136) · (128 + ½). */
const HDR = new Uint8Array([
  ...new TextEncoder().encode('#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n'),
  ...[128, 128, 128, 133],
]);
const EXR = writeExr({
  width: 1,
  height: 1,
  channels: ['R', 'G', 'B'].map((name) => ({ name, type: 'float', data: Float32Array.of(16.0625) })),
});
const HALVES = Uint16Array.from([16.0625, 16.0625, 16.0625, 1], toHalf);

const unread = (type: string): ReturnType<typeof leftOut> =>
  leftOut(`\`${type}\``, 'reported', 'usd.unsupported-prim', shines(type), (s) => expect(s.lights).toEqual([]));

const lights: ClaimGroup = {
  title: 'Lights and cameras',
  rows: [
    read(
      '`DistantLight` with angle, `DomeLight` with picture',
      'lights',
      {
        ...usd(
          'def DistantLight "A" { float inputs:intensity = 3\n float inputs:angle = 0 }\ndef DomeLight "B" { asset inputs:texture:file = @a.png@ }',
        ),
        'a.png': PIXEL,
      },
      (s) =>
        expect(s.lights).toMatchObject([
          { kind: 'distant', color: [3, 3, 3], direction: [0, 0, -1], angle: 0 },
          { kind: 'dome', texture: { width: 1 } },
        ]),
    ),
    read(
      '`DomeLight` with `slowlight:sky = "stars"`; intensity and orientation',
      'the bright stars and the cosmic background, with celestial north along +Y of the light’s frame',
      usd('def DomeLight "A" { token slowlight:sky = "stars"\nfloat inputs:intensity = 5 }'),
      (s) => expect(s.lights).toMatchObject([{ kind: 'stars', gain: expect.closeTo(5, 6) }]),
    ),
    read(
      'a `DomeLight` without a picture; with `slowlight:sky:horizon` or `slowlight:sky:ground`',
      'uniform in all directions; a sky whose colour varies with elevation',
      usd(
        'def DomeLight "A" { float inputs:intensity = 2 }\ndef DomeLight "B" { custom color3f slowlight:sky:horizon = (1, 0.5, 0) }',
      ),
      (s) =>
        expect(s.lights).toEqual([
          { kind: 'dome', path: '/A', color: [2, 2, 2] },
          { kind: 'dome', path: '/B', color: [1, 1, 1], gradient: { horizon: [1, 0.5, 0], ground: [1, 0.5, 0] } },
        ]),
    ),
    read(
      'the picture of a `DomeLight` as Radiance (`.hdr`) or OpenEXR (half or float; uncompressed or ZIP)',
      'radiance with the values of the file; above 65504 dimmed, with its hue',
      [
        { ...usd('def DomeLight "B" { asset inputs:texture:file = @a.hdr@ }'), 'a.hdr': HDR },
        { ...usd('def DomeLight "B" { asset inputs:texture:file = @a.exr@ }'), 'a.exr': EXR },
      ],
      (s) => expect(s.lights).toMatchObject([{ kind: 'dome', texture: { width: 1, data: HALVES } }]),
    ),
    read(
      'the orientation of a `DomeLight`, the `poleAxis` of a `DomeLight_1`; a mirror ball or light probe by `texture:format`',
      'mapped as UsdLux specifies',
      {
        ...usd(
          'def DomeLight_1 "B" { uniform token poleAxis = "Z"\nasset inputs:texture:file = @a.exr@\ntoken inputs:texture:format = "angular" }',
        ),
        'a.exr': EXR,
      },
      (s) =>
        expect(s.lights).toMatchObject([
          {
            texture: { width: 2, height: 1 },
            orientation: [expect.closeTo(Math.SQRT1_2), 0, 0, expect.closeTo(Math.SQRT1_2)],
          },
        ]),
    ),
    leftOut(
      'a `texture:format` of `cubeMapVerticalCross`',
      'reported; the dome emits its constant colour',
      'usd.light-input',
      {
        ...usd(
          'def DomeLight "B" { asset inputs:texture:file = @a.exr@\ntoken inputs:texture:format = "cubeMapVerticalCross" }',
        ),
        'a.exr': EXR,
      },
      (s) => expect(s.lights).toEqual([{ kind: 'dome', path: '/B', color: [1, 1, 1] }]),
    ),
    leftOut(
      'such a picture that is damaged, too large or of an unsupported kind (PIZ, DWA, tiles …)',
      'reported with what it is',
      'file.unreadable-texture',
      { ...usd('def DomeLight "B" { asset inputs:texture:file = @a.hdr@ }'), 'a.hdr': HDR.slice(0, -1) },
      (s) => expect(s.lights).toMatchObject([{ kind: 'dome' }]),
    ),
    read(
      '`SphereLight`, `RectLight`, `DiskLight`, `CylinderLight`; color, intensity, exposure, `normalize`, colour temperature, `treatAsPoint`, `treatAsLine`',
      'lamps that move with their transforms or by `slowlight:motion`',
      usd(
        ['Sphere', 'Rect', 'Disk', 'Cylinder']
          .map((k) => `def ${k}Light "${k}" { float inputs:exposure = 1 }`)
          .join('\n'),
      ),
      (s) =>
        expect(s.lights).toMatchObject(
          ['sphere', 'rect', 'disk', 'cylinder'].map((kind) => ({ kind, color: [2, 2, 2] })),
        ),
    ),
    read(
      '`slowlight:spectrum` of a light (`"2856 K"`, `"sodium"` …), or its colour temperature',
      'the spectrum of its light',
      shines('SphereLight', 'custom token slowlight:spectrum = "sodium"'),
      (s) => expect(s.lights).toMatchObject([{ spectrum: { kind: 'lines' } }]),
    ),
    read(
      'an `asset slowlight:spectrum` of a light, a CSV of wavelengths in nm and values',
      'its light has the spectrum of the table; of its colour only the brightness is used',
      {
        ...shines('SphereLight', 'custom asset slowlight:spectrum = @./lamps/warm.csv@'),
        'lamps/warm.csv': '# nm, W\n400, 1\n500, 2\n600, 4\n',
      },
      (s) => expect(s.lights).toMatchObject([{ spectrum: { kind: 'sampled', values: [1, 2, 4] } }]),
    ),
    leftOut(
      'such a table that is missing',
      'reported with the places that were searched; the file can be dropped on the page',
      'file.missing-spectrum',
      shines('SphereLight', 'custom asset slowlight:spectrum = @./warm.csv@'),
      (s) => expect(s.diagnostics.find(({ missing }) => missing)?.missing?.name).toBe('./warm.csv'),
    ),
    leftOut(
      'such a table that is not a spectrum',
      'reported with the line',
      'spectrum.csv',
      {
        ...shines('DomeLight', 'custom asset slowlight:spectrum = @warm.csv@'),
        'warm.csv': '400, 1\n390, 2\n',
      },
      (s) => {
        expect(s.lights[0]).not.toHaveProperty('spectrum');
        expect(s.diagnostics.map(({ message }) => inEnglish(message)).join()).toContain(
          'warm.csv: line 2: 390 nm comes after 400 nm',
        );
      },
    ),
    leftOut(
      'an unknown `slowlight:spectrum`',
      'reported',
      'usd.slowlight',
      ['moonshine', '-3 K', '1e99 K'].map((text) =>
        shines('SphereLight', `custom token slowlight:spectrum = "${text}"`),
      ),
      (s) => expect(s.lights[0]).not.toHaveProperty('spectrum'),
    ),
    read(
      '`ShapingAPI`: cone angle, softness, focus',
      'the same',
      shines('SphereLight', 'float inputs:shaping:cone:angle = 90\nfloat inputs:shaping:cone:softness = 0.5'),
      (s) => expect(s.lights[0]).toMatchObject({ shaping: { inner: Math.PI / 4, outer: Math.PI / 2 } }),
    ),
    approximated(
      '`MeshLightAPI`, `GeometryLight`',
      'the mesh emits light; only the reference renderer shows that it lights other objects',
      'usd.mesh-light',
      usd(`def Mesh "A" ( prepend apiSchemas = ["MeshLightAPI"] ) { ${FACE}\nfloat inputs:intensity = 2 }`),
      (s) => expect(base(s).emissive).toEqual([2, 2, 2]),
    ),
    approximated(
      'the texture of a `RectLight`',
      'its mean colour',
      'usd.light-input',
      { ...shines('RectLight', 'asset inputs:texture:file = @a.png@'), 'a.png': PIXEL },
      (s) => expect(s.lights[0]).toMatchObject({ color: [1, 0, 0] }),
    ),
    approximated(
      'animated parameters of a light, other than a lamp’s position',
      'held at its initial value',
      'usd.animated-light',
      shines('SphereLight', 'float inputs:intensity.timeSamples = { 0: 1, 9: 2 }'),
      (s) => expect(s.lights[0]).toMatchObject({ color: [1, 1, 1] }),
    ),
    leftOut(
      'IES profiles, `focusTint`, a `specular` that differs from `diffuse`, disabled shadows',
      'reported; the light is shown without them',
      'usd.light-input',
      [
        'asset inputs:shaping:ies:file = @a.ies@',
        'color3f inputs:shaping:focusTint = (1, 0, 0)\nfloat inputs:shaping:focus = 1',
        'float inputs:specular = 0.5',
        'bool inputs:shadow:enable = false',
      ].map((lines) => shines('SphereLight', lines)),
      (s) => expect(s.lights.length).toBe(1),
    ),
    unread('PortalLight'),
    unread('PluginLight'),
    read(
      '`Camera`',
      'a camera with the vertical field of view 2 atan(verticalAperture / 2 focalLength)',
      shines('Camera', 'float focalLength = 10\nfloat verticalAperture = 20'),
      (s) => expect(s.cameras[0].fovY).toBeCloseTo(Math.PI / 2, 12),
    ),
    approximated(
      'orthographic cameras',
      'shown as perspective cameras',
      'usd.projection',
      shines('Camera', 'token projection = "orthographic"'),
      (s) => expect(s.cameras.length).toBe(1),
    ),
    approximated(
      'an animated lens',
      'held at its initial value',
      'usd.animated-lens',
      shines('Camera', 'float focalLength.timeSamples = { 0: 10, 9: 20 }'),
      (s) => expect(s.cameras.length).toBe(1),
    ),
  ],
};

export const materialGroups: readonly ClaimGroup[] = [materials, lights];
