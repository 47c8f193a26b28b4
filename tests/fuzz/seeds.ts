import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { encode as encodeJpeg } from 'jpeg-js';
import { type ExrChannel, writeExr } from '../../src/formats/image/exr.ts';
import { parseLayer, writeCrate } from '../../src/formats/usd/index.ts';
import { GltfBuilder } from '../support/gltfBuilder.ts';
import { dracoGlb, meshoptGlb } from '../support/gltfCompress.ts';
import { makeTestFilm } from '../support/testFilm.ts';

/** A valid file with its dependencies, the starting point of mutations. */
export interface Seed {
  readonly name: string;
  /** By path; `entry` is the one that is mutated. */
  readonly files: Readonly<Record<string, Uint8Array>>;
  readonly entry: string;
  /** A text format. */
  readonly text: boolean;
  /** The file that is opened, if it is another one, which refers to it. */
  readonly opened?: string;
}

const corpusFile = (name: string): Uint8Array =>
  new Uint8Array(readFileSync(new URL(`corpus/${name}`, import.meta.url)));
const PICTURE = { 'wood.png': corpusFile('wood.png') };
const USD = { ...PICTURE, 'part.usda': corpusFile('part.usda') };

const seed = (entry: string, bytes: Uint8Array, text: boolean, beside: Seed['files'] = {}): Seed => ({
  name: entry,
  files: { ...beside, [entry]: bytes },
  entry,
  text,
});

/** One file of every supported format that uses all its features. */
export async function seeds(): Promise<Seed[]> {
  const [json, binary] = await gltfSeparate();
  return [
    seed('everything.usda', corpusFile('everything.usda'), true, USD),
    seed('looks.usda', corpusFile('looks.usda'), true, {
      ...PICTURE,
      'wood.1001.png': PICTURE['wood.png'],
      'wood.1012.png': PICTURE['wood.png'],
    }),
    seed('everything.usdc', corpusFile('everything.usdc'), false, USD),
    seed('written.usdc', writeCrate(parseLayer(corpusFile('everything.usda'), 'everything.usda')), false, USD),
    seed('grammar.usda', corpusFile('../../../src/formats/usd/fixtures/grammar.usda'), true),
    seed('strands.usda', corpusFile('strands.usda'), true),
    seed('models.usda', corpusFile('models.usda'), true, PICTURE),
    seed('lives.usda', corpusFile('../../../src/formats/usd/schema/lives/fixtures/lives.usda'), true),
    seed('everything.usdz', corpusFile('everything.usdz'), false),
    {
      ...seed('look.mtlx', corpusFile('look.mtlx'), true, { ...PICTURE, 'worn.usda': corpusFile('worn.usda') }),
      opened: 'worn.usda',
    },
    seed('everything.gltf', json, true, { 'everything.bin': binary, ...PICTURE }),
    seed('everything.glb', await everything().glb(), false),
    seed('draco.glb', await dracoGlb(everything().doc, 'edgebreaker'), false),
    seed('draco-sequential.glb', await dracoGlb(everything().doc, 'sequential'), false),
    seed('meshopt.glb', await meshoptGlb(everything().doc, 'filter'), false),
    seed('everything.obj', corpusFile('everything.obj'), true, {
      'everything.mtl': corpusFile('everything.mtl'),
      ...PICTURE,
    }),
    seed('text.ply', corpusFile('text.ply'), true, PICTURE),
    seed('binary.ply', binaryPly(), false),
    seed('text.stl', corpusFile('text.stl'), true),
    seed('binary.stl', binaryStl(), false),
    seed('wood.png', PICTURE['wood.png'], false),
    seed('wood.jpg', jpeg(), false),
    seed('channels.exr', exr(), false),
    seed('sky.hdr', panorama(), false),
    ...films(),
    ktx2Seed('etc1s.ktx2', 'rgba-mipmap-reference-basis.ktx2'),
    ktx2Seed('uastc.ktx2', 'luminance_alpha_reference_uastc.ktx2'),
  ];
}

/** Six faces of 8 × 8 pixels in a strip, run-length encoded. */
/** Of a few frames each; fragmented, too. */
function films(): Seed[] {
  const folder = mkdtempSync(join(tmpdir(), 'slowlight-seeds-'));
  const film = { colors: ['red', 'lime'], seconds: 0.4, rate: 10, width: 64, height: 32 } as const;
  const of = (name: string, how: readonly string[]): Seed =>
    seed(name, new Uint8Array(makeTestFilm(folder, name, { ...film, how })), false);
  const made = [
    of('film.mp4', []),
    of('fragments.mp4', ['-movflags', 'frag_keyframe+empty_moov']),
    of('film.webm', ['-c:v', 'libvpx-vp9', '-b:v', '100k']),
  ];
  rmSync(folder, { recursive: true });
  return made;
}

function panorama(): Uint8Array {
  const component = (value: number): number[] => [128 + 48, value];
  const row = [2, 2, 0, 48, ...[200, 100, 50, 129].flatMap(component)];
  const header = new TextEncoder().encode('#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 48\n');
  return Uint8Array.from([...header, ...Array.from({ length: 8 }, () => row).flat()]);
}

