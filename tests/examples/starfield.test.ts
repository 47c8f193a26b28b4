import { describe, expect, it } from 'vitest';
import { dot, length, normalize, type Vec3 } from '../../src/math/vec3.ts';
import { velocity } from '../../src/physics/lorentz/boost.ts';
import { sceneNightSky } from '../../src/scene/lights/sceneLights.ts';
import { projectStars } from '../../src/scene/stars/projectStars.ts';
import { observerFromCamera } from '../../src/scene/view/camera.ts';
import { perspectiveOf } from '../../src/scene/view/lenses/lenses.ts';
import { perspective } from '../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type ViewPoint } from '../../src/scene/view/view.ts';
import { openExample, speedOfLight, topOfFlight } from './open.ts';

const scene = await openExample('starfield');
const sky = sceneNightSky(scene)!;
const [camera] = scene.cameras;
const c = speedOfLight(scene);

/** A field of view of 172° contains nearly the whole forward hemisphere. */
const [WIDTH, HEIGHT] = [1000, 1000];

interface Seen {
  /** Unit vector on the camera's axes. */
  readonly n: Vec3;
  readonly light: Vec3;
}

/** The stars in front of the camera at a time of the flight, at its own velocity or another. */
function seen(t: number, u: Vec3 = observerFromCamera(camera, t, c).u): Seen[] {
  const view: ViewPoint = { t, ...observerFromCamera(camera, t, c), u, lens: perspective(3) };
  const room = 3 * sky.stars.temperatures.length;
  const [places, lights] = [new Float32Array(room), new Float32Array(room)];
  const count = projectStars(sky, view, DEFAULT_SETTINGS, WIDTH, HEIGHT, { positions: places, radiances: lights });
  const tan = Math.tan(perspectiveOf(view.lens).fovY / 2);
  return Array.from({ length: count }, (_, i) => ({
    n: normalize([places[3 * i] * tan, places[3 * i + 1] * tan, -1]),
    light: [lights[3 * i], lights[3 * i + 1], lights[3 * i + 2]],
  }));
}

const fastest = topOfFlight(scene);
const beta = length(velocity(fastest.u));
const angle = (a: Seen, b: Seen): number => Math.acos(Math.min(dot(a.n, b.n), 1));

/** The `count` brightest stars within an angle [rad] of the middle. */
function brightest(stars: readonly Seen[], count: number, within: number): Seen[] {
  return stars.filter(({ n }) => -n[2] > Math.cos(within)).slice(0, count);
}

describe('starfield', () => {
  it('moves at 0.9 c', () => {
    expect(beta).toBeGreaterThan(0.88);
    expect(beta).toBeLessThan(0.96);
  });

  // Stars abeam for an observer at rest are seen at cos θ′ = β.
  it('has half of the sky within arccos β of straight ahead, and 26° at 0.9 c', () => {
    const ahead = seen(fastest.t, [0, 0, 0]).length;
    const within = seen(fastest.t).filter(({ n }) => -n[2] >= beta).length;
    expect(Math.abs(within / ahead - 1)).toBeLessThan(0.06);
    expect((Math.acos(0.9) * 180) / Math.PI).toBeCloseTo(26, 0);
  });

  // Near straight ahead angles shrink by D = γ(1 + β) = √((1 + β)/(1 − β)).
  it('has Orion’s belt straight ahead, and shrinks it to less than a quarter', () => {
    const [still, moving] = [seen(0, [0, 0, 0]), seen(fastest.t)];
    const belt = (stars: Seen[], within: number) => brightest(stars, 3, within);
    const [a, , b] = belt(still, 0.05);
    const [a1, , b1] = belt(moving, 0.05 / Math.sqrt((1 + beta) / (1 - beta)));
    expect(angle(a, b) * (180 / Math.PI)).toBeGreaterThan(1);
    expect(angle(a, b) * (180 / Math.PI)).toBeLessThan(3);
    expect(angle(a, b) / angle(a1, b1)).toBeCloseTo(Math.sqrt((1 + beta) / (1 - beta)), 1);
    expect(angle(a1, b1)).toBeLessThan(angle(a, b) / 4);
  });

  it('shows reddish Betelgeuse blue', () => {
    // Of Orion's seven brightest stars it is the only one that is red at rest.
    const still = brightest(seen(0, [0, 0, 0]), 7, 0.2);
    const red = still.findIndex(({ light }) => light[0] > 1.5 * light[2]);
    const moving = brightest(seen(fastest.t), 7, 0.2 / Math.sqrt((1 + beta) / (1 - beta)));
    expect(red).toBeGreaterThanOrEqual(0);
    expect(moving.every(({ light }) => light[2] > light[0])).toBe(true);
  });
});
