import { Mesh as ThreeMesh } from 'three';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { describe, expect, it } from 'vitest';
import { sceneSoup, threeSoup } from '../../../tests/support/threeSoup.ts';
import { random } from '../../math/random.ts';
import { inEnglish } from '../../messages/message.ts';
import { InputError, type Scene } from '../../scene/types.ts';
import { memorySource } from '../files/fileSource.ts';
import { encodePng } from '../image/encodePng.ts';
import { readPly } from './index.ts';

type Format = 'ascii' | 'binary_little_endian' | 'binary_big_endian';
const FORMATS: readonly Format[] = ['ascii', 'binary_little_endian', 'binary_big_endian'];
const encode = (value: string): Uint8Array => new TextEncoder().encode(value);
const read = (bytes: Uint8Array, files: Record<string, Uint8Array> = {}): Promise<Scene> =>
  readPly(memorySource({ 'a.ply': bytes, ...files }), 'a.ply');
const refusal = (bytes: Uint8Array): Promise<string> =>
  read(bytes).then(
    () => 'read',
    (error: Error) => error.message,
  );

/** Rows of values with their types. */
type Typed = readonly (readonly [type: string, value: number])[];

/** A PLY of any format from one description. */
function ply(format: Format, header: readonly string[], rows: readonly Typed[]): Uint8Array {
  const head = encode(['ply', `format ${format} 1.0`, ...header, 'end_header', ''].join('\n'));
  if (format === 'ascii') {
    return new Uint8Array([...head, ...encode(rows.map((row) => row.map(([, x]) => x).join(' ')).join('\n'))]);
  }
  const body = new DataView(new ArrayBuffer(16 * rows.flat().length));
  const little = format === 'binary_little_endian';
  let at = 0;
  for (const [type, value] of rows.flat()) {
    if (type === 'uchar') body.setUint8(at, value);
    else if (type === 'int') body.setInt32(at, value, little);
    else if (type === 'double') body.setFloat64(at, value, little);
    else body.setFloat32(at, value, little);
    at += { uchar: 1, int: 4, double: 8 }[type] ?? 4;
  }
  return new Uint8Array([...head, ...new Uint8Array(body.buffer, 0, at)]);
}

/** A bumpy sheet of triangles and quads with normals, uvs and colours per point, and an unknown element. */
function sheet(format: Format): Uint8Array {
  const next = random(4);
  const n = 5;
  const rows: Typed[] = [];
  for (let i = 0; i <= n; i++) {
    for (let j = 0; j <= n; j++) {
      const round = (x: number): number => Math.fround(Math.round(x * 1024) / 1024);
      const floats = [i, j, round(next()), 0, 0, 1, round(i / n), round(j / n)];
      const colors = [0, 0, 0].map(() => Math.floor(next() * 256));
      rows.push([...floats.map((x) => ['float', x] as const), ...colors.map((x) => ['uchar', x] as const)]);
    }
  }
  rows.push([
    ['uchar', 2],
    ['double', 7],
    ['double', 8],
    ['int', 9],
  ]);
  let faces = 0;
  const face = (...corners: number[]): void => {
    faces++;
    rows.push([['uchar', corners.length], ...corners.map((c) => ['int', c] as const)]);
  };
  for (let i = 0; i < n; i++) {
    for (let j = 0; j < n; j++) {
      const a = i * (n + 1) + j;
      if (next() < 0.5) face(a, a + n + 1, a + n + 2, a + 1);
      else {
        face(a, a + n + 1, a + n + 2);
        face(a, a + n + 2, a + 1);
      }
    }
  }
  const floats = ['x', 'y', 'z', 'nx', 'ny', 'nz', 's', 't'].map((name) => `property float ${name}`);
  const colors = ['red', 'green', 'blue'].map((name) => `property uchar ${name}`);
  const noise = ['element noise 1', 'property list uchar double some', 'property int32 other'];
  const header = ['comment made up', `element vertex ${(n + 1) ** 2}`, ...floats, ...colors, ...noise];
  return ply(format, [...header, `element face ${faces}`, 'property list uchar int vertex_indices'], rows);
}

