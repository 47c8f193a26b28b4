import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { direction, properVelocityUpTo, uniform } from '../../../tests/support/physicsArbitraries.ts';
import { IDENTITY } from '../../math/quat.ts';
import { addScaled, distance, length, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { gamma, properVelocity } from '../../physics/lorentz/boost.ts';
import { apparentPosition } from '../../physics/optics/apparentPosition.ts';
import { dopplerFactor } from '../../physics/optics/doppler.ts';
import { emissionEvent } from '../../physics/worldLines/lightCone.ts';
import { makeObject, makeScene, restingAt } from '../../scene/defaults.ts';
import { box, sphere } from '../../scene/mesh/primitives.ts';
import { perspective } from '../../scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../scene/view/view.ts';
import { isLuminous, placementIn, VIEW_NAMES, type View } from '../../scene/views/views.ts';
import type { SpacetimeRay } from '../acceleration/ray.ts';
import { dopplerOfHit } from '../aov.ts';
import { createTracedScene } from '../intersection/tracedScene.ts';
import { cameraRay } from './cameraRay.ts';
import { directionAt } from './lensRay.ts';
import { sightCurve } from './sightCurve.ts';
import { visibleHit } from './visibleHit.ts';

const C = 10;
const settingsOf = (view: View): RenderSettings => ({ ...DEFAULT_SETTINGS, view, speedOfLight: C, coneSlope: 0.4 });
const vantages = fc.tuple(direction, uniform(0.01, 4)).map(([n, r]) => scale(n, r));
const observer = fc.record({ u: properVelocityUpTo(5), vantage: vantages, n: direction });

/** An event of a ray. */
const at = ({ t, x, dt, dx }: SpacetimeRay, s: number) => ({ time: t + (s * dt) / C, position: addScaled(x, dx, s) });
const AHEAD: ViewPoint = { t: 0, position: [0, 0, 0], u: [0, 0, 0], orientation: IDENTITY, lens: perspective(1.6) };

describe('what is seen from beside the eye', () => {
  it.each(VIEW_NAMES)('%s: the events that are shown on a straight line', (name) => {
    const settings = settingsOf(name);
    fc.assert(
      fc.property(observer, uniform(0, 20), ({ u, vantage, n }, s) => {
        const eye = { t: 3, position: [1, -2, 0.5] as Vec3, u };
        const curve = sightCurve(eye, vantage, n, settings, 'vantage');
        const there = addScaled(vantage, n, s);
        const event = at(curve.tangent(s), s);
        const shown = placementIn(settings).position(sub(event.position, eye.position), u);
        const scaleOf = gamma(u) ** 2 * (1 + length(there));
        expect(distance(shown, there) / scaleOf).toBeLessThan(1e-9);
        if (isLuminous(settings))
          expect(Math.abs(C * (eye.t - event.time) - distance(event.position, eye.position)) / scaleOf).toBeLessThan(
            1e-9,
          );
        // The light by which it is seen comes from there.
        const light = at(curve.lightFrom(s), length(there));
        expect(distance(light.position, event.position) / scaleOf).toBeLessThan(1e-9);
        expect((C * Math.abs(light.time - event.time)) / scaleOf).toBeLessThan(1e-9);
        // Chords follow it closely.
        const k = curve.knots.findIndex((knot) => knot > s) - 1;
        const near = at(curve.chord(k), s);
        const bent = distance(near.position, event.position) + C * Math.abs(near.time - event.time);
        expect(bent / (length(there) * 4 * gamma(u))).toBeLessThan(2e-4);
      }),
    );
  });

  it('is, in a world at rest, what an observer there sees, at earlier times', () => {
    const scene = makeScene({
      name: 'at rest',
      objects: [
        makeObject({ path: '/Box', mesh: box([1, 2, 1]), motion: restingAt([0.5, 0, -4]) }),
        makeObject({ path: '/Ball', mesh: sphere(0.8), motion: restingAt([-1, 0, -3]) }),
      ],
    });
    const traced = createTracedScene(scene, C);
    const settings = settingsOf('light-cone');
    const vantage: Vec3 = [0.7, 0.4, -0.5];
    const aside: ViewPoint = { ...AHEAD, vantage };
    const there: ViewPoint = { ...AHEAD, position: vantage };
    const seen = new Set<number>();
    for (let x = 0.5; x < 24; x++)
      for (let y = 0.5; y < 16; y++) {
        const hit = visibleHit(traced, cameraRay(aside, settings, x, y, 24, 16)!);
        const expected = visibleHit(traced, cameraRay(there, settings, x, y, 24, 16)!);
        expect(hit?.object).toBe(expected?.object);
        if (!hit || !expected) continue;
        seen.add(hit.object);
        expect(distance(hit.position, expected.position)).toBeLessThan(1e-9);
        expect(Math.abs(hit.s - expected.s)).toBeLessThan(1e-9);
        expect(-C * hit.time).toBeCloseTo(length(hit.position), 9);
      }
    expect(seen.size).toBe(2);
  });

  it('of bodies in motion is where their points are shown, and when, whichever way they move', () => {
    const velocity: Vec3 = [7, 1, 2];
    const motion = { kind: 'uniform', pose: { position: [-1, 0, -4], orientation: IDENTITY }, velocity } as const;
    const accelerated = {
      kind: 'hyperbolic',
      pose: { position: [2, 0, -5], orientation: IDENTITY },
      properAcceleration: [0, 12, 0],
      t0: 0,
    } as const;
    const scene = makeScene({
      name: 'in motion',
      objects: [
        makeObject({ path: '/Ball', mesh: sphere(0.8, { segments: 64, rings: 32 }), motion }),
        makeObject({ path: '/Box', mesh: box([1, 1, 1]), motion: accelerated }),
      ],
    });
    const traced = createTracedScene(scene, C);
    const settings = settingsOf('light-cone');
    const view: ViewPoint = { ...AHEAD, u: properVelocity([0.2, 0.1, -0.7]), vantage: [1.5, 0.5, -1] };
    const seen = new Set<number>();
    for (let x = 0.5; x < 48; x++)
      for (let y = 0.5; y < 32; y++) {
        const ray = cameraRay(view, settings, x, y, 48, 32)!;
        const hit = visibleHit(traced, ray);
        if (!hit) continue;
        seen.add(hit.object);
        const shown = sub(apparentPosition(hit.position, view.u), view.vantage!);
        expect(length(shown)).toBeCloseTo(hit.s, 8);
        const n = directionAt(view, x, y, 48, 32)!;
        expect(distance(normalize(shown), n)).toBeLessThan(1e-8);
        expect(-C * hit.time).toBeCloseTo(length(hit.position), 8);
        if (hit.object !== 0) continue;
        // A point that moves with the ball was there when its light left.
        const line = { kind: 'uniform', position: sub(hit.position, scale(velocity, hit.time)), velocity } as const;
        const center = emissionEvent(line, { t: 0, position: [0, 0, 0] }, C)!;
        expect(distance(center.position, hit.position)).toBeLessThan(1e-8);
        expect(dopplerOfHit(hit, ray, view.u)).toBeCloseTo(
          dopplerFactor(hit.position, view.u, properVelocity(scale(velocity, 1 / C))),
          9,
        );
      }
    expect(seen.size).toBe(2);
  });
});
