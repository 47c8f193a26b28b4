import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../src/math/vec3.ts';
import { properVelocity, velocity } from '../../src/physics/lorentz/boost.ts';
import { observerFromCamera } from '../../src/scene/view/camera.ts';
import { probeVertices } from '../../src/scene/view/probe.ts';
import { objectAt, openExample, speedOfLight, worldPositions } from './open.ts';

const scene = await openExample('ladder');
const c = speedOfLight(scene);
const ladder = objectAt(scene, '/World/Ladder');
const MEETING = 10;

const span = (points: readonly Vec3[], k: number): [number, number] => [
  Math.min(...points.map((p) => p[k])),
  Math.max(...points.map((p) => p[k])),
];

/** The gap between the two leaves of a door, in the barn's frame. */
function gap(end: 'Entry' | 'Exit', t: number): number {
  const leaf = (side: string) => span(worldPositions(objectAt(scene, `/World/Doors/${end}${side}`), t, c), 2);
  return leaf('Right')[0] - leaf('Left')[1];
}

/** x of the barn's doors, inside. */
const doorAt = (end: 'Entry' | 'Exit'): number => {
  const [low, high] = span(worldPositions(objectAt(scene, `/World/Doors/${end}Left`), MEETING, c), 0);
  return end === 'Entry' ? high : low;
};

describe('ladder', () => {
  it('is inside with both doors shut in the barn’s frame', () => {
    const [tail, nose] = span(worldPositions(ladder, MEETING, c), 0);
    expect(nose - tail).toBeCloseTo(12.8, 3);
    expect(tail).toBeGreaterThan(doorAt('Entry'));
    expect(nose).toBeLessThan(doorAt('Exit'));
    for (const end of ['Entry', 'Exit'] as const) expect(Math.abs(gap(end, MEETING))).toBeLessThan(1e-6);
  });

  it('never touches a door: doors are wide open while it is in the doorway', () => {
    const half = span(worldPositions(ladder, MEETING, c), 2)[1];
    // Before and after these times the doors are at rest, wide open.
    for (let t = MEETING - 0.5; t <= MEETING + 0.5; t += 0.01) {
      const [tail, nose] = span(worldPositions(ladder, t, c), 0);
      for (const end of ['Entry', 'Exit'] as const) {
        const x = doorAt(end);
        if (tail < x + 0.2 && nose > x - 0.2) expect(gap(end, t), `${end} at ${t} s`).toBeGreaterThan(2 * half);
      }
    }
  });

  /** At one moment of the ladder’s frame: world times of events at the doors and the ladder, and lengths. */
  const slice = (t: number) => {
    const position: Vec3 = [0.6 * c * (t - MEETING), 0, 0];
    const observer = { t, position, u: properVelocity([0.6, 0, 0]) };
    const probe = (path: string) => probeVertices(objectAt(scene, path), observer, c, 'simultaneity').map((p) => p!);
    const along = (path: string) =>
      span(
        probe(path).map(({ apparent }) => apparent),
        0,
      );
    const shut = (end: string) => probe(`/World/Doors/${end}Left`).some(({ time }) => Math.abs(time - MEETING) < 0.04);
    return { along, shut };
  };

  it('is longer than the barn in its own frame, where the barn has 14 · 0.8 m', () => {
    const { along } = slice(MEETING);
    const [tail, nose] = along('/World/Ladder');
    expect(nose - tail).toBeCloseTo(16, 3);
    expect(along('/World/Doors/ExitLeft')[1] - along('/World/Doors/EntryLeft')[0]).toBeCloseTo(14 * 0.8, 1);
  });

  it('never has both doors shut in its own frame', () => {
    let [entry, exit] = [0, 0];
    for (let t = MEETING - 3.5; t <= MEETING + 3.5; t += 0.01) {
      const { shut } = slice(t);
      const now = [shut('Entry'), shut('Exit')];
      entry += now[0] ? 1 : 0;
      exit += now[1] ? 1 : 0;
      expect(now[0] && now[1]).toBe(false);
    }
    expect(entry).toBeGreaterThan(0);
    expect(exit).toBeGreaterThan(0);
  });

  it('has a co-moving camera', () => {
    const rider = scene.cameras.find(({ path }) => path === '/World/Rider')!;
    expect(velocity(observerFromCamera(rider, 10, c).u)[0]).toBeCloseTo(0.6, 9);
  });
});
