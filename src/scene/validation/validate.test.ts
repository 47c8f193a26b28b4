import { describe, expect, it } from 'vitest';
import { inWords } from '../../../tests/support/inWords.ts';
import { fromAxisAngle, IDENTITY } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { inEnglish, msg } from '../../messages/message.ts';
import { FOREVER, makeObject, makeScene, restingAt } from '../defaults.ts';
import { box } from '../mesh/primitives.ts';
import type { Mesh, Motion, SampledMotion, Scene, SceneObject } from '../types.ts';
import { validate } from './validate.ts';

const poses = (given: readonly (readonly [t: number, x: number, angle?: number])[]): SampledMotion => ({
  kind: 'sampled',
  times: Float64Array.from(given, ([t]) => t),
  poses: Float64Array.from(given.flatMap(([, x, angle = 0]) => [x, 0, 0, ...fromAxisAngle([0, 0, 1], angle)])),
});
const object = (given: Partial<SceneObject> = {}): SceneObject =>
  makeObject({ path: '/World/Cube', mesh: box([2, 2, 2]), ...given });
const scene = (...objects: SceneObject[]): Scene => makeScene({ name: 'test', objects });
const told = (given: Partial<SceneObject>, c = 10): string[] =>
  validate(scene(object(given)), c).map((found) => `${found.code} | ${inWords(found)}`);
const meshWith = (given: Partial<Mesh>): Partial<SceneObject> => ({ mesh: { ...box([2, 2, 2]), ...given } });

