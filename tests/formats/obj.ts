import { expect } from 'vitest';
import type { Material, Scene } from '../../src/scene/types.ts';
import { approximated, type ClaimGroup, type Files, leftOut, read, refused } from './claim.ts';
import { PIXEL, WEBP } from './pictures.ts';

const FACE = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n';
const obj = (text: string): Files => ({ 'a.obj': text });
/** A square with the material `m`, given by lines of MTL. */
export const withMaterial = (lines: string, more: Files = {}): Files => ({
  'a.obj': `mtllib a.mtl\nusemtl m\n${FACE.replace('f 1 2 3 4', 'vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3')}`,
  'a.mtl': `newmtl m\n${lines}\n`,
  ...more,
});
const triangles = (count: number) => (scene: Scene) => expect(scene.objects[0].mesh.indices.length).toBe(3 * count);
const looks = (wanted: Partial<Material>) => (scene: Scene) => expect(scene.materials[0]).toMatchObject(wanted);
const pathsOf = (scene: Scene): string[] => scene.objects.map(({ path }) => path);

const shapes: ClaimGroup = {
  title: 'Shapes',
  rows: [
    read(
      '`v`, `vt`, `vn`, `f` with polygons; indices from 1, or back from −1',
      'triangles, with uvs and normals if the file has them',
      obj(FACE.replace('1 2 3 4', '-4 -3 -2 -1')),
      triangles(2),
    ),
    read(
      '`s`',
      'without normals, faces of one smoothing group are shaded smoothly; with `off` or no group they are flat',
      obj(`s 1\n${FACE}v 0 0 1\nf 1 5 2\n`),
      (s) => expect(s.objects[0].mesh.positions.length).toBe(3 * 5),
    ),
    read(
      '`v x y z r g b`',
      'vertex colours, as sRGB; if any value is above 1, all are taken as 0 … 255',
      obj(FACE.replaceAll(/^v .*$/gm, '$& 1 0 0')),
      (s) => expect([...s.objects[0].mesh.colors!.subarray(0, 3)]).toEqual([1, 0, 0]),
    ),
    read('`o`, `g`', 'one object each: `/Car`, `/Car_wheel`', obj(`o Car\n${FACE}g wheel\nf 1 2 3\n`), (s) =>
      expect(pathsOf(s)).toEqual(['/Car', '/Car_wheel']),
    ),
    leftOut(
      'points, lines, curves, surfaces',
      'reported with the first line',
      'obj.ignored',
      ['p 1', 'l 1 2', 'curv 0 1 1 2', 'surf 0 1 0 1 1 2 3 4'].map((line) => obj(`${FACE}${line}\n`)),
      triangles(2),
    ),
    leftOut(
      'unknown statements',
      'reported with the first line',
      'obj.unknown',
      obj(`${FACE}wobble 3\n`),
      triangles(2),
    ),
    leftOut('a file without faces', 'reported: there is nothing to see', 'file.no-triangles', obj('v 0 0 0\n')),
    refused('a word in place of a number', 'with line and word', 'obj.number', obj('v 0 x 0\n')),
    approximated(
      'texture coordinates or normals that a face names and the file does not have',
      'those corners are shown as without, and reported',
      'obj.missing-attribute',
      obj('v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/2/1 3/1/9\n'),
      (s) => expect([...s.objects[0].mesh.normals]).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1]),
    ),
    refused('the index of a point that is not there', 'with line and index', 'obj.index', obj('v 0 0 0\nf 1 2 3\n')),
    refused(
      'a face with fewer than 3 corners or more than the limit',
      'with its line',
      'obj.face',
      obj('v 0 0 0\nv 1 0 0\nf 1 2\n'),
    ),
    refused(
      'more groups, materials or files than the limit',
      'with the line and the limit',
      'obj.too-many',
      obj(`mtllib ${'a.mtl '.repeat(1001)}\n`),
    ),
    refused(
      'text that is not OBJ',
      'with the line',
      'obj.not-obj',
      obj(Array.from({ length: 200 }, (_, i) => `word${i} 1\n`).join('')),
    ),
  ],
};

const materials: ClaimGroup = {
  title: 'Materials (`.mtl`)',
  rows: [
    read(
      '`Kd`, `Ke`, `d`, `Tr`, `Ni` above 1, `Pm`',
      'base colour and emission (taken as linear), opacity, refractive index, metalness',
      withMaterial('Kd 1 0 0\nKe 0 2 0\nd 0.5\nNi 1.25'),
      looks({ baseColor: [1, 0, 0], emissive: [0, 2, 0], opacity: 0.5, ior: 1.25 }),
    ),
    read(
      '`Pr`, else `Ns`',
      'roughness; from `Ns`, roughness⁴ = 2 / (Ns + 2); matte if `Ks` is 0',
      withMaterial('Ns 30'),
      looks({ roughness: 0.5 }),
    ),
    read(
      '`map_Kd`, `map_Ke`, `map_d`, with `-s`, `-o`, `-clamp`',
      'pictures; if one is not at the given path, a file of the same name beside the `.mtl` is used',
      withMaterial('map_Kd -s 2 2 1 -clamp on C:\\old\\a.png', { 'a.png': PIXEL }),
      (s) => {
        expect(s.materials[0].baseColorTexture).toMatchObject({ width: 1, wrapS: 'clamp' });
        expect(Math.max(...s.objects[0].mesh.uvs)).toBe(2);
      },
    ),
    read(
      '`norm`, `map_Pr`, `map_Pm`',
      'normals, roughness and metalness per pixel; the last two from the red channel times `Pr`, `Pm`',
      withMaterial('Pr 0.5\nmap_Pr a.png\nmap_Pm a.png\nnorm a.png', { 'a.png': PIXEL }),
      looks({
        roughnessTexture: expect.objectContaining({ channel: 0, scale: 0.5 }),
        metallicTexture: expect.objectContaining({ scale: 1 }),
        normalTexture: expect.objectContaining({ strength: [1, 1] }),
      }),
    ),
    leftOut(
      'other maps and keywords (`map_Bump`, `map_Ns`, `Tf` …)',
      'reported',
      'obj.ignored',
      withMaterial('Kd 1 0 0\nmap_Bump a.png'),
      looks({ baseColor: [1, 0, 0] }),
    ),
    leftOut('colours as `spectral` or `xyz`', 'reported', 'obj.color', withMaterial('Kd xyz 1 1 1')),
    leftOut(
      'a picture that is damaged, too large, or neither PNG nor JPEG',
      'reported with what it is',
      'file.unreadable-texture',
      withMaterial('map_Kd a.png', { 'a.png': WEBP }),
    ),
    leftOut(
      'a missing picture',
      'reported with the places that were searched',
      'file.missing-texture',
      withMaterial('map_Kd a.png'),
    ),
    leftOut(
      'a missing `.mtl`',
      'reported with the places that were searched',
      'file.missing-materials',
      obj(`mtllib b.mtl\n${FACE}`),
    ),
    approximated(
      'a material that no file defines',
      'light grey',
      'obj.missing-material',
      obj(`usemtl b\n${FACE}`),
      looks({ baseColor: [0.5, 0.5, 0.5] }),
    ),
  ],
};

export const objGroups: readonly ClaimGroup[] = [shapes, materials];
