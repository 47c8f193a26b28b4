import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { describe, expect, it } from 'vitest';
import { inWords } from '../../../tests/support/inWords.ts';
import { sceneSoup, threeSoup } from '../../../tests/support/threeSoup.ts';
import { random } from '../../math/random.ts';
import { distance } from '../../math/vec3.ts';
import { inEnglish } from '../../messages/message.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import { InputError, type Scene } from '../../scene/types.ts';
import { memorySource } from '../files/fileSource.ts';
import { encodePng } from '../image/encodePng.ts';
import { readObj } from './index.ts';

const text = (value: string): Uint8Array => new TextEncoder().encode(value);
const read = (obj: string, files: Record<string, Uint8Array> = {}): Promise<Scene> =>
  readObj(memorySource({ 'set/a.obj': text(obj), ...files }), 'set/a.obj');
const refusal = (obj: string, files: Record<string, Uint8Array> = {}): Promise<string> =>
  read(obj, files).then(
    () => 'read',
    (error: Error) => error.message,
  );
const UNITS = 'neither unit nor up axis is written in it; one unit is taken as 1 m, Y as up';

/** A folded sheet of triangles and quads with uvs and normals, with positive and negative indices. */
function sheet(next: () => number): string {
  const n = 6;
  const lines = ['# a sheet', 'o Sheet'];
  for (let i = 0; i <= n; i++) {
    for (let j = 0; j <= n; j++) {
      lines.push(`v ${i} ${j} ${(next() - 0.5).toFixed(4)}`, `vt ${i / n} ${j / n}`, `vn ${next().toFixed(3)} 0.5 1`);
    }
  }
  const total = (n + 1) ** 2;
  const corner = (v: number): string => {
    const index = next() < 0.5 ? v + 1 : v - total;
    return `${index}/${index}/${index}`;
  };
  for (let i = 0; i < n; i++) {
    for (let j = 0; j < n; j++) {
      const a = i * (n + 1) + j;
      const quad = [a, a + n + 1, a + n + 2, a + 1].map(corner);
      if (next() < 0.5) lines.push(`f ${quad.join(' ')}`);
      else lines.push(`f ${quad.slice(0, 3).join(' ')}`, `f ${quad[0]} ${quad[2]} ${quad[3]}`);
    }
  }
  return lines.join('\n');
}

