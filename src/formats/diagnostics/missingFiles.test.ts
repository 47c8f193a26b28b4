import { expect, it } from 'vitest';
import { inEnglish } from '../../messages/message.ts';
import { memorySource } from '../files/fileSource.ts';
import { openScene } from '../open.ts';

const text = (words: string) => new TextEncoder().encode(words);
const missingIn = async (entry: string, words: string, more: Record<string, string> = {}) => {
  const others = Object.entries(more).map(([name, content]) => [name, text(content)] as const);
  const { diagnostics } = await openScene(memorySource({ [entry]: text(words), ...Object.fromEntries(others) }), entry);
  return diagnostics.flatMap(({ code, place, missing }) =>
    missing ? [{ code, place: inEnglish(place), ...missing }] : [],
  );
};

it('USD: a layer and a texture', async () => {
  const stage = `#usda 1.0
( subLayers = [@./geo/base.usda@] )
def Material "M" {
  token outputs:surface.connect = </M/S.outputs:surface>
  def Shader "S" { uniform token info:id = "UsdPreviewSurface"; color3f inputs:diffuseColor.connect = </M/T.outputs:rgb>; token outputs:surface }
  def Shader "T" { uniform token info:id = "UsdUVTexture"; asset inputs:file = @tex/wood.png@; float3 outputs:rgb }
}
def Mesh "A" ( prepend apiSchemas = ["MaterialBindingAPI"] ) {
  int[] faceVertexCounts = [3]
  int[] faceVertexIndices = [0, 1, 2]
  point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
  rel material:binding = </M>
}
`;
  expect(await missingIn('set/a.usda', stage)).toEqual([
    { code: 'usd.missing-layer', place: 'set/a.usda', name: './geo/base.usda', lookedFor: ['set/geo/base.usda'] },
    {
      code: 'file.missing-texture',
      place: 'set/a.usda</M/T>',
      name: 'tex/wood.png',
      lookedFor: ['set/tex/wood.png'],
    },
  ]);
});

it('glTF: an image, with the materials that use it', async () => {
  const gltf = {
    asset: { version: '2.0' },
    images: [{ uri: 'tex/oak%20wood.png' }],
    textures: [{ source: 0 }],
    materials: [{ name: 'Wood', pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
  };
  expect(await missingIn('set/a.gltf', JSON.stringify(gltf))).toEqual([
    {
      code: 'file.missing-texture',
      place: 'set/a.gltf: image 0, material Wood',
      name: 'tex/oak%20wood.png',
      lookedFor: ['set/tex/oak wood.png'],
    },
  ]);
});

it('OBJ: materials and textures', async () => {
  const obj = 'mtllib a.mtl\nmtllib b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl Wood\nf 1 2 3\n';
  expect(await missingIn('set/a.obj', obj, { 'set/a.mtl': 'newmtl Wood\nmap_Kd tex/wood.png\n' })).toEqual([
    { code: 'file.missing-materials', place: 'set/a.obj: line 2', name: 'b.mtl', lookedFor: ['set/b.mtl'] },
    {
      code: 'file.missing-texture',
      place: 'set/a.obj: set/a.mtl: line 2, material Wood',
      name: 'tex/wood.png',
      lookedFor: ['set/tex/wood.png', 'set/wood.png'],
    },
  ]);
});
