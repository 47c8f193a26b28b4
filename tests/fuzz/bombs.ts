import { zlibSync } from 'fflate';
import { crc32 } from '../../src/formats/files/crc32.ts';
import type { Seed } from './seeds.ts';

/** A small file that requests excessive or invalid amounts. */
export interface Bomb extends Seed {
  /** Expected codes of the error or diagnostics; one must match. */
  readonly said: RegExp;
  /** Maximum number of objects made of it; default: 1000. */
  readonly objects?: number;
}

const bytes = (text: string): Uint8Array => new TextEncoder().encode(text);

const usda = (name: string, said: RegExp, body: string, objects?: number): Bomb => ({
  name,
  files: { 'a.usda': bytes(`#usda 1.0\n${body}\n`) },
  entry: 'a.usda',
  text: true,
  said,
  ...(objects !== undefined && { objects }),
});
const gltf = (name: string, said: RegExp, json: object | string): Bomb => ({
  name,
  files: { 'a.gltf': bytes(typeof json === 'string' ? json : JSON.stringify({ asset: { version: '2.0' }, ...json })) },
  entry: 'a.gltf',
  text: true,
  said,
});
const file = (entry: string, name: string, said: RegExp, content: string | Uint8Array): Bomb => ({
  name,
  files: { [entry]: typeof content === 'string' ? bytes(content) : content },
  entry,
  text: typeof content === 'string',
  said,
});
const times = (count: number, text: (i: number) => string): string =>
  Array.from({ length: count }, (_, i) => text(i)).join('');

const nested = (depth: number, open: string, close: string): string => open.repeat(depth) + close.repeat(depth);
/** Each level references the one before ten times. */
const levels = (...arcs: readonly string[]): string => {
  const written = (i: number): string => arcs.map((arc) => `${arc} = </L${i + 1}>\n`).join('');
  const level = (i: number): string => times(10, (k) => `def "C${k}" ( ${written(i)} ) {\n}\n`);
  return `${times(9, (i) => `def "L${i}"\n{\n${level(i)}}\n`)}def Cube "L9" {\n}\n`;
};
/** Maximum number of objects from the levels of a hundred-line file. */
const FROM_LEVELS = 25_000;
/** Every prim references all later ones, so each has twice the sites of the next. */
const web = (count: number): string =>
  times(count, (i) => `def "L${i}" ( references = [${times(count - i - 1, (k) => `</L${i + k + 1}>, `)}] ) {\n}\n`);
const manySets = (count: number): string =>
  `def "A" ( variants = { ${times(count, (i) => `string s${i} = "a"\n`)} }\nprepend variantSets = [${times(count, (i) => `"s${i}", `)}] ) {\n` +
  `${times(count, (i) => `variantSet "s${i}" = { "a" {\ndef Cube "X" {\n}\n} }\n`)}}`;
const manyMoves = (count: number): string =>
  `( relocates = { ${times(count, (i) => `</A/B${i}>: </A/C${i}>, `)} } )\n` +
  `def "A" ( references = </S> ) {\n}\nclass "K" {\n}\ndef "S" {\n${times(count, (i) => `def "B${i}" ( inherits = </K> ) {\n}\n`)}}`;
/** Variant sets nested `depth` deep, two variants each. */
const variants = (depth: number): string =>
  depth === 0
    ? 'def Cube "A" {\n}\n'
    : `def "P" ( variants = { string v = "a" }\nprepend variantSets = "v" ) {\nvariantSet "v" = {\n"a" {\n${variants(depth - 1)}}\n"b" {\n}\n}\n}\n`;
const INSTANCERS = 5;
/** A thousand cubes under a parent with fifty thousand samples of one transform. */
const movedCubes = (type: string, op: string, sample: (i: number) => string): string =>
  `def Xform "A" {\n${type} xformOp:${op}.timeSamples = {\n${times(50_000, (i) => `${i}: ${sample(i % 7)},\n`)}}\n` +
  `uniform token[] xformOpOrder = ["xformOp:${op}"]\n${times(1000, (i) => `def Cube "C${i}" {\n}\n`)}}`;