describe('OBJ shapes', () => {
  it('agree with three.js: triangles, quads, uvs, positive and negative indices', async () => {
    const obj = sheet(random(1));
    const scene = await read(obj);
    expect(sceneSoup(scene)).toEqual(threeSoup(new OBJLoader().parse(obj)));
    expect(scene.objects.map((o) => o.path)).toEqual(['/Sheet']);
    expect(scene.diagnostics.map((d) => inEnglish(d.message))).toEqual([UNITS]);
    expect([scene.name, scene.upAxis, scene.metersPerUnit]).toEqual(['a', 'Y', 1]);
  });

  it('normals are read and normalized', async () => {
    const { objects } = await read('v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 5\nvn 0 3 4\nf 1//1 2//2 3//1');
    expect([...objects[0].mesh.normals]).toEqual([0, 0, 1, 0, Math.fround(0.6), Math.fround(0.8), 0, 0, 1]);
  });

  it('concave polygons are triangulated inside', async () => {
    // An L: area 3, however it is triangulated.
    const { mesh } = (await read('v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6')).objects[0];
    const areas = Array.from({ length: mesh.indices.length / 3 }, (_, t) => {
      const [a, b, c] = [0, 1, 2].map((k) => pointAt(mesh.positions, mesh.indices[3 * t + k]));
      return ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2;
    });
    expect(areas.every((area) => area > 0)).toBe(true);
    expect(areas.reduce((sum, area) => sum + area, 0)).toBeCloseTo(3, 12);
  });

  it('without normals a face is flat, or smooth within its smoothing group', async () => {
    // Two squares that meet at a right angle along x = 0.
    const roof = 'v 0 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 0 0 1\nv 0 1 1\n';
    const faces = (a: string, b: string): string => `${roof}s ${a}\nf 1 3 4 2\ns ${b}\nf 1 2 6 5\n`;
    const normals = async (obj: string) => {
      const { mesh } = (await read(obj)).objects[0];
      return Array.from({ length: mesh.normals.length / 3 }, (_, v) => pointAt(mesh.normals, v));
    };
    const half = Math.SQRT1_2;
    const isSmooth = (n: readonly number[]) => distance([n[0], n[1], n[2]], [half, 0, half]) < 1e-6;
    expect((await normals(faces('off', 'off'))).filter(isSmooth).length).toBe(0);
    expect((await normals(faces('1', '2'))).filter(isSmooth).length).toBe(0);
    // The two points of the edge, each once.
    expect((await normals(faces('7', '7'))).filter(isSmooth).length).toBe(2);
    expect((await normals(faces('7', '7'))).length).toBe(6);
  });

  it('objects and groups become objects, wherever their faces are', async () => {
    const triangle = 'f 1 2 3\n';
    const obj = `v 0 0 0\nv 1 0 0\nv 0 1 0\n${triangle}o Car\n${triangle}g wheel left\n${triangle}o Tree\n${triangle}o Car\n${triangle}`;
    const { objects } = await read(obj);
    expect(objects.map((o) => [o.path, o.mesh.indices.length / 3])).toEqual([
      ['/a', 1],
      ['/Car', 2],
      ['/Car_wheel_left', 1],
      ['/Tree', 1],
    ]);
  });

  it('vertex colours are sRGB, 0 … 1 or 0 … 255; the default is white', async () => {
    const colors = async (obj: string) => [...(await read(obj)).objects[0].mesh.colors!];
    const half = Math.fround(((0.5 + 0.055) / 1.055) ** 2.4);
    expect(await colors('v 0 0 0\nv 1 0 0 0.5 0 1\nv 0 1 0 1 1 0\nf 1 2 3')).toEqual([1, 1, 1, half, 0, 1, 1, 1, 0]);
    expect(await colors('v 0 0 0 255 0 0\nv 1 0 0 0 0 255\nv 0 1 0\nf 1 2 3')).toEqual([1, 0, 0, 0, 0, 1, 1, 1, 1]);
  });

  it('lines continue after a backslash, and have any line ends', async () => {
    const { objects } = await read('v 0 0 0\r\nv 1 0 \\\r\n0\rv 0 1 0 # here\n\nf 1 \\\n 2 3');
    expect(objects[0].mesh.indices.length).toBe(3);
  });

  it('reports skipped statements', async () => {
    const { diagnostics, objects } = await read('v 0 0 0\np 1\nl 1 1\nl 1 1\nfrobnicate 3\n');
    expect(objects).toEqual([]);
    expect(diagnostics.map((d) => [d.severity, inEnglish(d.place), inEnglish(d.message)])).toEqual([
      ['warning', 'set/a.obj: line 2', 'points are not shown (p, first on this line)'],
      ['warning', 'set/a.obj: line 3', 'lines are not shown (l, first on this line)'],
      ['info', 'set/a.obj: line 5', 'frobnicate is not known; lines that begin with it are left out'],
      ['info', 'set/a.obj', UNITS],
      ['warning', 'set/a.obj', 'no triangle is in it, so that there is nothing to see'],
    ]);
  });
});

