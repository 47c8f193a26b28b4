import { describe, expect, it } from 'vitest';
import { add, build, connect } from '../../../tests/support/graphKit.ts';
import { english, inWords, saying } from '../../../tests/support/inWords.ts';
import type { RunRecord } from '../../dynamics/runRecord.ts';
import { summarizeRun } from '../../dynamics/runSummary.ts';
import { openScene } from '../../formats/open.ts';
import type { GraphDocument, ParamValue } from '../../graph/document/document.ts';
import type { Command } from '../../graph/edits/commands.ts';
import { CancelledError, Evaluator } from '../../graph/evaluation/evaluator.ts';
import type { Outputs } from '../../graph/nodeType.ts';
import { length, sub, type Vec3 } from '../../math/vec3.ts';
import { chinese } from '../../messages/languages/chinese.ts';
import { inEnglish, msg, translate } from '../../messages/message.ts';
import { grid } from '../../scene/mesh/primitives.ts';
import { poseAt, vertexPositions } from '../../scene/motion/motion.ts';
import { InputError, type Scene, type SceneObject } from '../../scene/types.ts';
import { validate } from '../../scene/validation/validate.ts';
import { probeVertices } from '../../scene/view/probe.ts';
import { nodeLibrary } from '../library.ts';
import { exportSceneFile } from '../project/exportSceneFile.ts';
import { type LoadedScene, type Services, workerServices } from '../services.ts';

type Params = Readonly<Record<string, ParamValue>>;
const sets = (node: string, params: Params): Command[] =>
  Object.entries(params).map(([param, value]) => ({ kind: 'set-param', node, param, value }));
const node = (id: string, type: string, params: Params = {}): Command[] => [add(id, type), ...sets(id, params)];

/** An object with the matter node that it feeds. */
const matter = (id: string, thing: readonly [string, Params], at: Vec3, kind: string, params: Params): Command[] => [
  ...node(`${id}Shape`, thing[0], { name: id, ...thing[1] }),
  ...node(`${id}At`, 'transform', { position: at }),
  ...node(id, kind, params),
  connect(`${id}Shape.geometry`, `${id}At.geometry`),
  connect(`${id}At.geometry`, `${id}.geometry`),
];
const ball = (id: string, radius: number, at: Vec3, params: Params): Command[] =>
  matter(id, ['sphere', { radius, segments: 8, rings: 4 }], at, 'collider', { free: true, ...params });
const sheet = (id: string, cells: number, at: Vec3, params: Params): Command[] =>
  matter(id, ['grid', { width: 1, length: 1, columns: cells, rows: cells }], at, 'mass-spring', params);
const running = (parts: readonly string[], params: Params): Command[] => [
  ...node('run', 'simulate', params),
  ...parts.map((part, i) => connect(`${part}.matter`, `run.matter.${i + 1}`)),
];

async function resultOf(document: GraphDocument) {
  return (await new Evaluator(nodeLibrary).evaluate(document, 'run', workerServices)).target;
}

async function simulated(
  ...commands: readonly Command[]
): Promise<{ readonly scene: Scene; readonly books: RunRecord }> {
  const target = await resultOf(build(...commands));
  if (target.status !== 'done') throw new Error(JSON.stringify(target));
  return { scene: (target.outputs.geometry as LoadedScene).scene, books: target.outputs.books as RunRecord };
}

const refusalOf = async (...commands: readonly Command[]) => {
  const target = await resultOf(build(...commands));
  return target.status === 'failed' ? target.problem : undefined;
};

const thing = (scene: Scene, path: string): SceneObject => scene.objects.find((object) => object.path === path)!;
const placeOf = (object: SceneObject, t: number, c: number): Vec3 => poseAt(object.motion, t, c).position;
/** Mean of a net's vertices: of a sheet, whose vertices are all points. */
function middleAt(object: SceneObject, t: number, c: number): Vec3 {
  const all = vertexPositions(object, t, c);
  return [0, 1, 2].map(
    (k) => all.filter((_, i) => i % 3 === k).reduce((a, b) => a + b) / (all.length / 3),
  ) as unknown as Vec3;
}
const largest = (values: Iterable<number>): number => Math.max(...Array.from(values, Math.abs));