const instancers = (depth: number): string =>
  `def PointInstancer "I${depth}" {\npoint3f[] positions = [${times(100, (i) => `(${i}, 0, 0),`)}]\nint[] protoIndices = [${'0,'.repeat(100)}]\n` +
  `rel prototypes = <${Array.from({ length: INSTANCERS - depth + 1 }, (_, i) => `/I${INSTANCERS - i}`).join('')}/${depth > 1 ? `I${depth - 1}` : 'Cube'}>\n` +
  `${depth > 1 ? instancers(depth - 1) : 'def Cube "Cube" {\n}\n'}}\n`;

const usdBombs: readonly Bomb[] = [
  usda('prims in prims', /too-deep|syntax/, nested(100_000, 'def "A" {\n', '}\n')),
  usda('lists in lists', /syntax|too-deep/, `def "A" {\nint[] x = ${nested(200_000, '[', ']')}\n}`),
  usda(
    'dictionaries in dictionaries',
    /syntax|too-deep/,
    `( customLayerData = ${nested(100_000, '{ dictionary a = {', '} }')} )`,
  ),
  usda('references that multiply', /too-many-prims/, levels('references'), FROM_LEVELS),
  usda('payloads that multiply', /too-many-prims/, levels('payload'), FROM_LEVELS),
  usda('classes that multiply', /too-many-prims/, levels('inherits'), FROM_LEVELS),
  usda('specialized ones that multiply', /too-many-prims/, levels('specializes'), FROM_LEVELS),
  usda('what multiplies in three ways', /too-many-prims/, levels('references', 'inherits', 'specializes'), FROM_LEVELS),
  usda('references to all that follow', /too-many-arcs/, web(30)),
  usda('variant sets without end', /too-many-prims/, manySets(3000)),
  usda('as many moves as classes', /too-many-prims/, manyMoves(2000)),
  usda('variants in variants', /./, variants(100)),
  usda('a layer in itself', /cycle/, '( subLayers = [@./a.usda@] )\ndef Cube "A" {\n}'),
  usda('a prim in itself', /cycle/, 'def "A" ( references = </A/B> ) {\ndef "B" ( references = </A> ) {\n}\n}'),
  usda(
    'a face of two thousand million corners',
    /faces/,
    'def Mesh "A" {\nint[] faceVertexCounts = [2000000000]\nint[] faceVertexIndices = [0, 1, 2]\npoint3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]\n}',
  ),
  usda(
    'corners below none',
    /faces/,
    'def Mesh "A" {\nint[] faceVertexCounts = [3, -3]\nint[] faceVertexIndices = [0, -1, 2]\npoint3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]\n}',
  ),
  usda(
    'samples of a parent of many that slide',
    /sample-budget/,
    movedCubes('double3', 'translate', (x) => `(${x}, 0, 0)`),
  ),
  usda(
    'samples of a parent of many that turn',
    /sample-budget/,
    movedCubes('double', 'rotateX', (x) => `${10 * x}`),
  ),
  usda(
    'samples of a parent of many that are stretched',
    /sample-budget/,
    movedCubes('double3', 'scale', (x) => `(${1 + x}, 1, 1)`),
  ),
  usda('instances of instances', /too-many-instances/, instancers(INSTANCERS)),
  usda(
    'a million transforms',
    /./,
    `def Xform "A" {\ndouble xformOp:rotateX = 1\nuniform token[] xformOpOrder = [${'"xformOp:rotateX",'.repeat(1_000_000)}]\ndef Cube "B" {\n}\n}`,
  ),
  usda(
    'names of prototypes',
    /^$|./,
    '( customLayerData = { string __proto__ = "x"\nstring constructor = "y" } )\ndef Cube "__proto__" {\ndouble size = 1\nstring constructor = "z"\n}\ndef Cube "constructor" {\n}',
  ),
  usda(
    'files of others',
    /missing-texture|missing-layer/,
    'def "A" ( references = @/etc/passwd@ ) {\n}\ndef "B" ( references = @../../../../etc/passwd@ ) {\n}',
  ),
  file(
    'a.usda',
    'text that is no UTF-8',
    /./,
    Uint8Array.of(...bytes('#usda 1.0\ndef Cube "'), 0xff, 0xfe, 0xc0, ...bytes('" {\n}\n')),
  ),
];

const view = (length: number) => ({
  buffers: [{ byteLength: length, uri: 'data:application/octet-stream;base64,AAAA' }],
});

