import { expect } from 'vitest';
import type { Scene } from '../../src/scene/types.ts';
import { type ClaimGroup, type Files, leftOut, read, refused } from './claim.ts';
import { PIXEL, WEBP } from './pictures.ts';

interface Parts {
  readonly format?: string;
  readonly comment?: string;
  readonly vertex?: string;
  readonly vertices?: readonly string[];
  readonly face?: string;
  readonly faces?: readonly string[];
}

const ply = ({
  format = 'ascii',
  comment = 'made by hand',
  vertex = '',
  vertices = ['0 0 0', '1 0 0', '1 1 0', '0 1 0'],
  face = 'property list uchar int vertex_indices',
  faces = ['4 0 1 2 3'],
}: Parts = {}): Files => ({
  'a.ply': `ply\nformat ${format} 1.0\ncomment ${comment}\nelement vertex ${vertices.length}\nproperty float x\nproperty float y\nproperty float z\n${vertex}element face ${faces.length}\n${face}\nend_header\n${[...vertices, ...faces].join('\n')}\n`,
});

/** A triangle in binary, of either byte order. */
function binary(format: 'binary_little_endian' | 'binary_big_endian'): Files {
  const header = new TextEncoder().encode(
    (ply({ format, vertices: Array(3).fill(''), faces: [''] })['a.ply'] as string).trimEnd().concat('\n'),
  );
  const view = new DataView(new ArrayBuffer(36 + 13));
  const little = format === 'binary_little_endian';
  [0, 0, 0, 1, 0, 0, 0, 1, 0].forEach((x, i) => {
    view.setFloat32(4 * i, x, little);
  });
  view.setUint8(36, 3);
  [0, 1, 2].forEach((v, i) => {
    view.setInt32(37 + 4 * i, v, little);
  });
  return { 'a.ply': new Uint8Array([...header, ...new Uint8Array(view.buffer)]) };
}

const triangles = (count: number) => (scene: Scene) => expect(scene.objects[0].mesh.indices.length).toBe(3 * count);
const red = (scene: Scene): void => expect([...scene.objects[0].mesh.colors!.subarray(0, 3)]).toEqual([1, 0, 0]);
const COLORS = 'property uchar red\nproperty uchar green\nproperty uchar blue\n';

const contents: ClaimGroup = {
  title: 'Contents',
  rows: [
    read('text; all scalar types', 'a mesh', ply(), triangles(2)),
    read('binary, little-endian', 'the same', binary('binary_little_endian'), triangles(1)),
    read('binary, big-endian', 'the same', binary('binary_big_endian'), triangles(1)),
    read(
      '`vertex`: `x y z`, `nx ny nz`, `s t` or `u v` or `texture_u texture_v`, `red green blue` (also `r g b`, `diffuse_red` …)',
      'points, normals, uvs, colours (as sRGB)',
      ply({
        vertex: COLORS,
        vertices: Array(4)
          .fill(0)
          .map((_, i) => `${i >> 1} ${i & 1} 0 255 0 0`),
      }),
      red,
    ),
    read(
      '`face`: `vertex_indices` or `vertex_index`, `texcoord`, colours',
      'polygons, uvs per corner, face colours if the points have none; without normals, edges below 60° are smooth',
      ply({ face: `property list uchar int vertex_index\n${COLORS.trimEnd()}`, faces: ['4 0 1 2 3 255 0 0'] }),
      red,
    ),
    read(
      '`tristrips`',
      'triangles',
      {
        'a.ply': (ply({ faces: ['5 0 1 2 -1 3'] })['a.ply'] as string)
          .replace('element face', 'element tristrips')
          .replace('uchar int', 'int int')
          .replace('5 0 1 2 -1 3', '4 0 1 2 3'),
      },
      triangles(2),
    ),
    read(
      '`comment TextureFile x.png`',
      'the texture of the material',
      { ...ply({ comment: 'TextureFile a.png' }), 'a.png': PIXEL },
      (s) => expect(s.materials[0].baseColorTexture?.width).toBe(1),
    ),
    read(
      'other elements and properties',
      'ignored',
      ply({
        vertex: 'property float confidence\n',
        vertices: Array(4)
          .fill(0)
          .map((_, i) => `${i >> 1} ${i & 1} 0 1`),
      }),
      triangles(2),
    ),
    leftOut('points without faces', 'reported', 'ply.points', ply({ faces: [] })),
    leftOut(
      'values beyond the declared ones, in text with a row on each line',
      'reported with their number',
      'ply.extra-values',
      ply({ vertices: ['0 0 0 7 7', '1 0 0', '1 1 0 7', '0 1 0'], faces: ['4 0 1 2 3 255 0 0'] }),
      (scene) => {
        triangles(2)(scene);
        expect([...scene.objects[0].mesh.positions.subarray(0, 6)]).toEqual([0, 0, 0, 1, 0, 0]);
        expect(scene.diagnostics).toContainEqual(
          expect.objectContaining({ message: expect.objectContaining({ values: [6] }) }),
        );
      },
    ),
    leftOut(
      'Gaussian splats, as trained or packed',
      'reported with their number',
      'ply.splats',
      ['f_dc_0 opacity scale_0 rot_0', 'packed_position packed_rotation packed_scale packed_color'].map((names) =>
        ply({
          vertex: names.replace(/\S+ ?/g, (name) => `property float ${name.trim()}\n`),
          vertices: ['0 0 0 1 1 1 1'],
          faces: [],
        }),
      ),
    ),
    leftOut(
      'faces with fewer than 3 corners',
      'reported with their number',
      'ply.faces',
      ply({ faces: ['4 0 1 2 3', '2 0 1'] }),
      triangles(2),
    ),
    leftOut(
      'a missing picture',
      'reported with the places that were searched',
      'file.missing-texture',
      ply({ comment: 'TextureFile a.png' }),
      triangles(2),
    ),
    leftOut(
      'a picture that is damaged, too large, or neither PNG nor JPEG',
      'reported with what it is',
      'file.unreadable-texture',
      { ...ply({ comment: 'TextureFile a.png' }), 'a.png': WEBP },
      triangles(2),
    ),
    refused('a header that is damaged or not PLY', 'with its line', 'ply.header', { 'a.ply': 'plush\n' }),
    refused(
      'a word in place of a number',
      'with its line',
      'ply.number',
      ply({ vertices: ['0 0 x', '1 0 0', '1 1 0', '0 1 0'] }),
    ),
    refused('an invalid index or length', 'with location and value', 'ply.value', ply({ faces: ['4 0 1 2 9'] })),
    refused('a truncated file', 'with the actual and the expected amount', 'ply.truncated', {
      'a.ply': (binary('binary_little_endian')['a.ply'] as Uint8Array).slice(0, -20),
    }),
    refused('a file without vertices', 'reported', 'ply.no-vertices', {
      'a.ply': 'ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n3 0 1 2\n',
    }),
  ],
};

export const plyGroups: readonly ClaimGroup[] = [contents];
