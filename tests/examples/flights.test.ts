import { describe, expect, it } from 'vitest';
import { rotate } from '../../src/math/quat.ts';
import { cross, distance, dot, length, normalize, scale, sub, type Vec3, ZERO } from '../../src/math/vec3.ts';
import { velocity } from '../../src/physics/lorentz/boost.ts';
import { aberrate } from '../../src/physics/optics/aberration.ts';
import { observerDoppler } from '../../src/physics/optics/doppler.ts';
import { sceneNightSky } from '../../src/scene/lights/sceneLights.ts';
import { fastestVertex } from '../../src/scene/motion/motion.ts';
import type { ProbeObserver } from '../../src/scene/views/viewRecord.ts';
import {
  curvature,
  mean,
  objectAt,
  openExample,
  ridden,
  seenAt,
  speedOfLight,
  topOfFlight,
  worldPositions,
} from './open.ts';

const [street, hall, gallery, saturn] = await Promise.all(
  (['street', 'hall', 'gallery', 'saturn'] as const).map(openExample),
);

const atRest = (observer: ProbeObserver): ProbeObserver => ({ ...observer, u: ZERO });
const beta = ({ u }: ProbeObserver): number => length(velocity(u));
/** Whether p is behind the observer in the world, but is seen ahead. */
const comesIntoView = (p: Vec3, observer: ProbeObserver): boolean =>
  dot(sub(p, observer.position), observer.u) < 0 && dot(seenAt(p, observer), observer.u) > 0;
describe('street', () => {
  const me = topOfFlight(street);
  const c = speedOfLight(street);

  it('is traversed at 0.85 c or more', () => {
    expect(beta(me)).toBeGreaterThan(0.85);
  });

  it('shows house fronts already passed', () => {
    const fronts = street.objects
      .filter(({ path }) => path.includes('House'))
      .flatMap((o) => worldPositions(o, me.t, c));
    expect(fronts.filter((p) => comesIntoView(p, me)).length).toBeGreaterThan(100);
  });

  it('bends uprights, and leaves kerbs and eaves along the motion straight', () => {
    const [x, , z] = me.position;
    const upright = [0, 3, 6].map((y): Vec3 => [x + 5, y, z - 1]);
    const kerb = [5, -5, -15].map((dz): Vec3 => [x + 5, 0.15, z + dz]);
    const bend = (points: readonly Vec3[], observer: ProbeObserver) => {
      const [a, b, d] = points.map((p) => seenAt(p, observer));
      return curvature(a, b, d);
    };
    expect(bend(upright, atRest(me))).toBeLessThan(1e-9);
    expect(bend(upright, me)).toBeGreaterThan(0.01);
    const along: ProbeObserver = { ...me, u: [0, 0, -length(me.u)] };
    expect(bend(kerb, along)).toBeLessThan(1e-9);
  });

  it('is blue and bright ahead, red and dark behind', () => {
    expect(observerDoppler(sub([0, 2, me.position[2] - 40], me.position), me.u)).toBeGreaterThan(3);
    expect(observerDoppler(sub([0, 2, me.position[2] + 40], me.position), me.u)).toBeLessThan(0.4);
  });

  it('has moving cubes, and a rotating ball', () => {
    const speed = (name: string) => fastestVertex(objectAt(street, `/World/${name}`), c).speed / c;
    for (const name of ['CubeAhead', 'CubeOncoming', 'CubeAcross']) expect(speed(name), name).toBeGreaterThan(0.3);
    const globe = (t: number) => worldPositions(objectAt(street, '/World/Globe'), t, c);
    // The vertices of the uv seam count twice, so their mean is not exactly the centre.
    expect(distance(mean(globe(1)), mean(globe(3)))).toBeLessThan(0.2);
    expect(speed('Globe')).toBeGreaterThan(0.5);
  });
});

describe('hall', () => {
  const me: ProbeObserver = { ...topOfFlight(hall), u: [0, 0, -length(topOfFlight(hall).u)] };
  const c = speedOfLight(hall);
  const floor = objectAt(hall, '/World/Floor');

  it('has tiles of two metres', () => {
    const { positions, uvs } = floor.mesh;
    const extent = (values: ArrayLike<number>, size: number, k: number) => {
      const own = Array.from({ length: values.length / size }, (_, i) => values[size * i + k]);
      return Math.max(...own) - Math.min(...own);
    };
    // The texture has two by two fields.
    expect(extent(positions, 3, 0) / (2 * extent(uvs, 2, 0))).toBeCloseTo(2, 5);
    expect(extent(positions, 3, 2) / (2 * extent(uvs, 2, 1))).toBeCloseTo(2, 5);
  });

  it('has straight edges for an observer at rest, and curved ones perpendicular to the motion for a moving one', () => {
    const z = me.position[2] - 2;
    const corner = [0, 4, 8].map((y): Vec3 => [-7, y, z]);
    const bend = (observer: ProbeObserver) =>
      curvature(...(corner.map((p) => seenAt(p, observer)) as [Vec3, Vec3, Vec3]));
    expect(bend(atRest(me))).toBeLessThan(1e-9);
    expect(bend(me)).toBeGreaterThan(0.01);
  });

  it('has a far wall that recedes, and tiles behind that come into view', () => {
    const walls = worldPositions(objectAt(hall, '/World/Ends'), 0, c).filter((p) => p[2] < me.position[2] - 5);
    expect(walls.length).toBeGreaterThan(3);
    for (const p of walls) expect(length(seenAt(p, me)) / distance(p, me.position)).toBeGreaterThan(1.5);
    expect(comesIntoView([3, 0, me.position[2] + 1], me)).toBe(true);
  });
});