describe('a body under a constant force', () => {
  const [c, g] = [5, 20];
  const fallen = (t: number): number => ((c * c) / g) * (Math.sqrt(1 + ((g * t) / c) ** 2) - 1);
  const falling = simulated(
    ...ball('Stone', 0.1, [0, 100, 0], { mass: 3 }),
    ...node('weight', 'field', { gravity: [0, -g, 0] }),
    ...running(['Stone', 'weight'], { speedOfLight: c, duration: 2, rate: 12, method: 'yoshida-8' }),
  );

  it('moves along a hyperbola, at its frames and between them', async () => {
    const stone = thing((await falling).scene, '/Stone');
    for (const t of [0, 1 / 12, 0.5, 1, 2]) expect(placeOf(stone, t, c)[1]).toBeCloseTo(100 - fallen(t), 5);
    for (const t of [0.06, 0.31, 0.77, 1.93])
      expect(Math.abs(placeOf(stone, t, c)[1] - 100 + fallen(t))).toBeLessThan(1e-3);
    expect((await falling).books.fastest.at(-1)).toBeLessThan(c);
    expect((await falling).scene).toMatchObject({ startTime: 0, endTime: 2, hints: { speedOfLight: c } });
  });

  it('is seen where it was when the light left it', async () => {
    const stone = thing((await falling).scene, '/Stone');
    const eye = { t: 1.9, position: [3, 98, 2] as Vec3, u: [0, 0, 0] as Vec3 };
    const seen = probeVertices(stone, eye, c, 'light-cone')[0]!;
    const offset = [...stone.mesh.positions.subarray(0, 3)] as unknown as Vec3;
    const place: Vec3 = [offset[0], 100 - fallen(seen.time) + offset[1], offset[2]];
    expect(seen.time).toBeLessThan(1.9 - 0.5);
    expect(c * (eye.t - seen.time)).toBeCloseTo(length(sub(place, eye.position)), 2);
    expect(length(sub(seen.apparent, sub(place, eye.position)))).toBeLessThan(2e-3);
  });

  it('moves along a parabola in Newtonian mechanics, at any speed', async () => {
    const { scene, books: record } = await simulated(
      ...ball('Stone', 0.1, [0, 100, 0], {}),
      ...node('weight', 'field', { gravity: [0, -g, 0] }),
      ...running(['Stone', 'weight'], { speedOfLight: c, mechanics: 'newton', duration: 2, rate: 12 }),
    );
    expect(placeOf(thing(scene, '/Stone'), 2, c)[1]).toBeCloseTo(100 - (g * 4) / 2, 4);
    expect(record.fastest.at(-1)).toBeCloseTo(2 * g, 6);
    expect(record.speedOfLight).toBe(Number.POSITIVE_INFINITY);
  });
});

describe('a free net', () => {
  it('rotates and oscillates, and its centre moves uniformly', async () => {
    const { scene, books: record } = await simulated(
      ...sheet('Sheet', 4, [0, 0, 0], {
        structural: 50,
        shear: 20,
        bending: 5,
        tension: 0.9,
        velocity: [1, 2, 0],
        spin: [0, 0, 4],
      }),
      ...running(['Sheet'], { mechanics: 'newton', duration: 1, rate: 24 }),
    );
    const object = thing(scene, '/Sheet');
    for (const t of [0.25, 1]) expect(length(sub(middleAt(object, t, 10), [t, 2 * t, 0]))).toBeLessThan(1e-5);
    const start = vertexPositions(object, 0, 10);
    expect(largest(vertexPositions(object, 1, 10).map((x, i) => x - start[i] - [1, 2, 0][i % 3]!))).toBeGreaterThan(
      0.3,
    );
    expect(largest(record.total.map((E) => E / record.total[0]! - 1))).toBeLessThan(1e-10);
  });

  it('conserves momentum and angular momentum near c, and no scene is faster than light', async () => {
    const { scene, books: record } = await simulated(
      ...sheet('Sheet', 4, [0, 0, 0], {
        structural: 300,
        shear: 100,
        bending: 10,
        spin: [3, 0, 8],
        velocity: [3, 0, 0],
      }),
      ...running(['Sheet'], { speedOfLight: 8, duration: 1, rate: 48 }),
    );
    for (let i = 0; i < record.momentum.length; i++) {
      expect(record.momentum[i]! - record.momentum[i % 3]!).toBeCloseTo(0, 9);
      expect(record.angularMomentum[i]! - record.angularMomentum[i % 3]!).toBeCloseTo(0, 9);
    }
    expect(largest(record.fastest)).toBeGreaterThan(5);
    expect(largest(record.fastest)).toBeLessThan(8);
    expect(validate(scene, 8).filter(({ severity }) => severity === 'error')).toEqual([]);
  });

  it('of a closed mesh is welded where normals split it, and stays closed', async () => {
    const { scene } = await simulated(
      ...matter('Cube', ['box', {}], [0, 0, 0], 'mass-spring', { spin: [2, 3, 4] }),
      ...running(['Cube'], { duration: 0.5 }),
    );
    const cube = thing(scene, '/Cube');
    const [before, after] = [0, 0.5].map((t) => vertexPositions(cube, t, 10));
    const pairs = (x: Float64Array): string[] =>
      Array.from({ length: 24 * 24 }, (_, k) => [Math.floor(k / 24), k % 24] as const)
        .filter(([i, j]) => [0, 1, 2].every((a) => Math.abs(x[3 * i + a]! - x[3 * j + a]!) < 1e-9))
        .map(String);
    expect(pairs(before!)).toHaveLength(8 * 9);
    expect(pairs(after!)).toEqual(pairs(before!));
  });

  it('with filling regains its shape', async () => {
    const height = async (filling: number): Promise<number> => {
      const { scene } = await simulated(
        ...matter('Ball', ['sphere', { radius: 0.5, segments: 8, rings: 4 }], [0, 0.6, 0], 'mass-spring', {
          structural: 20,
          shear: 0,
          bending: 0,
          filling,
        }),
        ...matter('Floor', ['grid', {}], [0, 0, 0], 'collider', { shape: 'plane' }),
        ...node('weight', 'field', { drag: 4 }),
        ...running(['Ball', 'Floor', 'weight'], { speedOfLight: 100, duration: 3, method: 'leapfrog' }),
      );
      return largest(vertexPositions(thing(scene, '/Ball'), 3, 100).filter((_, i) => i % 3 === 1));
    };
    expect(await height(400)).toBeGreaterThan(0.85);
    expect(await height(0)).toBeLessThan(0.7);
  });
});