describe.each(FORMATS)('PLY, %s', (format) => {
  it('agrees with three.js', async () => {
    const bytes = sheet(format);
    const scene = await read(bytes);
    const three = new PLYLoader().parse(bytes.slice().buffer);
    expect(sceneSoup(scene, true)).toEqual(threeSoup(new ThreeMesh(three), true));
    expect(scene.diagnostics.map((d) => d.code)).toEqual(['file.units']);
    // Vertex 0 is in the first face, however that is triangulated.
    const { mesh } = scene.objects[0];
    const zero = [...mesh.indices].find((v) => mesh.positions[3 * v] === 0 && mesh.positions[3 * v + 1] === 0)!;
    // three.js keeps colours in bytes.
    const { color } = three.attributes;
    const rgb = [color.getX(0), color.getY(0), color.getZ(0)];
    for (let k = 0; k < 3; k++) expect(Math.abs(mesh.colors![3 * zero + k] - rgb[k])).toBeLessThan(0.6 / 255);
  });

  it('colours and uvs of faces, doubles, other names', async () => {
    const vertex = (x: number, y: number): Typed => [x, y, 0].map((v) => ['double', v]);
    const rows: Typed[] = [vertex(0, 0), vertex(1, 0), vertex(0, 1)];
    rows.push([
      ...[3, 0, 1, 2].map((v, i) => [i === 0 ? 'uchar' : 'int', v] as const),
      ['uchar', 6],
      ...[0, 0, 1, 0, 0, 1].map((v) => ['float', v] as const),
      ['float', 1],
      ['float', 0.5],
      ['float', 0],
    ]);
    const xyz = ['x', 'y', 'z'].map((name) => `property float64 ${name}`);
    const rgb = ['red', 'green', 'blue'].map((name) => `property float ${name}`);
    const lists = ['property list uint8 int32 vertex_index', 'property list uint8 float32 texcoord'];
    const texture = 'comment TextureFile red.png';
    const bytes = ply(format, [texture, 'element vertex 3', ...xyz, 'element face 1', ...lists, ...rgb], rows);
    const png = encodePng(1, 1, Uint8Array.of(255, 0, 0, 255));
    const { objects, materials } = await read(bytes, { 'red.png': png });
    const half = Math.fround(((0.5 + 0.055) / 1.055) ** 2.4);
    expect([...objects[0].mesh.colors!]).toEqual([1, half, 0, 1, half, 0, 1, half, 0]);
    expect([...objects[0].mesh.uvs]).toEqual([0, 0, 1, 0, 0, 1]);
    expect(materials[0]).toMatchObject({ baseColor: [1, 1, 1], baseColorTexture: { width: 1 } });
    expect(inEnglish((await read(bytes)).diagnostics[0].message)).toBe(
      'the texture red.png is not there (looked for red.png); shown without it',
    );
  });

  it('strips are split into triangles of consistent winding', async () => {
    const rows: Typed[] = [
      [0, 0],
      [1, 0],
      [0, 1],
      [1, 1],
      [0, 2],
    ].map(([x, y]) => [x, y, 0].map((v) => ['float', v] as const));
    rows.push([8, 0, 1, 2, 3, -1, 2, 3, 4].map((v) => ['int', v]));
    const xyz = ['x', 'y', 'z'].map((name) => `property float ${name}`);
    const strip = ['element tristrips 1', 'property list int int vertex_indices'];
    const { mesh } = (await read(ply(format, ['element vertex 5', ...xyz, ...strip], rows))).objects[0];
    expect(mesh.indices.length / 3).toBe(3);
    expect([...mesh.normals].filter((_, i) => i % 3 === 2)).toEqual([1, 1, 1, 1, 1]);
  });

  it('is rejected if truncated', async () => {
    const bytes = sheet(format);
    // In text a missing part of the last number cannot be detected.
    for (let k = 0; k < 20; k++) {
      await expect(read(bytes.subarray(0, Math.floor((bytes.length * k) / 20)))).rejects.toBeInstanceOf(InputError);
    }
    expect(await refusal(bytes.subarray(0, bytes.length - 20))).toMatch(/cut off/);
  });

  it('rejects counts that exceed the file before allocating memory', async () => {
    const text = new TextDecoder('latin1').decode(sheet(format));
    const bytes = (value: string): Uint8Array => Uint8Array.from(value, (c) => c.charCodeAt(0));
    expect(await refusal(bytes(text.replace('vertex 36', 'vertex 999999999999')))).toMatch(
      /^a\.ply: (byte|line) \d+: 999999999999 rows of vertex take [\d.]+ TiB at the least, but [\d.]+ (KiB|bytes) are left/,
    );
    expect(await refusal(bytes(text.replace('element noise 1\n', 'element noise 999999999999\n')))).toMatch(
      /999999999999 rows of noise take/,
    );
  });
});