describe('validate', () => {
  it('finds nothing in a valid scene', () => {
    expect(told({})).toEqual([]);
    expect(
      told({
        motion: poses([
          [0, 0],
          [1, 9.99],
        ]),
      }),
    ).toEqual([]);
  });

  it('reports prim, time, speed and the least valid c', () => {
    expect(
      told({
        motion: poses([
          [0, 0],
          [2, 0.5],
          [2.04, 1.024],
          [3, 2],
        ]),
      }),
    ).toEqual([
      'motion.superluminal | motion of /World/Cube: 1.31 c between t = 2.00 s and 2.04 s; raise c above 13.1 m/s or slow it down',
    ]);
  });

  it('uses the speed of the outermost vertex, not of the origin', () => {
    // Corners at √2 from the axis: chord 2√2 sin(θ/2) in 0.2 s.
    const motion = poses([
      [0, 0, 0],
      [0.2, 0, 2],
    ]);
    const speed = (2 * Math.SQRT2 * Math.sin(1)) / 0.2;
    expect(told({ motion })[0]).toContain('1.19 c between t = 0.00 s and 0.20 s; raise c above 12 m/s');
    expect(told({ motion }, speed * 1.001)).toEqual([]);
    expect(told({ motion }, speed * 0.999)[0]).toMatch(/^motion.superluminal .* 1\.001 c/);
  });

  it('the reported least c is valid', () => {
    for (const reach of [3, 11.7, 250, 123456]) {
      const motion = poses([
        [0, 0],
        [1, reach],
      ]);
      const least = Number(/raise c above (\S+) m\/s/.exec(told({ motion }, reach / 2)[0])![1]);
      expect(told({ motion }, least * (1 + 1e-6))).toEqual([]);
      expect(least).toBeLessThan(reach * 1.01 + 1e-9);
    }
  });

  it('checks deforming, uniform and rest-authored motion, and cameras', () => {
    const flat = box([2, 2, 2]).positions;
    const points: Motion = {
      kind: 'sampled-points',
      times: Float64Array.of(0, 0.1),
      origin: [0, 0, 0],
      points: [flat, flat.map((x) => 2 * x)],
    };
    expect(told({ motion: points })[0]).toContain('1.73 c between t = 0.00 s and 0.10 s');
    const velocity: Vec3 = [0, 0, -10];
    expect(
      told({ motion: { kind: 'uniform', pose: { position: [0, 0, 0], orientation: IDENTITY }, velocity } })[0],
    ).toContain('1 c at all times; raise c above 10 m/s');
    expect(
      told({
        motion: poses([
          [0, 0],
          [1, 12],
        ]),
        authoredIn: 'rest',
      })[0],
    ).toContain('1.20 c');
    const camera = {
      path: '/Camera',
      motion: poses([
        [0, 0],
        [1, 20],
      ]),
      fovY: 1,
    };
    const lamp = { ...camera, kind: 'sphere', path: '/Lamp', lifetime: FOREVER, radius: 1, color: [1, 1, 1] } as const;
    expect(validate({ ...scene(), cameras: [camera], lights: [lamp] }, 10)).toMatchObject([
      { place: msg`motion of ${'/Camera'}`, code: 'motion.superluminal' },
      { place: msg`motion of ${'/Lamp'}`, code: 'motion.superluminal' },
    ]);
  });

  it('a light needs finite sizes and colours', () => {
    const lamp = { path: '/Lamp', motion: restingAt([0, 0, 0]), lifetime: FOREVER, color: [1, 1, 1] } as const;
    const lights = [
      { ...lamp, kind: 'rect', width: 1, height: Number.NaN },
      { ...lamp, kind: 'cylinder', radius: -1, length: Number.POSITIVE_INFINITY },
      { ...lamp, kind: 'disk', radius: 1, color: [1, Number.NaN, 1] },
      { ...lamp, kind: 'sphere', radius: 0 },
    ] as const;
    expect(validate({ ...scene(), lights }, 10).map((d) => `${d.code}: ${inEnglish(d.message)}`)).toEqual([
      'light.size: its height is NaN m; give it a size of 0 m or more',
      'light.size: its radius is -1 m, its length is Infinity m; give it a size of 0 m or more',
      'light.color: its colour is 1, NaN, 1; give it three numbers',
    ]);
  });

  it('a Born-rigid body may not reach its horizon', () => {
    const motion: Motion = {
      kind: 'hyperbolic',
      pose: { position: [0, 0, 0], orientation: IDENTITY },
      properAcceleration: [125, 0, 0],
      t0: 0,
    };
    expect(told({ motion, authoredIn: 'rest' })).toEqual([
      'motion.horizon | motion of /World/Cube: a point 1.00 m behind its origin would have to outrun light (horizon at 0.800 m); raise c above 11.2 m/s or accelerate less',
    ]);
    expect(told({ motion, authoredIn: 'rest' }, 11.3)).toEqual([]);
    expect(told({ motion })).toEqual([]);
  });

  it('lists the first hundred warnings of a kind, then how many there are, and every error', () => {
    const many = (given: Partial<SceneObject>): string[] => {
      const objects = Array.from({ length: 250 }, (_, k) => object({ ...given, path: `/Part${k}` }));
      return validate(scene(...objects), 10).map((found) => `${found.severity} ${inEnglish(found.message)}`);
    };
    const warnings = many(meshWith({ indices: new Uint32Array(0) }));
    expect(warnings).toHaveLength(101);
    expect(warnings[100]).toBe('warning and 150 others like it; the first 100 are listed');
    expect(many(meshWith({ indices: Uint32Array.of(0, 1, 99) }))).toHaveLength(250);
  });

  it.each<[string, Partial<SceneObject>, string]>([
    ['mesh.empty', meshWith({ indices: new Uint32Array(0) }), 'has no triangle'],
    ['mesh.index', meshWith({ indices: Uint32Array.of(0, 1, 99) }), 'names vertex 99, but there are only 24'],
    ['mesh.length', meshWith({ uvs: new Float32Array(2) }), '24 vertices'],
    ['mesh.material', meshWith({ groups: [{ start: 0, count: 36, material: 7 }] }), 'material 7'],
    ['mesh.degenerate', meshWith({ indices: Uint32Array.of(0, 0, 1, 0, 1, 2) }), '1 of 2 triangles'],
    [
      'mesh.not-finite',
      meshWith({ positions: box([2, 2, 2]).positions.map((x, i) => (i === 4 ? Number.NaN : x)) }),
      'vertex 1 is at',
    ],
    [
      'motion.times',
      {
        motion: poses([
          [0, 0],
          [1, 0],
          [1, 0],
        ]),
      },
      'sample 2 is at 1.00 s',
    ],
    [
      'motion.samples',
      {
        motion: {
          ...poses([
            [0, 0],
            [1, 0],
          ]),
          times: Float64Array.of(0),
        },
      },
      '1 times and 2 samples',
    ],
    [
      'motion.not-finite',
      {
        motion: poses([
          [0, 0],
          [1, Number.POSITIVE_INFINITY],
        ]),
      },
      'pose at 1.00 s',
    ],
    ['motion.not-finite', { motion: restingAt([Number.NaN, 0, 0]) }, 'NaN'],
    [
      'motion.rest-points',
      {
        authoredIn: 'rest',
        motion: {
          kind: 'sampled-points',
          times: Float64Array.of(0, 1),
          origin: [0, 0, 0],
          points: [box([2, 2, 2]).positions, box([2, 2, 2]).positions],
        },
      },
      'taken as the world',
    ],
    ['object.lifetime', { lifetime: { birth: 3, death: 2 } }, 'never there'],
  ])('%s', (code, given, words) => {
    const found = told(given);
    expect(found.length).toBe(1);
    expect(found[0]).toContain(`${code} | `);
    expect(found[0]).toContain(words);
  });

  it('two objects with the same path', () => {
    expect(validate(scene(object(), object()), 10).map(({ code }) => code)).toEqual(['scene.duplicate-path']);
  });
});
