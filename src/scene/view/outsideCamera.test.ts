import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { IDENTITY, rotate } from '../../math/quat.ts';
import { add, distance, dot, length, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { drawnFrom, toObserver } from './drawnFrom.ts';
import { perspective } from './lenses/perspectiveLens.ts';
import { orbitCamera } from './outsideCamera.ts';
import { bufferSettings, DEFAULT_SETTINGS, extraBuffers, type ViewPoint } from './view.ts';

const real = (min: number, max: number) => fc.double({ min, max, noNaN: true });
const orbits = fc.record({
  distance: real(0.1, 1e4),
  azimuth: real(-4, 4),
  elevation: real(-Math.PI / 2, Math.PI / 2),
  fovY: real(0.1, 2),
});
const VIEW: ViewPoint = {
  t: 2,
  position: [4, -1, 7],
  u: [0.3, 0, -2],
  orientation: IDENTITY,
  lens: perspective(1),
  vantage: [9, 9, 9],
};

describe('an orbit', () => {
  it.each([
    ['Y', [0, 1, 0]],
    ['Z', [0, 0, 1]],
  ] as const)('is as far from its centre as asked, at that elevation, and looks at it (%s up)', (_, up) => {
    fc.assert(
      fc.property(orbits, fc.tuple(real(-50, 50), real(-50, 50), real(-50, 50)), (orbit, centre) => {
        const { place, orientation, follows } = orbitCamera(orbit, up, centre as Vec3);
        const away = sub(place, centre as Vec3);
        expect(follows).toBe(false);
        expect(length(away) / orbit.distance).toBeCloseTo(1, 9);
        expect(Math.asin(Math.max(-1, Math.min(1, dot(away, up) / orbit.distance)))).toBeCloseTo(orbit.elevation, 6);
        expect(distance(rotate(orientation, [0, 0, -1]), scale(away, -1 / orbit.distance))).toBeLessThan(1e-6);
        // It is upright: its right is level.
        expect(dot(rotate(orientation, [1, 0, 0]), up)).toBeCloseTo(0, 6);
      }),
    );
  });

  it('begins behind one who looks ahead, turns to the right, and looks ahead at the top from straight above', () => {
    const at = (azimuth: number, elevation: number, up: Vec3) =>
      orbitCamera({ distance: 2, azimuth, elevation, fovY: 1 }, up);
    expect(distance(at(0, 0, [0, 1, 0]).place, [0, 0, 2])).toBeLessThan(1e-12);
    expect(distance(at(Math.PI / 2, 0, [0, 1, 0]).place, [2, 0, 0])).toBeLessThan(1e-12);
    expect(distance(at(0, 0, [0, 0, 1]).place, [0, -2, 0])).toBeLessThan(1e-12);
    const above = at(0, Math.PI / 2, [0, 1, 0]).orientation;
    expect(distance(rotate(above, [0, 1, 0]), [0, 0, -1])).toBeLessThan(1e-9);
  });
});

describe('a picture from outside', () => {
  const outside = orbitCamera({ distance: 30, azimuth: 0.4, elevation: 0.5, fovY: 0.8 }, [0, 1, 0]);
  const fixed = orbitCamera({ distance: 30, azimuth: 0.4, elevation: 0.5, fovY: 0.8 }, [0, 1, 0], [1, 2, 3]);

  it('of the world’s moment is that of a camera there; of what is seen, the observer’s from a vantage', () => {
    for (const camera of [outside, fixed]) {
      const where = camera.follows ? add(VIEW.position, camera.place) : camera.place;
      const now = drawnFrom(VIEW, { outside: camera, view: 'galilean' });
      expect(distance(now.position, where)).toBeLessThan(1e-12);
      expect(now).not.toHaveProperty('vantage');
      const seen = drawnFrom(VIEW, { outside: camera, view: 'light-cone' });
      expect(seen).toMatchObject({ t: 2, position: VIEW.position, u: VIEW.u, lens: { fovY: 0.8 } });
      expect(distance(add(seen.position, seen.vantage!), where)).toBeLessThan(1e-12);
      expect(distance(add(where, toObserver(VIEW, { outside: camera })), VIEW.position)).toBeLessThan(1e-12);
    }
  });

  it('without an outside camera is the observer’s own', () => {
    expect(drawnFrom(VIEW, { view: 'galilean' })).toBe(VIEW);
    expect(toObserver(VIEW, {})).toEqual([0, 0, 0]);
  });

  it('is that of one G-buffer: others are seen as they say themselves, and a ghost is where things were in the world', () => {
    const { scene: _, ...buffer } = { ...DEFAULT_SETTINGS, scene: 0 };
    const other = { ...buffer, scene: 0 };
    const settings = { ...DEFAULT_SETTINGS, outside, frameGraph: { extraBuffers: [other], passes: [] } };
    expect(bufferSettings(settings, 0).outside).toBe(outside);
    expect(bufferSettings(settings, 1).outside).toBeUndefined();
    expect(extraBuffers({ ...DEFAULT_SETTINGS, outside, ghost: 'light-cone' })).toMatchObject([
      { view: 'light-cone', aberration: false, outside },
    ]);
    expect(extraBuffers({ ...DEFAULT_SETTINGS, ghost: 'light-cone' })).toMatchObject([{ aberration: true }]);
  });
});