describe('a body that is held', () => {
  it('swings with the period 2π√(L/g) on a rod, at small amplitudes', async () => {
    const [L, g] = [2, 9.8];
    const tilt = 0.02;
    const { scene } = await simulated(
      ...ball('Bob', 0.1, [L * Math.sin(tilt), -L * Math.cos(tilt), 0], {
        rods: 'pivot',
        pivot: [-L * Math.sin(tilt), L * Math.cos(tilt), 0],
        rodStiffness: 1e6,
      }),
      ...node('weight', 'field'),
      ...running(['Bob', 'weight'], { speedOfLight: 1e6, duration: 3.2, rate: 100, method: 'leapfrog', step: 2e-4 }),
    );
    const bob = thing(scene, '/Bob');
    const times = Array.from({ length: 3200 }, (_, i) => i / 1000);
    const turned = times.filter((t) => placeOf(bob, t, 1e6)[0] > 0 !== placeOf(bob, t + 1e-3, 1e6)[0] > 0);
    expect(turned).toHaveLength(2);
    expect(2 * (turned[1]! - turned[0]!)).toBeCloseTo(2 * Math.PI * Math.sqrt(L / g), 2);
    const rod = thing(scene, '/Bob/Rod');
    const ends = vertexPositions(rod, 1, 1e6);
    const far = [0, 8].map((v) => [...ends.subarray(3 * v, 3 * v + 3)] as unknown as Vec3);
    expect(length(sub(far[0]!, far[1]!))).toBeCloseTo(L, 3);
  });

  it('stays where held: by corners, top, box or indices', async () => {
    const held = async (params: Params): Promise<string[]> => {
      const { scene } = await simulated(
        ...sheet('Sheet', 2, [0, 0, 0], params),
        ...node('weight', 'field'),
        ...running(['Sheet', 'weight'], { duration: 0.2, rate: 10 }),
      );
      const x = vertexPositions(thing(scene, '/Sheet'), 0.2, 10);
      const places = Array.from({ length: 9 }, (_, i) => x.subarray(3 * i, 3 * i + 3));
      return places.flatMap(([x, y, z]) => (y === 0 ? [`${x} ${z}`] : [])).sort();
    };
    expect(await held({ pins: 'corners' })).toEqual(['-0.5 -0.5', '-0.5 0.5', '0.5 -0.5', '0.5 0.5']);
    expect(await held({ pins: 'top' })).toHaveLength(9);
    const side = { pins: 'box', pinCenter: [0.5, 0, 0] as Vec3, pinSize: [0.2, 1, 2] as Vec3 };
    expect(await held(side)).toEqual(['0.5 -0.5', '0.5 0', '0.5 0.5']);
    const { positions } = grid(1, 1, 2, 2, 'Y');
    const places = [4, 6, 7].map((v) => `${positions[3 * v]} ${positions[3 * v + 2]}`);
    expect(await held({ pins: 'points', pinned: '4, 6-7' })).toEqual(places.sort());
    expect(await held({})).toEqual([]);
  });
});