describe('OBJ materials', () => {
  const square = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n';
  const face = 'f 1/1 2/2 3/3\n';
  const png = encodePng(1, 1, Uint8Array.of(255, 0, 0, 255));

  it('are read with their textures', async () => {
    const mtl = `newmtl Red paint
Kd 0.5 0.25 0
Ks 1 1 1
Ns 98
d 0.5
Ni 1.4
map_Kd -s 2 3 1 -o 0.5 0.25 -clamp on C:\\maps\\red paint.png
map_Bump bumps.png
newmtl Gold
Kd 1 0.8 0.2
Pr 0.2
Pm 1
Tr 0.25
Ke 3 2 1
`;
    const files = { 'set/my car.mtl': text(mtl), 'set/red paint.png': png };
    const obj = `mtllib my car.mtl\n${square}usemtl Red paint\n${face}usemtl Gold\n${face}usemtl Red paint\n${face}`;
    const { materials, objects, diagnostics } = await read(obj, files);
    expect(materials.map((m) => m.name)).toEqual(['Red paint', 'Gold']);
    // 2 / (98 + 2) is the fourth power of the roughness.
    expect(materials[0]).toMatchObject({ baseColor: [0.5, 0.25, 0], opacity: 0.5, ior: 1.4, metallic: 0 });
    expect(materials[0].roughness).toBeCloseTo(0.02 ** 0.25, 12);
    expect(materials[0].baseColorTexture).toMatchObject({ width: 1, height: 1, wrapS: 'clamp', colorSpace: 'srgb' });
    expect(materials[1]).toMatchObject({ roughness: 0.2, metallic: 1, opacity: 0.75, emissive: [3, 2, 1] });
    const { mesh } = objects[0];
    expect(mesh.groups.map((g) => [g.count, g.material])).toEqual([
      [6, 0],
      [3, 1],
    ]);
    // (1, 0) · (2, 3) + (0.5, 0.25) in the first, (1, 0) unchanged in the second.
    const uvOf = (corner: number) => [...mesh.uvs.subarray(2 * mesh.indices[corner], 2 * mesh.indices[corner] + 2)];
    expect([uvOf(1), uvOf(7)]).toEqual([
      [2.5, 0.25],
      [1, 0],
    ]);
    expect(diagnostics.map((d) => inEnglish(d.message))).toEqual(['map_Bump of it is left out', UNITS]);
  });

  it('opacity may have its own texture', async () => {
    const mask = encodePng(2, 1, Uint8Array.of(0, 0, 0, 255, 255, 255, 255, 255));
    const mtl = 'newmtl Leaf\nmap_Kd red.png\nmap_d mask.png\nnewmtl Veil\nKs 0 0 0\nmap_d mask.png\n';
    const files = {
      'set/m.mtl': text(mtl),
      'set/red.png': encodePng(2, 1, Uint8Array.of(255, 0, 0, 255, 255, 0, 0, 255)),
      'set/mask.png': mask,
    };
    const { materials } = await read(`mtllib m.mtl\n${square}usemtl Leaf\n${face}usemtl Veil\n${face}`, files);
    expect([...materials[0].baseColorTexture!.data]).toEqual([255, 0, 0, 0, 255, 0, 0, 255]);
    expect([...materials[1].baseColorTexture!.data]).toEqual([255, 255, 255, 0, 255, 255, 255, 255]);
    expect(materials[1].roughness).toBe(1);
  });

  it('that are missing are reported with the searched location', async () => {
    const files = {
      'set/b.mtl': text('newmtl A\nmap_Kd D:\\x\\no.png\nmap_Ke bad.png\nmap_d -clamp 7'),
      'set/bad.png': text('GIF89a'),
    };
    const obj = `mtllib b.mtl no.mtl\n${square}usemtl A\n${face}usemtl B\n${face}`;
    const { materials, diagnostics } = await read(obj, files);
    expect(materials.map((m) => m.name)).toEqual(['A', 'B']);
    expect(diagnostics.filter((d) => d.severity === 'warning').map(inWords)).toEqual([
      'set/a.obj: line 1: the materials no.mtl are not there (looked for set/no.mtl); put them beside it, or open the folder that holds both',
      'set/a.obj: set/b.mtl: line 4, material A: the texture 7 is not there (looked for set/7); shown without it',
      'set/a.obj: set/b.mtl: line 2, material A: the texture D:\\x\\no.png is not there (looked for set/D:/x/no.png, set/no.png); shown without it',
      'set/a.obj: set/b.mtl: line 3: set/bad.png: the picture is neither PNG nor JPEG; convert it to PNG or JPEG; shown without it',
      'set/a.obj: B: no such material (set/b.mtl); it is shown light grey',
    ]);
  });
});