describe('gallery', () => {
  const me: ProbeObserver = { ...topOfFlight(gallery), u: [0, 0, -length(topOfFlight(gallery).u)] };
  const c = speedOfLight(gallery);
  const pictures = gallery.objects.filter(({ path }) => path.includes('Picture'));

  it('shows pictures already passed', () => {
    const fast = ridden(gallery).filter((observer) => beta(observer) > 0.7);
    const seen = fast.filter((observer) =>
      pictures.some((o) => worldPositions(o, observer.t, c).every((p) => comesIntoView(p, observer))),
    );
    expect(seen.length).toBeGreaterThan(0);
  });

  it('has rectangular frames that look skewed when passed', () => {
    const [x, y, z] = [-4.4, 2, me.position[2] - 1];
    const [foot, top, side] = (
      [
        [x, y, z],
        [x, y + 2, z],
        [x, y, z - 2],
      ] as Vec3[]
    ).map((p) => seenAt(p, me));
    const angle = Math.acos(dot(normalize(sub(top, foot)), normalize(sub(side, foot))));
    expect(Math.abs(angle - Math.PI / 2)).toBeGreaterThan(0.2);
    const resting = (
      [
        [x, y, z],
        [x, y + 2, z],
        [x, y, z - 2],
      ] as Vec3[]
    ).map((p) => seenAt(p, atRest(me)));
    expect(dot(sub(resting[1], resting[0]), sub(resting[2], resting[0]))).toBeCloseTo(0, 9);
  });

  it('has false colours of the Doppler shift: blue ahead, at most γ(1 + β)', () => {
    const factors = pictures
      .flatMap((o) => worldPositions(o, me.t, c))
      .map((p) => observerDoppler(sub(p, me.position), me.u));
    const most = Math.sqrt((1 + beta(me)) / (1 - beta(me)));
    expect(Math.max(...factors)).toBeGreaterThan(0.9 * most);
    expect(Math.max(...factors)).toBeLessThanOrEqual(most);
    expect(Math.min(...factors)).toBeLessThan(1);
  });
});

describe('saturn', () => {
  const me: ProbeObserver = { ...topOfFlight(saturn), position: [-15.5, 4.2, 0] };
  const c = speedOfLight(saturn);

  it('is passed at nearly 0.9 c', () => {
    expect(beta(me)).toBeCloseTo(0.87, 2);
  });

  it('has rings whose far side appears ahead of the near side abreast of it', () => {
    const abreast = worldPositions(objectAt(saturn, '/World/Rings'), 0, c).filter((p) => Math.abs(p[2]) < 0.7);
    const [near, far] = [abreast.filter((p) => p[0] < -9), abreast.filter((p) => p[0] > 9)];
    const ahead = (p: Vec3) => dot(seenAt(p, me), normalize(me.u));
    expect(Math.min(near.length, far.length)).toBeGreaterThan(0);
    expect(Math.min(...far.map(ahead)) - Math.max(...near.map(ahead))).toBeGreaterThan(10);
  });

  it('has stars concentrated ahead: of uniformly distributed ones (1 + β)/2 are in the forward hemisphere', () => {
    const { stars, orientation } = sceneNightSky(saturn)!;
    const toward = Array.from(
      stars.temperatures,
      (_, i): Vec3 =>
        rotate(orientation, [stars.directions[3 * i], stars.directions[3 * i + 1], stars.directions[3 * i + 2]]),
    );
    const ahead = ({ u }: ProbeObserver) => toward.filter((n) => dot(aberrate(n, u), me.u) > 0).length / toward.length;
    expect(ahead(atRest(me))).toBeCloseTo(0.5, 1);
    expect(Math.abs(ahead(me) - (1 + beta(me)) / 2)).toBeLessThan(0.04);
  });

  it('has a globe whose outline stays nearly circular', () => {
    const globe = worldPositions(objectAt(saturn, '/World/Planet'), me.t, c);
    const outlineRatio = (observer: ProbeObserver) => {
      const directions = globe.map((p) => normalize(seenAt(p, observer)));
      const middle = normalize(mean(directions));
      const widths = Array.from({ length: 36 }, (_, k) => {
        const side = normalize(cross(middle, [0.1, 1, 0.2]));
        const up = cross(side, middle);
        const axis = [0, 1, 2].map(
          (i) => side[i] * Math.cos((k * Math.PI) / 36) + up[i] * Math.sin((k * Math.PI) / 36),
        ) as [number, number, number];
        const reach = directions.map((d) => dot(scale(d, 1 / (1 + dot(d, middle))), axis));
        return Math.max(...reach) - Math.min(...reach);
      });
      return Math.min(...widths) / Math.max(...widths);
    };
    expect(outlineRatio(atRest(me))).toBeGreaterThan(0.88);
    expect(Math.abs(outlineRatio(me) - outlineRatio(atRest(me)))).toBeLessThan(0.03);
  });
});
