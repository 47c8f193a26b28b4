import { describe, expect, it } from 'vitest';
import { add, addScaled, cross, dot, length, normalize, scale, sub, type Vec3 } from '../../src/math/vec3.ts';
import { gamma, properVelocity } from '../../src/physics/lorentz/boost.ts';
import { positionAt } from '../../src/physics/worldLines/worldLine.ts';
import { boundingSphere } from '../../src/scene/bounds/bounds.ts';
import { originWorldLine } from '../../src/scene/motion/motion.ts';
import type { Mesh, SceneObject } from '../../src/scene/types.ts';
import { observerFromCamera } from '../../src/scene/view/camera.ts';
import { probeVertices } from '../../src/scene/view/probe.ts';
import type { ProbeObserver } from '../../src/scene/views/viewRecord.ts';
import { objectAt, openExample, speedOfLight, worldPositions } from './open.ts';

const scene = await openExample('sphere');
const c = speedOfLight(scene);

const direction = (object: SceneObject, observer: ProbeObserver): Vec3[] =>
  probeVertices(object, observer, c).map((p) => normalize(p!.apparent));

/** The points where the observer's light rays graze the sphere: a circle in its rest frame. */
function outline(object: SceneObject, observer: ProbeObserver): SceneObject {
  const { motion, mesh } = object;
  if (motion.kind !== 'uniform' && motion.kind !== 'static') throw new Error(`${object.path} should fly straight`);
  const { radius } = boundingSphere(mesh.positions);
  const u = motion.kind === 'uniform' ? properVelocity(scale(motion.velocity, 1 / c)) : ([0, 0, 0] as Vec3);
  const d = sub(observer.position, positionAt(originWorldLine(motion), observer.t, c));
  // World-simultaneous offset → rest frame: lengths along the motion grow by γ.
  const p = addScaled(d, u, dot(u, d) / (gamma(u) + 1));
  const [axis, cosine] = [normalize(p), radius / length(p)];
  const e1 = normalize(cross(axis, [0.3, 1, 0.2]));
  const e2 = cross(axis, e1);
  const points = Array.from({ length: 48 }, (_, k) => {
    const a = (2 * Math.PI * k) / 48;
    const side = add(scale(e1, Math.cos(a)), scale(e2, Math.sin(a)));
    return add(scale(axis, radius * cosine), scale(side, radius * Math.sqrt(1 - cosine * cosine)));
  });
  const pose = { ...motion.pose, orientation: [0, 0, 0, 1] as const };
  const grazing: Mesh = { ...mesh, positions: Float32Array.from(points.flat()) };
  return { ...object, mesh: grazing, motion: { ...motion, pose } };
}

const camera = (t: number, u: Vec3): ProbeObserver => ({
  t,
  position: observerFromCamera(scene.cameras[0], t, c).position,
  u,
});

describe('sphere', () => {
  const balls = ['Half', 'Fast', 'Fastest', 'BallLeft1', 'BallRight0'].map((name) => objectAt(scene, `/World/${name}`));
  const observers = [camera(5, [0, 0, 0]), camera(7.6, [0, 0, 0]), camera(7.6, properVelocity([0.5, 0, -0.8]))];

  it.each(balls.map((ball) => [ball.path, ball] as const))('%s: its outline is a circle, at any speed', (_, ball) => {
    for (const observer of observers) {
      const rim = direction(outline(ball, observer), observer);
      // The directions of a circle on the sky satisfy n·a = cos θ for an axis a.
      const axis = normalize(cross(sub(rim[16], rim[0]), sub(rim[32], rim[0])));
      const cosine = dot(axis, rim[0]);
      for (const n of rim) expect(Math.abs(dot(axis, n) - cosine)).toBeLessThan(1e-6);
      const towards = Math.sign(cosine);
      for (const n of direction(ball, observer))
        expect(towards * dot(axis, n)).toBeGreaterThan(Math.abs(cosine) - 1e-4);
    }
  });

  it('but it is contracted by 1/γ in the world', () => {
    const extent = (name: string) => {
      const xs = worldPositions(objectAt(scene, `/World/${name}`), 6, c).map(([x]) => x);
      return Math.max(...xs) - Math.min(...xs);
    };
    expect(extent('Half')).toBeCloseTo(3 * Math.sqrt(0.75), 1);
    expect(extent('Fast')).toBeCloseTo(3 * 0.6, 1);
    expect(extent('Fastest')).toBeCloseTo(3 * Math.sqrt(1 - 0.95 ** 2), 1);
  });

  it('parts of the far side are visible: meridians of the fastest sphere', () => {
    const ball = objectAt(scene, '/World/Fastest');
    const observer = camera(7.6, [0, 0, 0]);
    const rim = outline(ball, observer);
    const back = Math.min(...Array.from({ length: 48 }, (_, i) => rim.mesh.positions[3 * i + 2]));
    expect(back).toBeLessThan(-0.5);
  });
});