describe('collisions', () => {
  it('conserve momentum: cloth and a free ball', async () => {
    const { scene, books: record } = await simulated(
      ...sheet('Sheet', 6, [0, 0, 0], { structural: 200, shear: 50, bending: 5, mass: 0.5 }),
      ...ball('Ball', 0.3, [0.05, 1, 0], { mass: 0.4, velocity: [0, -5, 0], stiffness: 2000 }),
      ...running(['Sheet', 'Ball'], { duration: 0.5 }),
    );
    for (let i = 0; i < record.momentum.length; i++) expect(record.momentum[i]).toBeCloseTo(record.momentum[i % 3]!, 9);
    expect(largest(record.total.map((E) => E / record.total[0]! - 1))).toBeLessThan(1e-9);
    expect(middleAt(thing(scene, '/Sheet'), 0.5, 10)[1]).toBeLessThan(-0.5);
  });

  it('of equal masses in a row pass on the whole velocity, near c too', async () => {
    const c = 10;
    const count = 4;
    const { scene, books: record } = await simulated(
      ...Array.from({ length: count }, (_, i) =>
        ball(
          `B${i}`,
          0.1,
          [i * 0.4 - (i === 0 ? 1 : 0), 0, 0],
          i === 0 ? { velocity: [8, 0, 0], stiffness: 5e5 } : { stiffness: 5e5 },
        ),
      ).flat(),
      ...running(
        Array.from({ length: count }, (_, i) => `B${i}`),
        { speedOfLight: c, duration: 0.5, rate: 100, step: 2e-5 },
      ),
    );
    const speeds = Array.from({ length: count }, (_, i) => {
      const b = thing(scene, `/B${i}`);
      return (placeOf(b, 0.5, c)[0] - placeOf(b, 0.49, c)[0]) / 0.01;
    });
    expect(speeds.slice(0, -1).every((v) => Math.abs(v) < 0.02)).toBe(true);
    expect(speeds.at(-1)).toBeCloseTo(8, 1);
    expect(record.momentum.at(-3)).toBeCloseTo(record.momentum[0]!, 9);
  });

  it('of two charges head-on reverse where all energy is potential', async () => {
    const [c, v, q] = [10, 6, 1e-4];
    const k = 8.987551786e9;
    const charges = ['Left', 'Right'].flatMap((id, i) =>
      ball(id, 0.01, [i === 0 ? -10 : 10, 0, 0], { charge: q, velocity: [i === 0 ? v : -v, 0, 0] }),
    );
    const { scene } = await simulated(
      ...charges,
      ...node('field', 'field', { gravity: [0, 0, 0], coulomb: true }),
      ...running(['Left', 'Right', 'field'], {
        speedOfLight: c,
        duration: 4,
        rate: 200,
        method: 'yoshida-4',
        step: 5e-4,
      }),
    );
    const apart = (t: number): number =>
      placeOf(thing(scene, '/Right'), t, c)[0] - placeOf(thing(scene, '/Left'), t, c)[0];
    const kinetic = 2 * (1 / Math.sqrt(1 - (v / c) ** 2) - 1) * c * c;
    const nearest = 1 / (kinetic / (k * q * q) + 1 / 20);
    const found = Math.min(...Array.from({ length: 801 }, (_, i) => apart(i / 200)));
    expect(found / nearest).toBeCloseTo(1, 3);
  });

  it('keep nets out of planes, rotated boxes, fixed balls and other nets', async () => {
    const dropped = async (kind: readonly [string, Params], params: Params): Promise<Vec3[]> => {
      const { scene } = await simulated(
        ...sheet('Sheet', 6, [0, 1, 0], { structural: 200, shear: 50, bending: 5 }),
        ...matter('Solid', kind, [0, 0, 0], 'collider', params),
        ...node('weight', 'field', { drag: 2 }),
        ...running(['Sheet', 'Solid', 'weight'], { speedOfLight: 50, duration: 1, method: 'leapfrog' }),
      );
      const x = vertexPositions(thing(scene, '/Sheet'), 1, 50);
      return Array.from({ length: x.length / 3 }, (_, i) => [x[3 * i]!, x[3 * i + 1]!, x[3 * i + 2]!]);
    };
    const onBall = await dropped(['sphere', { radius: 0.5 }], { shape: 'ball' });
    expect(Math.min(...onBall.map(length))).toBeGreaterThan(0.5);
    expect(Math.min(...onBall.map(length))).toBeLessThan(0.56);
    const onBox = await dropped(['box', { width: 0.8, height: 0.8, depth: 0.8 }], { shape: 'box', margin: 0.02 });
    expect(Math.min(...onBox.map((at) => Math.max(...at.map(Math.abs))))).toBeGreaterThan(0.4);
    expect(Math.min(...onBox.map(([, y]) => y))).toBeLessThan(0.4);
    const onPlane = await dropped(['grid', {}], { shape: 'plane', margin: 0.02 });
    expect(Math.min(...onPlane.map(([, y]) => y))).toBeGreaterThan(0);
    expect(Math.max(...onPlane.map(([, y]) => y))).toBeLessThan(0.3);
    const { scene } = await simulated(
      ...sheet('Upper', 8, [0, 0.5, 0], { velocity: [0, -2, 0] }),
      ...sheet('Lower', 8, [0, 0, 0], { pins: 'corners' }),
      ...running(['Upper', 'Lower'], { duration: 0.6, reach: 0.15, method: 'leapfrog' }),
    );
    expect(middleAt(thing(scene, '/Upper'), 0.6, 10)[1]).toBeGreaterThan(middleAt(thing(scene, '/Lower'), 0.6, 10)[1]);
  });
});

