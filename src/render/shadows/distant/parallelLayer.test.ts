import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { addScaled, dot, length, normalize, type Vec3 } from '../../../math/vec3.ts';
import { comovingPathToLight, lightAxes, parallelLayerTexels } from './parallelLayer.ts';

const number = fc.double({ min: -0.55, max: 0.55, noNaN: true });
const vector = fc.tuple(number, number, number);
const direction = vector.filter((v) => length(v) > 0.05).map((v) => normalize(v));

/** Column, row and height of an event, from the rows that shaders read. */
function placeOf(texels: readonly number[], dx: Vec3, time: number): Vec3 {
  const [u, v, h] = [0, 1, 2].map(
    (k) => dot([texels[4 * k], texels[4 * k + 1], texels[4 * k + 2]], dx) + texels[4 * k + 3] + texels[12 + k] * time,
  );
  return [u, v, h];
}

describe('a layer in coordinates that move with its caster', () => {
  it('maps all events of a ray to the light to one texel, higher if nearer to the light', () => {
    fc.assert(
      fc.property(direction, vector, vector, number, number, (s, beta, start, time, center) => {
        const axes = lightAxes(comovingPathToLight(s, beta, -1));
        const tile = { x: 512, y: 0, size: 512 };
        const texels = parallelLayerTexels({
          axes,
          beta,
          center: [center, 0, 0],
          halfSide: 2,
          halfDepth: 2,
          penumbraSlope: 0,
          tile,
        });
        const [here, there] = [0, 3].map((distance) => placeOf(texels, addScaled(start, s, distance), time - distance));
        expect(there[0]).toBeCloseTo(here[0], 6);
        expect(there[1]).toBeCloseTo(here[1], 6);
        expect(there[2]).toBeGreaterThan(here[2]);
      }),
    );
  });

  it('maps what moves with the caster to one place at all times, and its centre to the centre of the tile', () => {
    fc.assert(
      fc.property(direction, vector, vector, number, (s, beta, center, time) => {
        const axes = lightAxes(comovingPathToLight(s, beta, -1));
        const tile = { x: 512, y: 1024, size: 512 };
        const texels = parallelLayerTexels({
          axes,
          beta,
          center,
          halfSide: 2,
          halfDepth: 2,
          penumbraSlope: 0,
          tile,
        });
        const [u, v, h] = placeOf(texels, addScaled(center, beta, 10 * time), 10 * time);
        expect(u).toBeCloseTo(768, 6);
        expect(v).toBeCloseTo(1280, 6);
        expect(h / texels[19]).toBeCloseTo(0.5, 6);
      }),
    );
  });
});