describe('PLY', () => {
  const head = (...lines: string[]): string => ['ply', 'format ascii 1.0', ...lines, 'end_header', ''].join('\n');
  const xyz = ['property float x', 'property float y', 'property float z'];
  const mesh = (faces: string): Uint8Array =>
    encode(
      `${head('element vertex 3', ...xyz, 'element face 1', 'property list uchar int vertex_indices')}0 0 0\n1 0 0\n0 1 0\n${faces}\n`,
    );

  it.each([
    ['solid x', 'a.ply: line 1: it does not begin with ply; it is no PLY'],
    ['ply\nformat ascii 1.0\n', 'a.ply: line 1: its header has no end_header'],
    ['ply\nend_header\n', 'a.ply: line 2: its header has no format'],
    ['ply\nformat ascii 2.0\nend_header\n', 'a.ply: line 2: the format ascii 2.0 is not known'],
    [head('element vertex -1'), 'a.ply: line 3: an element needs a name and a count, not vertex -1'],
    [head('property float x'), 'a.ply: line 3: a property comes before the first element'],
    [head('element vertex 1', 'property toString x'), 'a.ply: line 4: the type toString is not known'],
    [head('element vertex 0', 'element vertex 0'), 'a.ply: line 4: the element vertex comes twice'],
    [head('colour red'), 'a.ply: line 3: colour is not known in a header'],
    [head(), 'a.ply: has no element vertex; it holds no mesh'],
    [
      head('element vertex 1', 'property float x'),
      'a.ply: line 5: 1 rows of vertex take 1 bytes at the least, but 0 bytes are left',
    ],
    [`${head('element vertex 1', 'property float x')}1`, 'a.ply: its vertices have no x, y and z'],
  ])('%j is refused', async (text, message) => {
    expect(await refusal(encode(text))).toContain(message);
  });

  it('invalid values are rejected with their line', async () => {
    expect(await refusal(mesh('3 0 1 2'))).toBe('read');
    expect(await refusal(mesh('3 0 1 3'))).toBe(
      'a.ply: line 13: face 0 names vertex 3; there are 3, counted from 0; the file is damaged, export it again',
    );
    expect(await refusal(mesh('3 0 1 x'))).toBe('a.ply: line 13: x is not a number');
    expect(await refusal(mesh('3 0 1'))).toContain('line 13: a number is missing at the end');
    expect(await refusal(mesh('-1 0 1'))).toContain('line 13: a list vertex_indices has the length -1');
    expect(await refusal(mesh('99999 0 1'))).toContain('line 13: 99999 values of vertex_indices take 195 KiB');
    expect((await read(mesh('2 0 1'))).diagnostics.map((d) => d.code)).toEqual([
      'ply.faces',
      'file.units',
      'file.no-triangles',
    ]);
  });

  it('a file of points only is reported as not displayed', async () => {
    const cloud = encode(`${head('element vertex 1', ...xyz)}1 2 3\n`);
    expect(inEnglish((await read(cloud)).diagnostics[0].message)).toBe(
      'its 1 points have no faces; points are not shown',
    );
  });
});
