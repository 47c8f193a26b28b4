import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { distance, length } from '../../math/vec3.ts';
import { makeObject, makeScene, restingAt } from '../../scene/defaults.ts';
import { box } from '../../scene/mesh/primitives.ts';
import { DEFAULT_SETTINGS, extraBuffers } from '../../scene/view/view.ts';
import { ELEVATIONS, firstLook, outsideSettings, ringSeconds, turned } from './outsidePicture.ts';

const SCENE = makeScene({
  name: 'box',
  objects: [makeObject({ path: '/Box', mesh: box([3, 4, 12]), motion: restingAt([5, 5, 5]) })],
});
const UP = [0, 1, 0] as const;

describe('the outside view', () => {
  it('begins half the diagonal away, or as far as light comes in three seconds', () => {
    expect(firstLook(SCENE, 100).distance).toBeCloseTo(13 / 2, 9);
    expect(firstLook(SCENE, 1).distance).toBeCloseTo(3, 9);
    expect(firstLook(makeScene({ name: 'empty' }), 1).distance).toBeGreaterThan(0);
  });

  it('has rings at 1, 2 or 5 times a power of ten, about four up to the camera', () => {
    expect([42, 8, 0.4, 3e8].map((away) => ringSeconds(away, 10))).toEqual([1, 0.2, 0.01, 1e7]);
    fc.assert(
      fc.property(
        fc.double({ min: 1e-3, max: 1e12, noNaN: true }),
        fc.double({ min: 0.1, max: 3e8, noNaN: true }),
        (away, c) => {
          const rings = away / (c * ringSeconds(away, c));
          expect(rings).toBeGreaterThan(4 / Math.sqrt(2.5) - 1e-9);
          expect(rings).toBeLessThan(4 * Math.sqrt(2.5) + 1e-9);
        },
      ),
    );
  });

  it('keeps its distance from the observer, and what it shows has no Doppler shift', () => {
    const look = { ...firstLook(SCENE, 10), distance: 7 };
    const settings = outsideSettings({ ...DEFAULT_SETTINGS, speedOfLight: 10, pastFuture: true }, look, UP, 1.5);
    expect(length(settings.outside!.place)).toBeCloseTo(7, 9);
    expect(settings).toMatchObject({ view: 'galilean', dopplerMix: 0, beaming: 0, pastFuture: false });
    expect(settings.frameGraph?.passes[1]).toMatchObject({ kind: 'tone', exposure: 1.5 });
    // Its contours are of what is seen, and are placed in the world.
    expect(extraBuffers(settings).at(-1)).toMatchObject({
      view: 'light-cone',
      aberration: false,
      outside: settings.outside,
    });
    const seen = outsideSettings({ ...DEFAULT_SETTINGS, speedOfLight: 10 }, { ...look, shows: 'seen' }, UP, 0);
    expect(seen).toMatchObject({ view: 'light-cone', aberration: false, ghost: 'galilean' });
    expect(outsideSettings(DEFAULT_SETTINGS, { ...look, contours: false }, UP, 0).ghost).toBe('none');
  });

  it('is turned about the observer, and not over the top', () => {
    const look = firstLook(SCENE, 10);
    const place = (of: typeof look) => outsideSettings(DEFAULT_SETTINGS, of, UP, 0).outside!.place;
    expect(distance(place(turned(look, 2 * Math.PI, 0)), place(look))).toBeLessThan(1e-9);
    expect(turned(look, 0, 9).elevation).toBe(ELEVATIONS[1]);
    expect(turned(look, 0, -9).elevation).toBe(ELEVATIONS[0]);
    expect(length(place(turned(look, 0, 0, 2)))).toBeCloseTo(length(place(look)) / 2, 9);
  });
});
