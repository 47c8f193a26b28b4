import { describe, expect, it } from 'vitest';
import { cross, dot, sub, type Vec3 } from '../../math/vec3.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../defaults.ts';
import { checkerTexture } from '../materials/checker.ts';
import { sampleTexture } from '../materials/sampleTexture.ts';
import { box, grid, sphere } from '../mesh/primitives.ts';
import type { Mesh } from '../types.ts';
import { assignTexture, hasUvs } from './assignTexture.ts';

const RED = [0.7, 0.05, 0.02] as const;
const WHITE = [0.9, 0.9, 0.9] as const;
const checker = checkerTexture([RED, WHITE], 'nearest');
const objects = [
  makeObject({ path: '/Floor', mesh: grid(4, 4, 1, 1, 'Y'), motion: restingAt([0, 0, 0]) }),
  makeObject({ path: '/Box/Lid', mesh: box([2, 4, 6]) }),
  makeObject({ path: '/Box/Ball', mesh: sphere(1) }),
];
const scene = makeScene({
  name: 'a',
  objects,
  materials: [makeMaterial({ name: 'rough', roughness: 0.9, metallic: 1 })],
});
const meshAt = (of: typeof scene, path: string): Mesh => of.objects.find((object) => object.path === path)!.mesh;

describe('a checkerboard', () => {
  it('has two by two cells, the first colour at u = v = 0', () => {
    const at = (u: number, v: number) => sampleTexture(checker, u, v).slice(0, 3);
    for (const [u, v, color] of [
      [0.1, 0.1, RED],
      [0.6, 0.1, WHITE],
      [0.1, 0.6, WHITE],
      [0.6, 0.6, RED],
      [3.1, -0.9, RED],
    ] as const)
      for (const [k, x] of at(u, v).entries()) expect(x).toBeCloseTo(color[k]!, 2);
  });

  it('blends over an eighth of a cell if it is linear, and not at all if it is nearest', () => {
    const red = (u: number, filter: 'linear' | 'nearest') =>
      sampleTexture(checkerTexture([RED, WHITE], filter), u, 0.25)[0];
    const edge = 0.5 - 1e-9;
    expect(red(edge, 'nearest')).toBeCloseTo(RED[0], 2);
    expect(red(edge, 'linear')).toBeCloseTo((RED[0] + WHITE[0]) / 2, 2);
    expect(red(0.5 - 1 / 32, 'linear')).toBeCloseTo(RED[0], 2);
  });
});

describe('a texture on objects', () => {
  const made = assignTexture(scene, '/Box', { texture: checker, tint: [1, 1, 1], repeat: [3, 2] });

  it('replaces the colour and nothing else, below the path only, and shares materials', () => {
    expect(meshAt(made, '/Floor')).toBe(meshAt(scene, '/Floor'));
    const used = ['/Box/Lid', '/Box/Ball'].map((path) => meshAt(made, path).groups[0]!.material);
    expect(used).toEqual([1, 1]);
    expect(made.materials[1]).toMatchObject({
      ...{ roughness: 0.9, metallic: 1, baseColor: [1, 1, 1] },
      baseColorTexture: checker,
    });
    expect(scene.materials).toHaveLength(1);
  });

  it('repeats by the coordinates of the surface', () => {
    const { uvs } = meshAt(made, '/Box/Lid');
    expect([Math.max(...uvs.filter((_, i) => i % 2 === 0)), Math.max(...uvs.filter((_, i) => i % 2 === 1))]).toEqual([
      3, 2,
    ]);
  });

  it('is projected without distortion, nowhere mirrored, on every side', () => {
    const side = 0.5;
    const whole = assignTexture(scene, '', { texture: checker, tint: WHITE, repeat: [1, 1], projected: side });
    for (const path of ['/Box/Lid', '/Floor', '/Box/Ball']) {
      const { positions, uvs, indices, normals } = meshAt(whole, path);
      for (let i = 0; i < indices.length; i += 3) {
        const [a, b, c] = [0, 1, 2].map(
          (k) => [...positions.subarray(3 * indices[i + k]!, 3 * indices[i + k]! + 3)] as unknown as Vec3,
        );
        const [p, q, r] = [0, 1, 2].map((k) => [uvs[2 * indices[i + k]!]!, uvs[2 * indices[i + k]! + 1]!] as const);
        const normal = cross(sub(b!, a!), sub(c!, a!));
        const area = (q![0] - p![0]) * (r![1] - p![1]) - (q![1] - p![1]) * (r![0] - p![0]);
        // The largest component of twice the area, over the side squared, and positive seen from outside.
        expect(area * side ** 2).toBeCloseTo(Math.max(...normal.map(Math.abs)), 4);
        expect(
          dot(normal, [...normals.subarray(3 * indices[i]!, 3 * indices[i]! + 3)] as unknown as Vec3),
        ).toBeGreaterThan(-1e-6);
      }
    }
  });

  it('is missed where there are no coordinates', () => {
    expect(hasUvs(meshAt(scene, '/Box/Lid'))).toBe(true);
    expect(hasUvs({ ...meshAt(scene, '/Box/Lid'), uvs: new Float32Array(48).fill(0.5) })).toBe(false);
  });
});
