import { Mesh as ThreeMesh } from 'three';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import { describe, expect, it } from 'vitest';
import { inWords } from '../../../tests/support/inWords.ts';
import { area, openEdges, volume } from '../../../tests/support/meshes.ts';
import { sceneSoup, threeSoup } from '../../../tests/support/threeSoup.ts';
import { inEnglish } from '../../messages/message.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import { box } from '../../scene/mesh/primitives.ts';
import { InputError, type Mesh, type Scene } from '../../scene/types.ts';
import { memorySource } from '../files/fileSource.ts';
import { readStl } from './index.ts';

const encode = (value: string): Uint8Array => new TextEncoder().encode(value);
const read = (bytes: Uint8Array): Promise<Scene> => readStl(memorySource({ 'a.stl': bytes }), 'a.stl');
const refusal = (bytes: Uint8Array): Promise<string> =>
  read(bytes).then(
    () => 'read',
    (error: Error) => error.message,
  );

/** Corners of the triangles, with a normal each. */
const facetsOf = ({ positions, normals, indices }: Mesh) =>
  Array.from({ length: indices.length / 3 }, (_, t) => {
    const [a, b, c] = indices.subarray(3 * t, 3 * t + 3);
    return { normal: pointAt(normals, a), corners: [a, b, c].map((v) => pointAt(positions, v)) };
  });

function textStl(mesh: Mesh, name = 'Box'): string {
  const facets = facetsOf(mesh).map(
    ({ normal, corners }) =>
      `  facet normal ${normal.join(' ')}\n    outer loop\n${corners.map((p) => `      vertex ${p.join(' ')}\n`).join('')}    endloop\n  endfacet\n`,
  );
  return `solid ${name}\n${facets.join('')}endsolid ${name}\n`;
}

function binaryStl(mesh: Mesh, header = ''): Uint8Array {
  const facets = facetsOf(mesh);
  const bytes = new Uint8Array(84 + 50 * facets.length);
  bytes.set(encode(header));
  const view = new DataView(bytes.buffer);
  view.setUint32(80, facets.length, true);
  for (const [f, { normal, corners }] of facets.entries()) {
    for (const [k, x] of [normal, ...corners].flat().entries()) view.setFloat32(84 + 50 * f + 4 * k, x, true);
  }
  return bytes;
}

const BOX = box([1, 2, 3]);

describe.each([
  ['text', encode(textStl(BOX))],
  ['binary', binaryStl(BOX)],
  ['binary that begins as a text does', binaryStl(BOX, 'solid as a rock')],
])('STL, %s', (_, bytes) => {
  it('is a closed box of the right size, as in three.js', async () => {
    const scene = await read(bytes);
    const [{ mesh }] = scene.objects;
    expect(openEdges(mesh)).toBe(0);
    expect([volume(mesh), area(mesh)]).toEqual([expect.closeTo(6, 5), expect.closeTo(22, 5)]);
    const three = new ThreeMesh(new STLLoader().parse(bytes.slice().buffer));
    expect(sceneSoup(scene, true)).toEqual(threeSoup(three, true));
    expect(scene.diagnostics.map((d) => d.code)).toEqual(['file.units']);
  });

  it('is rejected if truncated', async () => {
    for (let k = 0; k < 20; k++) {
      await expect(read(bytes.subarray(0, Math.floor((bytes.length * k) / 20)))).rejects.toBeInstanceOf(InputError);
    }
  });
});

describe('STL', () => {
  it('solids of a text file become objects; keywords are case-insensitive', async () => {
    const two = `${textStl(BOX, 'Left part')}${textStl(BOX, '').toUpperCase()}`;
    expect((await read(encode(two))).objects.map((o) => o.path)).toEqual(['/Left_part', '/a']);
  });

  it('reports skipped and inconsistent content', async () => {
    const colored = binaryStl(BOX, 'COLOR=rgba');
    const longer = new Uint8Array([...colored, 1, 2, 3]);
    const turned = encode(
      textStl(BOX).replace(/normal (\S+) (\S+) (\S+)/g, (_, x, y, z) => `normal ${-x} ${-y} ${-z}`),
    );
    expect((await read(longer)).diagnostics.map(inWords)).toEqual(
      expect.arrayContaining([
        'a.stl: byte 684: 3 bytes follow the 12 facets; they are left out',
        'a.stl: its colours are left out',
      ]),
    );
    expect(inEnglish((await read(turned)).diagnostics[0].message)).toBe(
      'the normals of 12 facets say the opposite of the order of their corners, which is what is taken',
    );
    expect((await read(encode('solid\nendsolid'))).diagnostics.map((d) => d.code)).toEqual([
      'file.units',
      'file.no-triangles',
    ]);
  });

  it('errors have place and value', async () => {
    const nan = binaryStl(BOX);
    new DataView(nan.buffer).setFloat32(84 + 50 + 12 + 4, Number.NaN, true);
    expect(await refusal(nan)).toBe(
      'a.stl: byte 150: facet 2 of 12 has a corner at NaN; the file is damaged, export it again',
    );
    const bomb = binaryStl(BOX);
    new DataView(bomb.buffer).setUint32(80, 0xffffffff, true);
    expect(await refusal(bomb)).toBe(
      'a.stl: byte 80: 4294967295 facets take 200 GiB, but the file has 684 bytes: it is cut off, or no STL; copy it again',
    );
    expect(await refusal(encode('x'))).toContain('of 1 bytes is neither text (it does not begin with solid) nor long');
    const facet = 'solid\nfacet normal 0 0 1\nouter loop\n';
    expect(await refusal(encode(`${facet}vertex 0 0 z\n`))).toBe('a.stl: line 4: z is not a number');
    expect(await refusal(encode(`${facet}vertex 0 0 1e39\n`))).toBe('a.stl: line 4: 1e39 is too large a number');
    expect(await refusal(encode(`${facet}vertex 0 0\n`))).toContain('line 4: a number is missing');
    expect(await refusal(encode(`${facet}endloop\n`))).toContain('line 4: a facet has 3 corners, this one 0');
    expect(await refusal(encode(`${facet}${'vertex 0 0 0\n'.repeat(4)}`))).toContain('line 7: a facet has 3 corners');
    expect(await refusal(encode('solid\nvertex 0 0 0\n'))).toContain(
      'line 2: facet or endsolid should stand here, not',
    );
    expect(await refusal(encode(facet))).toContain('line 3: the file ends inside a loop; it is cut off');
  });
});
