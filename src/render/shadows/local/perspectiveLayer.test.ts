import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { addScaled, cross, dot, length, normalize, scale, sub, type Vec3 } from '../../../math/vec3.ts';
import { lightAxes } from '../distant/parallelLayer.ts';
import {
  cubeFaceAxes,
  faceFocal,
  lightFrameAxes,
  type PerspectiveLayer,
  perspectiveLayerTexels,
  sphereLayer,
} from './perspectiveLayer.ts';

const number = fc.double({ min: -1, max: 1, noNaN: true });
const vector = fc.tuple(number, number, number);
const direction = vector.filter((v) => length(v) > 0.05).map((v) => normalize(v));

/** Column, row and height of a point, from the numbers that shaders read. */
function placeOf(texels: readonly number[], x: Vec3): Vec3 {
  const [across, up, towards, source] = [0, 1, 2, 3].map(
    (k): Vec3 => [texels[4 * k], texels[4 * k + 1], texels[4 * k + 2]],
  );
  const d = sub(x, source);
  const z = dot(towards, d);
  return [texels[3] + (texels[11] * dot(across, d)) / z, texels[7] + (texels[11] * dot(up, d)) / z, 1 / z];
}

describe('a layer of a local light', () => {
  it('maps all of a ray to one texel, higher if nearer', () => {
    fc.assert(
      fc.property(direction, vector, direction, (s, source, ray) => {
        fc.pre(dot(s, ray) > 0.2);
        const layer: PerspectiveLayer = { axes: lightAxes(s), source, focal: 100, near: 0.1 };
        const texels = perspectiveLayerTexels(layer, 128, 384);
        const [near, far] = [1, 4].map((r) => placeOf(texels, addScaled(source, ray, r)));
        expect(far[0]).toBeCloseTo(near[0], 6);
        expect(far[1]).toBeCloseTo(near[1], 6);
        expect(near[2]).toBeGreaterThan(far[2]);
      }),
    );
  });

  it('has one of six faces for each direction, and a light looks along −Z into the first', () => {
    const axes = lightFrameAxes([1, 0, 0], [0, 1, 0]);
    expect(axes.toLight).toEqual([0, 0, -1]);
    fc.assert(
      fc.property(direction, (ray) => {
        const faces = cubeFaceAxes(axes).filter(({ right: across, up, toLight }) => {
          const z = dot(toLight, ray);
          return z > Math.abs(dot(across, ray)) && z > Math.abs(dot(up, ray));
        });
        expect(faces.length).toBe(1);
      }),
    );
  });

  it('holds all of a sphere within its margin, and none of one that contains the light', () => {
    const tile = { side: 256, cell: 16 };
    expect(sphereLayer([0, 0.9, 0], 1, tile)).toBeUndefined();
    fc.assert(
      fc.property(direction, fc.double({ min: 1.2, max: 50, noNaN: true }), direction, (to, distance, aside) => {
        const source = scale(to, -distance);
        const layer = sphereLayer(source, 1, tile)!;
        const across = cross(to, aside);
        fc.pre(length(across) > 0.1);
        // Where a ray from the light touches the sphere.
        const touch = addScaled(scale(to, -1 / distance), normalize(across), Math.sqrt(1 - 1 / distance ** 2));
        const [x, y, height] = placeOf(perspectiveLayerTexels(layer, 0, 0), touch);
        expect(Math.hypot(x, y)).toBeCloseTo(faceFocal(tile.side, tile.cell), 6);
        expect(height * layer.near).toBeLessThan(1);
      }),
    );
  });
});
