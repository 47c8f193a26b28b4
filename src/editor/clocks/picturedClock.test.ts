import { describe, expect, it } from 'vitest';
import { IDENTITY } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { type Clock, objectClocks } from '../../scene/clocks/clock.ts';
import { IDENTITY_POSE, makeObject } from '../../scene/defaults.ts';
import { sphere } from '../../scene/mesh/primitives.ts';
import type { Lifetime } from '../../scene/motion/motionTypes.ts';
import { perspective } from '../../scene/view/lenses/perspectiveLens.ts';
import { orbitCamera } from '../../scene/view/outsideCamera.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../scene/view/view.ts';
import { picturedClock } from './picturedClock.ts';

const settings: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: 10 };
/** From −1 to 1 upwards and from −2 to 2 across, in tangents. */
const size = { width: 400, height: 200 };
const view = (t: number, u: Vec3 = [0, 0, 0]): ViewPoint => ({
  t,
  position: [0, 0, 0],
  u,
  orientation: IDENTITY,
  lens: perspective(Math.PI / 2),
});

/** Crosses the axis of the camera at 0.5 c at time 0, `ahead` metres before it. */
function crossing(ahead = 12, lifetime?: Lifetime): Clock {
  const motion = {
    kind: 'uniform',
    pose: { ...IDENTITY_POSE, position: [0, 0, -ahead] },
    velocity: [5, 0, 0],
  } as const;
  const object = makeObject({ path: '/Ball', mesh: sphere(1), motion });
  return objectClocks([lifetime ? { ...object, lifetime } : object], settings.speedOfLight)[0]!;
}

describe('a clock in the picture, of a ball that crosses at 0.5 c', () => {
  it('is where its light comes from', () => {
    // At 1 s it is at (5, −12), 13 m away, and its light needs 1.3 s.
    const { place, time, distance } = picturedClock(crossing(), view(2.3), settings, size)!;
    expect(time).toBeCloseTo(1, 12);
    expect(distance).toBeCloseTo(13, 12);
    expect(place[0]).toBeCloseTo((1 + 5 / 12 / 2) / 2, 12);
    expect(place[1]).toBeCloseTo(0.5, 12);
  });

  it('is nearer to the middle for one who flies at 0.6 c: half the tangent of half the angle', () => {
    // tan(θ/2) = (1 − 12/13)/(5/13) = 1/5; tan θ′ = 2 · 0.1/(1 − 0.01).
    const { place, time, distance } = picturedClock(
      crossing(),
      view(2.3, properVelocity([0, 0, -0.6])),
      settings,
      size,
    )!;
    expect(time).toBeCloseTo(1, 12);
    // γ(13 + 0.6 · 12): what D = γ(1 + 0.6 · 12/13) makes bluer it puts farther away.
    expect(distance).toBeCloseTo(1.25 * 20.2, 12);
    expect(place[0]).toBeCloseTo((1 + 20 / 99 / 2) / 2, 12);
  });

  it('from outside is where the ball is in the world, now or when its light left', () => {
    // A camera 20 m above the observer looks down; −Z is up in its picture, 90° high.
    const outside = orbitCamera({ distance: 20, azimuth: 0, elevation: Math.PI / 2, fovY: Math.PI / 2 }, [0, 1, 0]);
    const fast = view(2.3, properVelocity([0, 0, -0.6]));
    const from = { ...settings, outside, aberration: false };
    const now = picturedClock(crossing(), fast, { ...from, view: 'galilean' }, size)!;
    expect(now.place[0]).toBeCloseTo((1 + 11.5 / 20 / 2) / 2, 9);
    expect(now.place[1]).toBeCloseTo((1 - 12 / 20) / 2, 9);
    const seen = picturedClock(crossing(), fast, from, size)!;
    expect(seen.time).toBeCloseTo(1, 12);
    expect(seen.place[0]).toBeCloseTo((1 + 5 / 20 / 2) / 2, 9);
    expect(seen.place[1]).toBeCloseTo((1 - 12 / 20) / 2, 9);
  });

  it('is where the ball is at that moment, where the picture shows that', () => {
    const { place, time } = picturedClock(crossing(), view(2.3), { ...settings, view: 'simultaneity' }, size)!;
    expect(time).toBeCloseTo(2.3, 12);
    expect(place[0]).toBeCloseTo((1 + 11.5 / 12 / 2) / 2, 12);
  });

  it('is not behind the camera, beside the frame, before birth or after death', () => {
    expect(picturedClock(crossing(-12), view(2.3), settings, size)).toBeUndefined();
    expect(picturedClock(crossing(), view(60), settings, size)).toBeUndefined();
    const life = (birth: number, death: number) => crossing(12, { birth, death });
    expect(picturedClock(life(1.1, 9), view(2.3), settings, size)).toBeUndefined();
    expect(picturedClock(life(0, 0.9), view(2.3), settings, size)).toBeUndefined();
    expect(picturedClock(life(0.9, 1.1), view(2.3), settings, size)).toBeDefined();
  });
});
