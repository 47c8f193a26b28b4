import { expect } from 'vitest';
import type { Scene } from '../../src/scene/types.ts';
import { type ClaimGroup, type Files, leftOut, read, refused } from './claim.ts';

const facet = (normal = '0 0 1', corners = ['0 0 0', '1 0 0', '0 1 0']): string =>
  `facet normal ${normal}\nouter loop\n${corners.map((p) => `vertex ${p}\n`).join('')}endloop\nendfacet\n`;
const stl = (body: string, end = 'endsolid\n'): Files => ({ 'a.stl': `solid Part\n${body}${end}` });

/** One facet, followed by `rest`. */
function binary(header = '', rest = 0, x = 1): Files {
  const bytes = new Uint8Array(84 + 50 + rest);
  bytes.set(new TextEncoder().encode(header));
  const view = new DataView(bytes.buffer);
  view.setUint32(80, 1, true);
  [0, 0, 1, 0, 0, 0, x, 0, 0, 0, 1, 0].forEach((number, i) => {
    view.setFloat32(84 + 4 * i, number, true);
  });
  return { 'a.stl': bytes };
}
const one = (scene: Scene): void => expect(scene.objects.map(({ mesh }) => mesh.indices.length)).toEqual([3]);

const contents: ClaimGroup = {
  title: 'Contents',
  rows: [
    read('text', 'flat triangles; each `solid` is an object', stl(facet()), (s) =>
      expect(s.objects.map(({ path }) => path)).toEqual(['/Part']),
    ),
    read('binary, distinguished from text by content', 'flat triangles', binary('solid as a rock'), one),
    read('normals', 'computed from the winding order', stl(facet('0 0 0')), (s) =>
      expect([...s.objects[0].mesh.normals.subarray(0, 3)]).toEqual([0, 0, 1]),
    ),
    leftOut(
      'normals that contradict the winding order',
      'reported with their number',
      'stl.normals',
      stl(facet('0 0 -1')),
      one,
    ),
    leftOut('colours', 'reported', 'stl.colors', binary('COLOR=rgba'), one),
    read('attribute bytes of facets', 'ignored: the format gives them no meaning', binary(), one),
    leftOut('bytes after the last facet', 'reported with their number', 'stl.rest', binary('', 3), one),
    refused('a word in the wrong place', 'with line and word', 'stl.syntax', stl('vertex 0 0 0\n')),
    refused('a corner that is not a number', 'with line or byte, and value', 'stl.number', binary('', 0, Number.NaN)),
    refused(
      'a facet that does not have 3 corners',
      'with its line',
      'stl.corners',
      stl(facet('0 0 1', ['0 0 0', '1 0 0'])),
    ),
    refused('a truncated file', 'with the actual and the expected amount', 'stl.truncated', {
      'a.stl': (binary()['a.stl'] as Uint8Array).slice(0, 100),
    }),
    refused('more solids than the limit', 'with the limit', 'stl.too-many', {
      'a.stl': 'solid\nendsolid\n'.repeat(2 ** 16 + 1),
    }),
  ],
};

export const stlGroups: readonly ClaimGroup[] = [contents];