it('texture coordinates and normals that do not exist are reported once each, by the line of the highest', async () => {
  const scene = await read('v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 0.25\nf 1/1 2/7 3/9/2\nf 1/1 3/8 2/1\n');
  expect(scene.diagnostics.map(({ place, message }) => `${inEnglish(place)}: ${inEnglish(message)}`)).toEqual([
    'set/a.obj: line 5: a face names uv 9 of 1; corners that name one that is not there (3) are shown as without',
    'set/a.obj: line 5: a face names normal 2 of 0; corners that name one that is not there (1) are shown as without',
    `set/a.obj: ${UNITS}`,
  ]);
  expect(scene.objects[0]!.mesh.indices.length).toBe(6);
  expect(scene.objects[0]!.mesh.uvs!.every((x) => [0, 0.5, 0.25].includes(x))).toBe(true);
});

describe('a damaged OBJ', () => {
  it.each([
    ['v 1 2\n', 'set/a.obj: line 1: a number is missing; the file is cut off or damaged'],
    ['v 1 2 1,5\n', 'set/a.obj: line 1: 1,5 is not a number'],
    ['v 1 2 1e999\n', 'set/a.obj: line 1: 1e999 is not a number'],
    ['v 1 2 1e39\n', 'set/a.obj: line 1: 1e39 is too large a number'],
    ['v 0 0 0\n\nf 1 2\n', 'set/a.obj: line 3: a face has 2 corners; from 3 to 4096 are read'],
    [
      'v 0 0 0\nf 1 1 9\nf 1 1 2',
      'set/a.obj: line 2: a face names point 9 of 1; the file is cut off or damaged, export it again',
    ],
    [
      'v 0 0 0\nf 1 1 0',
      'set/a.obj: line 2: the corner 0 names point 0; indices count from 1, or back from −1, and there are 1 so far',
    ],
    [
      'v 0 0 0\nf 1 -2 1',
      'set/a.obj: line 2: the corner -2 names point -2; indices count from 1, or back from −1, and there are 1 so far',
    ],
    ['v 0 0 0\nf 1//x 1 1', 'set/a.obj: line 2: the corner 1//x names normal x; indices count from 1'],
    [`mtllib ${'a.mtl '.repeat(2000)}`, 'set/a.obj: line 1: more than 1000 files of materials are named'],
    [Array.from({ length: 200 }, (_, i) => `x${i}`).join('\n'), 'set/a.obj: line 101: it is no Wavefront OBJ'],
  ])('%j is refused', async (obj, message) => {
    expect(await refusal(obj)).toContain(message);
  });

  it('and its materials are rejected with file, line and value', async () => {
    const files = { 'set/m.mtl': text('newmtl A\nKd 1 2 x') };
    expect(await refusal('mtllib m.mtl\n', files)).toBe('set/m.mtl: line 2: x is not a number');
  });

  const whole = `mtllib m.mtl\n${sheet(random(2))}\ns 1\nusemtl A\nf 1 2 3 4\nf -1 -2 -3 -4 -5`;
  const files = (obj: Uint8Array, mtl: Uint8Array) => memorySource({ 'a.obj': obj, 'm.mtl': mtl });
  const mtl = text('newmtl A\nKd 1 0 0\nmap_Kd -s 1 1 1 -o 0 0 no.png\nPr 1\n');
  const attempt = (obj: Uint8Array, mtl: Uint8Array): Promise<unknown> =>
    readObj(files(obj, mtl), 'a.obj').then(
      () => undefined,
      (error) => error,
    );

  it('truncated anywhere is read or an InputError', async () => {
    const obj = text(whole);
    expect(await attempt(obj, mtl)).toBeUndefined();
    for (let k = 0; k < 20; k++) {
      const error = await attempt(obj.subarray(0, Math.floor((obj.length * k) / 20)), mtl);
      if (error !== undefined) expect(error).toBeInstanceOf(InputError);
    }
  });

  it('with flipped bits is read or an InputError', async () => {
    const next = random(20261121);
    const flipped = (bytes: Uint8Array): Uint8Array => {
      const at = Math.floor(next() * bytes.length);
      return bytes.with(at, bytes[at] ^ (1 << Math.floor(next() * 8)));
    };
    for (let k = 0; k < 300; k++) {
      const error = await attempt(flipped(text(whole)), flipped(mtl));
      if (error !== undefined) expect(error).toBeInstanceOf(InputError);
    }
  });
});