describe('a run', () => {
  const hanging = (params: Params = {}) => [
    ...sheet('Sheet', 6, [0, 0, 0], { pins: 'corners' }),
    ...node('weight', 'field'),
    ...running(['Sheet', 'weight'], { duration: 1, ...params }),
  ];

  it.each([
    ['by equal steps', { rate: 200 }],
    ['by steps that adapt', { rate: 200, tolerance: 1e-3 }],
  ])('is deterministic to the bit, also when stopped and resumed: %s', async (_, params) => {
    const [first, second] = await Promise.all([simulated(...hanging(params)), simulated(...hanging(params))]);
    expect(second).toEqual(first);
    const evaluator = new Evaluator(nodeLibrary);
    const abort = new AbortController();
    let seen: Outputs | undefined;
    const document = build(...hanging(params));
    const stopped = evaluator.evaluate(document, 'run', workerServices, {
      signal: abort.signal,
      onInterim: () => {},
      progress: (_, part) => {
        if ((part ?? 0) > 0.4) abort.abort();
      },
    });
    await expect(stopped).rejects.toThrow(CancelledError);
    // An evaluation before the work notices its cancellation would keep it running.
    await new Promise((resolve) => setTimeout(resolve, 300));
    const early = (await evaluator.evaluate(document, 'run', workerServices, { interims: 'stopped' })).target;
    if (early.status === 'done') seen = early.outputs;
    const frames = (seen!.books as RunRecord).times.length;
    expect(frames).toBeGreaterThan(0);
    expect(frames).toBeLessThan(201);
    const rest = (await evaluator.evaluate(document, 'run', workerServices)).target;
    if (rest.status !== 'done') throw new Error('it did not go on');
    expect((rest.outputs.geometry as LoadedScene).scene).toEqual(first.scene);
    expect(rest.outputs.books).toEqual(first.books);
  });

  it('that fails keeps its valid frames, and reports when and why', async () => {
    const { scene, books: record } = await simulated(
      ...hanging({ method: 'semi-implicit-euler', step: 0.02, speedOfLight: 1 }),
    );
    expect(record.stop).toMatchObject({ reason: 'unstable' });
    expect(record.times.length).toBeLessThan(25);
    expect(scene.diagnostics.map(({ code }) => code)).toContain('simulate.stopped');
    expect(scene.endTime).toBeCloseTo(Math.max(record.times.at(-1)!, 1 / 24), 9);
    expect(validate(scene, 1).filter(({ severity }) => severity === 'error')).toEqual([]);
  });

  it('that fails between frames shows what it came to', async () => {
    const unstable = { step: 0.01, rate: 10, speedOfLight: 10 };
    for (const [evenUnstable, method, reason] of [
      [false, 'leapfrog', 'unstable'],
      [true, 'semi-implicit-euler', 'light'],
    ] as const) {
      const { scene, books: record } = await simulated(...hanging({ ...unstable, method, evenUnstable }));
      expect(record.stop).toMatchObject({ reason });
      const { motion } = thing(scene, '/Sheet');
      if (motion.kind !== 'sampled-points') throw new Error('it does not deform');
      const end = motion.times.at(-1)!;
      expect(motion.points).toHaveLength(record.times.length + 1);
      expect(end).toBeGreaterThan(record.times.at(-1)!);
      expect(end).toBeLessThanOrEqual(record.stop!.t);
      expect(scene.endTime).toBeGreaterThanOrEqual(end);
      expect(validate(scene, 10).filter(({ severity }) => severity === 'error')).toEqual([]);
    }
  });

  it('that fails reports the object', async () => {
    const parts = [
      ...sheet('Sheet', 2, [0, 0, 0], { pins: 'corners' }),
      ...ball('Hard', 0.3, [0, -2, 0], { mass: 1e3, stiffness: 10, velocity: [0, 8, 0] }),
    ];
    const { books: record, scene } = await simulated(...parts, ...running(['Sheet', 'Hard'], { duration: 1 }));
    expect(record.stop).toMatchObject({ reason: 'pierced' });
    expect(inEnglish(record.stop!.message)).toMatch(/^vertex \d of \/Sheet went through what is solid, to \(/);
    expect(scene.diagnostics.map(inWords).join()).toContain(inEnglish(record.stop!.message));
    const { message } = scene.diagnostics.find(({ code }) => code === 'simulate.stopped')!;
    expect(translate(structuredClone(message), chinese.messages)).toMatch(
      /^于 t = [\d.]+ s 结束：\/Sheet 的顶点 \d 穿过了实体，到达（.*）m；请减小步长、加大接触劲度，或让它慢一些$/,
    );
    const light = { method: 'semi-implicit-euler', speedOfLight: 1, duration: 3 };
    const thrown = ball('Ball', 0.1, [0, 1, 0], {
      velocity: [0.9, 0, 0],
      rods: 'pivot',
      rodStiffness: 10_000,
      pivot: [0, 2, 0],
    });
    const { books: bad } = await simulated(...thrown, ...running(['Ball'], { ...light, step: 0.09, rate: 10 }));
    expect(english(bad.stop?.message)).toMatch(
      /^\/Ball goes at [\d.]+ m\/s, not below c = 1 m\/s; take a smaller step$/,
    );
  });

  it('reports numerical energy gain, even with steps below the stability bound', async () => {
    const noted = async (params: Params) => {
      const { scene } = await simulated(...hanging({ speedOfLight: 1, duration: 3, step: 0.0015, ...params }));
      return scene.diagnostics.filter(({ code }) => code.startsWith('simulate.'));
    };
    const [note] = await noted({ method: 'semi-implicit-euler', correction: '2' });
    expect(note).toMatchObject({ code: 'simulate.grows', place: 'run.method', severity: 'warning' });
    expect(inEnglish(note.message)).toMatch(
      /^from t = [\d.]+ s on there is energy without a source, .* an error of the method; set a shorter/,
    );
    expect(await noted({ method: 'leapfrog' })).toEqual([]);
    expect(await noted({ method: 'leapfrog', tolerance: 1e-300 })).toMatchObject([{ place: 'run.tolerance' }]);
  });

  it('rejects what is too large, too fast or missing, with a remedy', async () => {
    expect(await refusalOf(...hanging({ rate: 1e6 }))).toMatchObject({ code: 'simulate.frames', place: 'run.rate' });
    expect(await refusalOf(...hanging({ duration: 1e5, rate: 0.1 }))).toMatchObject({ code: 'simulate.steps' });
    // Unit tests have no GPU; tests/gpu/compute/compute.test.ts checks its results.
    expect(await refusalOf(...hanging({ method: 'leapfrog', onGpu: true }))).toMatchObject({
      ...{ code: 'simulate.gpu', place: 'run.onGpu', remedy: { param: 'onGpu', value: false } },
      message: saying(/^there is no GPU here that computes \(WebGPU\); compute it on the processor$/),
    });
    expect(await refusalOf(...hanging({ method: 'leapfrog', onGpu: true, tolerance: 1e-6 }))).toMatchObject({
      ...{ code: 'simulate.gpu', place: 'run.tolerance', remedy: { param: 'tolerance', value: 0 } },
    });
    const fast = await refusalOf(...ball('Ball', 1, [0, 0, 0], { velocity: [11, 0, 0] }), ...running(['Ball'], {}));
    expect(fast).toMatchObject({ code: 'simulate.light', place: 'Ball' });
    const nowhere = [...sheet('Sheet', 2, [0, 0, 0], { which: '/Gone' }), ...running(['Sheet'], {})];
    expect(await resultOf(build(...nowhere))).toMatchObject({ status: 'blocked', by: 'Sheet' });
    const off = { pins: 'box', pinCenter: [9, 9, 9] as Vec3 };
    expect(await refusalOf(...sheet('Sheet', 2, [0, 0, 0], off), ...running(['Sheet'], {}))).toMatchObject({
      code: 'pins.none',
    });
    const many = { pins: 'points', pinned: '9' };
    expect(await refusalOf(...sheet('Sheet', 2, [0, 0, 0], many), ...running(['Sheet'], {}))).toMatchObject({
      code: 'pins.numbers',
      place: 'Sheet.pinned',
      message: saying(/^\/Sheet has no point 9: they are numbered from 0 to 8$/),
      remedy: { param: 'pinned' },
    });
    const thick = matter('Solid', ['box', {}], [0, 0, 0], 'collider', { shape: 'plane' });
    expect(await refusalOf(...thick, ...running(['Solid'], {}))).toMatchObject({
      code: 'collider.plane',
      remedy: { value: 'box' },
    });
    expect(await refusalOf(...node('weight', 'field'), ...running(['weight'], {}))).toMatchObject({
      code: 'simulate.nothing',
    });
  });
});

describe('bodies with prescribed motion', () => {
  const [c, u] = [10, 6];
  const thrown = (2 * u) / (1 + (u / c) ** 2);
  /** An object that moves along x, connected to the node that gives it a kind of matter. */
  const going = (
    id: string,
    thing: readonly [string, Params],
    motion: readonly [string, Params],
    kind: string,
    params: Params,
  ): Command[] => [
    ...node(`${id}Shape`, thing[0], { name: id, ...thing[1] }),
    ...node(`${id}Motion`, ...motion),
    ...node(`${id}Moved`, 'move', {}),
    ...node(id, kind, params),
    connect(`${id}Shape.geometry`, `${id}Moved.geometry`),
    connect(`${id}Motion.motion`, `${id}Moved.motion`),
    connect(`${id}Moved.geometry`, `${id}.geometry`),
  ];
  const uniform = ['motion-uniform', { velocity: [u, 0, 0] }] as const;

  it.each([
    ['a ball', ['sphere', { radius: 0.5, segments: 8, rings: 4 }], { shape: 'ball' }],
    ['a box', ['box', { width: 1, height: 1, depth: 1 }], { shape: 'box' }],
  ] as const)('keep moving: %s accelerates a body at rest to 2β/(1 + β²) c', async (_, shape, params) => {
    const { scene, books: record } = await simulated(
      ...going('Mover', shape, uniform, 'collider', params),
      ...ball('Target', 0.2, [3, 0, 0], { stiffness: 10_000 }),
      ...running(['Mover', 'Target'], { speedOfLight: c, duration: 1, rate: 40, method: 'leapfrog', step: 1e-4 }),
    );
    expect(record.fastest.at(-1)! / thrown).toBeCloseTo(1, 4);
    expect(record.kinetic[0]).toBe(0);
    expect(record.stop).toBeUndefined();
    // Pumping changes the energy, so no numerical gain is reported.
    expect(summarizeRun(record).fault).toBeUndefined();
    expect(scene.diagnostics).toEqual([]);
    for (const t of [0, 0.4, 1]) expect(placeOf(thing(scene, '/Mover'), t, c)).toEqual([u * t, 0, 0]);
    expect(validate(scene, c).filter(({ severity }) => severity === 'error')).toEqual([]);
  });

  it('move the held points of a cloth, whose other points start with the same velocity', async () => {
    const { scene, books: record } = await simulated(
      ...going(
        'Sheet',
        ['grid', { width: 1, length: 1, columns: 4, rows: 4 }],
        ['motion-hyperbolic', { acceleration: [9, 0, 0], restAt: -0.5 }],
        'mass-spring',
        { pins: 'points', pinned: '0, 4' },
      ),
      ...running(['Sheet'], { speedOfLight: c, duration: 2, rate: 48, method: 'leapfrog' }),
    );
    const place = (t: number): number => ((c * c) / 9) * (Math.hypot(1, (9 * (t + 0.5)) / c) - 1);
    const object = thing(scene, '/Sheet');
    const at = (t: number) => vertexPositions(object, t, c);
    for (const t of [0, 1, 2]) {
      for (const vertex of [0, 4]) expect(at(t)[3 * vertex] - at(0)[3 * vertex]).toBeCloseTo(place(t) - place(0), 5);
    }
    const begun = (9 * 0.5) / Math.hypot(1, (9 * 0.5) / c);
    expect(record.fastest[0]).toBeCloseTo(begun, 9);
    // The whole net is towed, and nothing exceeds c.
    expect(Math.min(...at(2).filter((_, j) => j % 3 === 0))).toBeGreaterThan(place(2) - place(0) - 2);
    expect(largest(record.fastest)).toBeLessThan(c);
    expect(record.hasKinematic).toBe(true);
  });

  it('end the run where they exceed c, and are reported', async () => {
    const fast = ['motion-uniform', { velocity: [11, 0, 0] }] as const;
    const { books: record } = await simulated(
      ...going('Mover', ['box', {}], fast, 'collider', { shape: 'box' }),
      ...ball('Target', 0.2, [3, 0, 0], {}),
      ...running(['Mover', 'Target'], { speedOfLight: c, method: 'leapfrog' }),
    );
    expect(record.stop).toMatchObject({
      reason: 'light',
      message: saying('/Mover is moved at 11.00 m/s'),
    });
  });

  /** A paddle through the origin that rotates about y, a quarter turn in `quarter` seconds. */
  const paddle = (quarter: number): Command[] => {
    const keys = ['0 0 0 0', `${quarter} 0 0 0 0 90 0`];
    return going('Paddle', ['box', { width: 4, height: 1, depth: 0.2 }], ['motion-keyframes', { keys }], 'collider', {
      ...{ shape: 'box', stiffness: 1e6, margin: 0 },
    });
  };

  it('may rotate: a paddle accelerates a body at rest to 2β/(1 + β²) c, β at the point of contact', async () => {
    const omega = Math.PI / 2 / 0.5;
    const target = ball('Target', 0.1, [1.5, 0, -0.8], { stiffness: 1e6 });
    const { scene, books: record } = await simulated(
      ...paddle(0.5),
      ...target,
      ...running(['Paddle', 'Target'], { speedOfLight: c, duration: 0.4, rate: 50, method: 'leapfrog', step: 2e-5 }),
    );
    // Its front is 0.1 m beside the axis; contact begins at the ball's radius plus margin, 0.11 m.
    const along = Math.sqrt(1.5 ** 2 + 0.8 ** 2 - 0.21 ** 2);
    const beta = (omega * along) / c;
    expect(record.fastest.at(-1)! / c / ((2 * beta) / (1 + beta ** 2))).toBeCloseTo(1, 2);
    expect(record.stop).toBeUndefined();
    expect(scene.diagnostics).toEqual([]);
    expect(thing(scene, '/Paddle').motion.kind).toBe('sampled');
  });

  it('are reported if they rotate so fast that their ends exceed c', async () => {
    const { books: record } = await simulated(
      ...paddle(0.2),
      ...ball('Target', 0.1, [1.5, 0, -0.8], {}),
      ...running(['Paddle', 'Target'], { speedOfLight: c, duration: 0.4, method: 'leapfrog' }),
    );
    expect(record.stop).toMatchObject({
      reason: 'light',
      message: saying(/^\/Paddle is moved at 15\.\d+ m\/s/),
    });
  });

  it('are rejected as free bodies', async () => {
    const free = going('Mover', ['sphere', {}], uniform, 'collider', { shape: 'ball', free: true });
    expect(await resultOf(build(...free, ...running(['Mover'], {})))).toMatchObject({ status: 'blocked', by: 'Mover' });
  });
});

describe('a cache', () => {
  const hung = [
    ...sheet('Sheet', 4, [0, 1, 0], { pins: 'corners' }),
    ...node('weight', 'field'),
    ...running(['Sheet', 'weight'], { duration: 0.5 }),
    ...node('kept', 'cache'),
    connect('run.geometry', 'kept.geometry'),
  ];
  const keptOf = async (services: Services, ...more: Command[]) => {
    const { target } = await new Evaluator(nodeLibrary).evaluate(build(...hung, ...more), 'kept', services);
    return target;
  };

  it('passes its input on, or reads the written file instead, with the same motion, without running the simulation', async () => {
    const before = await keptOf(workerServices);
    if (before.status !== 'done') throw new Error('nothing comes through');
    const { scene } = before.outputs.geometry as LoadedScene;
    const { files } = await exportSceneFile({ kind: 'scene', name: 'a.usda', scene, sampled: true }, 'a.usda');
    const asked: unknown[] = [];
    const services: Services = {
      ...workerServices,
      readScene: async (source, { interpolation }) => {
        asked.push(source, interpolation);
        const read = async (path: string) => files.get(path);
        return { scene: await openScene({ read }, source, { interpolation: 'cubic' }) };
      },
    };
    // The input can no longer be evaluated: that object does not exist.
    const after = await keptOf(services, ...sets('kept', { file: 'a.usda' }), ...sets('Sheet', { which: '/Gone' }));
    if (after.status !== 'done') throw new Error(JSON.stringify(after));
    expect(asked).toEqual(['a.usda', 'cubic']);
    const read = (after.outputs.geometry as LoadedScene).scene;
    for (const t of [0, 0.1, 0.333, 0.5]) {
      const [a, b] = [scene, read].map(({ objects }) => vertexPositions(objects[0]!, t, 10));
      expect(largest(a!.map((x, i) => x - b![i]!))).toBeLessThan(1e-6);
    }
  });

  it('reports a missing file', async () => {
    const missing = {
      code: 'file.missing',
      place: 'a.usda',
      message: msg`there is no such file`,
      severity: 'error',
    } as const;
    const services = { ...workerServices, readScene: () => Promise.reject(new InputError(missing)) };
    expect(await keptOf(services, ...sets('kept', { file: 'a.usda' }))).toMatchObject({
      problem: { code: 'file.missing', remedy: { node: 'kept', param: 'file', value: '' } },
    });
  });
});