/** A picture of the codec's tests, on a triangle. */
function ktx2Seed(name: string, file: string): Seed {
  const points = Buffer.from(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0).buffer).toString('base64');
  const uri = `data:application/octet-stream;base64,${points}`;
  const gltf = {
    asset: { version: '2.0' },
    images: [{ uri: name }],
    textures: [{ extensions: { KHR_texture_basisu: { source: 0 } } }],
    extensionsUsed: ['KHR_texture_basisu'],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    buffers: [{ uri, byteLength: 36 }],
    bufferViews: [{ buffer: 0, byteLength: 36 }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 0] }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, material: 0 }] }],
    nodes: [{ mesh: 0 }],
    scenes: [{ nodes: [0] }],
  };
  const bytes = corpusFile(`../../../src/formats/image/ktx2/testdata/${file}`);
  const opened = 'picture.gltf';
  return { ...seed(name, bytes, false, { [opened]: new TextEncoder().encode(JSON.stringify(gltf)) }), opened };
}

/** A skinned, morphed, animated, textured mesh with a camera, points and lines. */
function everything(): GltfBuilder {
  const kit = new GltfBuilder();
  const { doc } = kit;
  const image = doc.createTexture('Wood').setImage(PICTURE['wood.png']).setMimeType('image/png');
  const material = doc.createMaterial('Wood').setBaseColorTexture(image).setAlphaMode('MASK');
  const target = doc.createPrimitiveTarget().setAttribute('POSITION', kit.values('VEC3', new Array(12).fill(0.1)));
  const primitive = kit
    .triangle([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0])
    .setIndices(kit.ints('SCALAR', [0, 1, 2, 1, 3, 2]))
    .setAttribute('NORMAL', kit.values('VEC3', [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]))
    .setAttribute('TEXCOORD_0', kit.values('VEC2', [0, 0, 1, 0, 0, 1, 1, 1]))
    .setAttribute('JOINTS_0', kit.ints('VEC4', [0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0]))
    .setAttribute('WEIGHTS_0', kit.values('VEC4', new Array(4).fill([0.5, 0.5, 0, 0]).flat()))
    .setMaterial(material)
    .addTarget(target);
  const bones = [doc.createNode('Hip'), doc.createNode('Knee').setTranslation([0, 1, 0])];
  const body = kit.meshNode('Body', primitive).setSkin(doc.createSkin().addJoint(bones[0]).addJoint(bones[1]));
  const camera = doc.createNode('Eye').setCamera(doc.createCamera().setType('perspective').setYFov(1));
  const [dots, wire] = [0, 3].map((mode) => kit.triangle().setMode(mode as 0 | 3));
  const strokes = kit.meshNode('Strokes', dots, wire);
  for (const node of [body, bones[0].addChild(bones[1]), camera, strokes]) kit.scene.addChild(node);
  kit.animate(bones[1], 'rotation', [0, 1], [0, 0, 0, 1, 0, 0, 1, 0]);
  kit.animate(body, 'weights', [0, 1], [0, 1], 'STEP');
  return kit;
}

/** The same with a separate binary buffer. */
async function gltfSeparate(): Promise<readonly [Uint8Array, Uint8Array]> {
  const glb = await everything().glb();
  const length = new DataView(glb.buffer, glb.byteOffset).getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + length)));
  json.buffers[0].uri = 'everything.bin';
  json.images = [{ uri: 'wood.png' }];
  return [new TextEncoder().encode(JSON.stringify(json, null, 1)), glb.subarray(28 + length)];
}

function binaryPly(): Uint8Array {
  const head =
    'ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n';
  const body = new DataView(new ArrayBuffer(36 + 13));
  [0, 0, 0, 1, 0, 0, 0, 1, 0].forEach((x, i) => {
    body.setFloat32(4 * i, x, true);
  });
  body.setUint8(36, 3);
  [0, 1, 2].forEach((x, i) => {
    body.setInt32(37 + 4 * i, x, true);
  });
  return new Uint8Array([...new TextEncoder().encode(head), ...new Uint8Array(body.buffer)]);
}

function binaryStl(): Uint8Array {
  const view = new DataView(new ArrayBuffer(84 + 2 * 50));
  view.setUint32(80, 2, true);
  for (const at of [84, 134])
    [0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0].forEach((x, i) => {
      view.setFloat32(at + 4 * i, x, true);
    });
  return new Uint8Array(view.buffer);
}

function jpeg(): Uint8Array {
  const [width, height] = [24, 17];
  const data = Uint8Array.from({ length: 4 * width * height }, (_, i) => (i * 37) % 256);
  return new Uint8Array(encodeJpeg({ width, height, data }, 80).data);
}

function exr(): Uint8Array {
  const channel = (name: string, type: ExrChannel['type']): ExrChannel => ({
    name,
    type,
    data: Float32Array.from({ length: 12 }, (_, i) => i / 3),
  });
  return writeExr({ width: 4, height: 3, channels: [channel('R', 'half'), channel('Z', 'float')] });
}