const gltfBombs: readonly Bomb[] = [
  gltf('lists in lists of JSON', /gltf\./, nested(1_000_000, '[', ']')),
  gltf('nodes in nodes', /too-deep|deep|gltf\./, {
    nodes: Array.from({ length: 50_000 }, (_, i) => (i < 49_999 ? { children: [i + 1] } : {})),
    scenes: [{ nodes: [0] }],
  }),
  gltf('a node in itself', /gltf\./, { nodes: [{ children: [0] }], scenes: [{ nodes: [0] }] }),
  gltf('numbers that are not there', /gltf\./, { ...view(3), bufferViews: [{ buffer: 0, byteLength: 2 ** 40 }] }),
  gltf('accessors without data', /gltf\./, {
    accessors: Array.from({ length: 1000 }, () => ({ componentType: 5126, count: 1e8, type: 'MAT4' })),
  }),
  gltf(
    'names of prototypes',
    /^$|./,
    '{"asset":{"version":"2.0"},"__proto__":{"polluted":1},"nodes":[{"name":"__proto__","extras":{"__proto__":{"polluted":1}}}],"scenes":[{"nodes":[0]}],"extensions":{"__proto__":{"polluted":1}}}',
  ),
  gltf('files of others', /gltf\./, {
    buffers: [
      { byteLength: 4, uri: '../../../../etc/passwd' },
      { byteLength: 4, uri: 'file:///etc/passwd' },
    ],
  }),
];

const PLY = 'ply\nformat ascii 1.0\n';
const meshBombs: readonly Bomb[] = [
  file('a.obj', 'a face of a million corners', /obj\./, `v 0 0 0\nv 1 0 0\nv 0 1 0\nf${' 1 2 3'.repeat(400_000)}\n`),
  file('a.obj', 'corners far away', /obj\./, 'v 0 0 0\nf 99999999999999999999 2 -9999999999\n'),
  file('a.obj', 'a library in itself', /file.units/, 'mtllib a.obj\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'),
  file(
    'a.ply',
    'four thousand million points',
    /ply\./,
    `${PLY}element vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n`,
  ),
  file(
    'a.ply',
    'countless elements of nothing',
    /ply\./,
    `${PLY}element nothing 9007199254740991\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n`,
  ),
  file(
    'a.ply',
    'a list without end',
    /ply\./,
    `${PLY}element vertex 1\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uint int vertex_indices\nend_header\n0 0 0\n4294967295 0 0 0\n`,
  ),
  file(
    'a.stl',
    'four thousand million triangles',
    /stl\./,
    Uint8Array.from({ length: 134 }, (_, i) => (i >= 80 && i < 84 ? 255 : 0)),
  ),
  file('a.stl', 'solids of nothing', /stl\./, 'solid a\nendsolid a\n'.repeat(100_000)),
];

const pictureBombs: readonly Bomb[] = [
  file('a.png', 'as many pixels as there are', /image\./, png(2 ** 31 - 1, 2 ** 31 - 1, 100)),
  file('a.png', 'fewer pixels than it holds', /image\.|^$/, png(1, 1, 2 ** 26)),
  file('a.png', 'more pixels than it holds', /image\./, png(8192, 8192, 100)),
  file(
    'a.jpg',
    'a picture of nothing',
    /image\./,
    Uint8Array.of(
      0xff,
      0xd8,
      0xff,
      0xc0,
      0,
      17,
      8,
      255,
      255,
      255,
      255,
      3,
      1,
      0x11,
      0,
      2,
      0x11,
      0,
      3,
      0x11,
      0,
      0xff,
      0xd9,
    ),
  ),
];

/** A PNG with the given size in its header and `zeros` bytes of data. */
function png(width: number, height: number, zeros: number): Uint8Array {
  const chunk = (type: string, data: Uint8Array): number[] => {
    const body = Uint8Array.of(...bytes(type), ...data);
    return [...u32(data.length), ...body, ...u32(crc32(body))];
  };
  const header = Uint8Array.of(...u32(width), ...u32(height), 8, 2, 0, 0, 0);
  const data = zlibSync(new Uint8Array(zeros), { level: 9 });
  const start = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];
  return Uint8Array.from([
    ...start,
    ...chunk('IHDR', header),
    ...chunk('IDAT', data),
    ...chunk('IEND', new Uint8Array()),
  ]);
}

function u32(x: number): number[] {
  return [x >>> 24, (x >>> 16) & 255, (x >>> 8) & 255, x & 255];
}

export const bombs: readonly Bomb[] = [...usdBombs, ...gltfBombs, ...meshBombs, ...pictureBombs];
