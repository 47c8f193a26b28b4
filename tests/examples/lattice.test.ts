import { describe, expect, it } from 'vitest';
import { dot, length, type Vec3 } from '../../src/math/vec3.ts';
import { gamma, velocity } from '../../src/physics/lorentz/boost.ts';
import { observerFromCamera } from '../../src/scene/view/camera.ts';
import { probeVertices, type VertexProbe } from '../../src/scene/view/probe.ts';
import { objectAt, openExample, speedOfLight } from './open.ts';

const scene = await openExample('lattice');
const c = speedOfLight(scene);
const joints = objectAt(scene, '/World/Joints');
const [camera] = scene.cameras;

/** The observer at the fastest moment of the flight. */
const times = camera.motion.kind === 'sampled' ? [...camera.motion.times] : [];
const speedAt = (t: number) => length(observerFromCamera(camera, t, c).u);
const top = times.reduce((best, t) => (speedAt(t) > speedAt(best) ? t : best));
const { position } = observerFromCamera(camera, top, c);
/** Along the lattice, like the flight, approximately. */
const u: Vec3 = [0, 0, -speedAt(top)];
const probes = probeVertices(joints, { t: top, position, u }, c) as VertexProbe[];
const beta = length(velocity(u));

describe('lattice', () => {
  it('is traversed at more than 0.9 c', () => {
    expect(beta).toBeGreaterThan(0.9);
  });

  it('bars perpendicular to the motion appear as hyperbolas', () => {
    // x′∥ = γ(d + βr), r² = d² + ρ²: for points of a plane perpendicular to the motion (x′∥/γ − d)²/β² − ρ² = d², a hyperbola in each section.
    for (const { position: p, apparent } of probes) {
      const d = position[2] - p[2];
      const ahead = -apparent[2];
      const across = Math.hypot(apparent[0], apparent[1]);
      const scaled = ((ahead / gamma(u) - d) / beta) ** 2 - across ** 2;
      expect(scaled).toBeCloseTo(d * d, 6);
    }
    // The bend is significant: along a bar of a layer ahead, the ends appear ahead of the middle.
    const layer = probes.filter(
      ({ position: p }) =>
        Math.abs(p[2] - Math.round(p[2] / 4) * 4) < 0.01 && position[2] - p[2] > 3 && position[2] - p[2] < 7.2,
    );
    const depths = layer.map(({ apparent }) => -apparent[2]);
    expect(Math.max(...depths) - Math.min(...depths)).toBeGreaterThan(5);
  });

  it('bars along the motion stay straight and parallel to it', () => {
    for (const { position: p, apparent } of probes) {
      expect(apparent[0]).toBeCloseTo(p[0] - position[0], 9);
      expect(apparent[1]).toBeCloseTo(p[1] - position[1], 9);
    }
  });

  it('joints already passed are seen ahead', () => {
    const passed = probes.filter(({ position: p, apparent }) => p[2] > position[2] && dot(apparent, u) > 0);
    expect(passed.length).toBeGreaterThan(100);
  });
});
