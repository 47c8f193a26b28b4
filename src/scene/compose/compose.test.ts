import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { direction, expectClose, uniform } from '../../../tests/support/physicsArbitraries.ts';
import { fromAxisAngle, rotate } from '../../math/quat.ts';
import { add, cross, distance, length, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { FOREVER, makeMaterial, makeObject, makeScene, restingAt } from '../defaults.ts';
import { pointAt } from '../mesh/polygons.ts';
import { box, sphere } from '../mesh/primitives.ts';
import type { SimilarityTransform } from '../motion/kinds/changes.ts';
import { poseAt, vertexPosition } from '../motion/motion.ts';
import type { LocalLight, Mesh, Motion, Scene, SceneObject } from '../types.ts';
import { validate } from '../validation/validate.ts';
import { applyRigidMotion, movingPaths } from './applyRigidMotion.ts';
import { arrangeCopies, gridPoses, ringPoses } from './arrange.ts';
import { assignMaterial, withLifetime } from './assignMaterial.ts';
import { mergeScenes } from './mergeScenes.ts';
import { keyframedMotion, motionFromPath } from './motionPaths.ts';
import { loopSubdivide, midpointSubdivide } from './subdivideObject.ts';
import { transformScene } from './transformScene.ts';

const C = 30;
const mesh = box([1, 2, 3]);
const turn = fromAxisAngle([0, 0, 1], 0.7);
const points = [0, 1, 2].map((k) => mesh.positions.map((x, i) => x * (1 + 0.1 * k) + (i % 3 === 0 ? 0.2 * k : 0)));
const MOTIONS: readonly Motion[] = [
  restingAt([1, 2, 3]),
  { kind: 'uniform', pose: { position: [0, 1, 0], orientation: turn }, velocity: [3, -1, 2] },
  {
    kind: 'sampled',
    times: Float64Array.of(0, 1, 3),
    poses: Float64Array.of(0, 0, 0, 0, 0, 0, 1, 1, 2, 0, ...turn, 4, 2, 1, 0, 0, 0, 1),
  },
  { kind: 'sampled-points', times: Float64Array.of(0, 1, 2), origin: [5, 0, 0], points },
  {
    kind: 'sampled-points',
    times: Float64Array.of(0, 1, 2),
    origin: [5, 0, 0],
    points,
    velocities: points.map((p) => p.map((x) => x / 4)),
  },
];
const where = (by: SimilarityTransform, x: Vec3): Vec3 => add(by.position, rotate(by.orientation, scale(x, by.scale)));
const placement = fc.record({
  position: fc.tuple(uniform(-9, 9), uniform(-9, 9), uniform(-9, 9)),
  orientation: fc.tuple(direction, uniform(-3, 3)).map(([axis, angle]) => fromAxisAngle(axis, angle)),
  scale: uniform(0.2, 3),
});

describe('a placed scene', () => {
  it.each(MOTIONS.map((motion, i) => [i, motion.kind, motion] as const))(
    'has every vertex transformed by the placement, at all times (%i: %s)',
    (_i, _kind, motion) => {
      const object = makeObject({ path: '/It', mesh, motion });
      fc.assert(
        fc.property(placement, uniform(-1, 4), fc.nat(23), (by, t, v) => {
          const [placed] = transformScene(makeScene({ name: 'it', objects: [object] }), by).objects;
          expectClose([...vertexPosition(placed!, v, t, C)], where(by, vertexPosition(object, v, t, C)), 1e-5);
        }),
        { numRuns: 60 },
      );
    },
  );

  it('a light lights a placed wall as it lit the wall before', () => {
    const lamp = (radius: number): LocalLight => ({
      kind: 'sphere',
      path: '/L',
      radius,
      motion: restingAt([0, 2, 0]),
      lifetime: FOREVER,
      color: [1, 2, 3],
    });
    for (const radius of [0, 0.5]) {
      const { lights } = transformScene(makeScene({ name: 'l', lights: [lamp(radius)] }), {
        position: [0, 0, 0],
        orientation: turn,
        scale: 4,
      });
      const [light] = lights as [LocalLight & { radius: number }];
      // E = I/d² for a point, π L (r/d)² for a sphere.
      const E = (l: { radius: number; color: Vec3 }, d: number) =>
        (l.radius === 0 ? l.color[1] : Math.PI * l.color[1] * l.radius ** 2) / d ** 2;
      expect(E(light, 8)).toBeCloseTo(E(lamp(radius) as never, 2), 12);
      expect(distance(poseAt(light.motion, 0, C).position, rotate(turn, [0, 8, 0]))).toBeLessThan(1e-12);
    }
  });
});

describe('merged scenes', () => {
  const red = makeMaterial({ name: 'red', baseColor: [1, 0, 0] });
  const blue = makeMaterial({ name: 'blue', baseColor: [0, 0, 1] });
  const one = makeScene({ name: 'one', materials: [red], objects: [makeObject({ path: '/Ball/Skin', mesh })] });
  const other = makeScene({
    name: 'other',
    materials: [blue],
    startTime: 2,
    endTime: 5,
    objects: [makeObject({ path: '/Ball/Skin', mesh }), makeObject({ path: '/Ball2', mesh })],
  });

  it('keep the materials of every mesh, and have unique paths', () => {
    const merged = mergeScenes([one, other, one]);
    const worn = merged.objects.map((o) => [o.path, merged.materials[o.mesh.groups[0]!.material]!.name]);
    expect(worn).toEqual([
      ['/Ball/Skin', 'red'],
      ['/Ball2/Skin', 'blue'],
      ['/Ball22', 'blue'],
      ['/Ball3/Skin', 'red'],
    ]);
    expect([merged.startTime, merged.endTime]).toEqual([2, 5]);
  });

  it('materials and lifetimes are set on the chosen objects only', () => {
    const merged = mergeScenes([one, other]);
    const green = makeMaterial({ name: 'green' });
    const dressed = assignMaterial(merged, '/Ball2', green);
    expect(dressed.objects.map((o) => dressed.materials[o.mesh.groups[0]!.material]!.name)).toEqual([
      'red',
      'green',
      'blue',
    ]);
    const born = withLifetime(merged, '/Ball', { birth: 1, death: 2 });
    expect(born.objects.map(({ lifetime }) => lifetime.birth)).toEqual([1, -Infinity, -Infinity]);
  });

  it('a lifetime is within those before: pieces without time in it go, unless nothing would remain', () => {
    const piece = (n: number, birth: number) => ({
      ...makeObject({ path: `/Water/piece${n}`, mesh, lifetime: { birth, death: birth + 2 } }),
      pieceOf: '/Water',
    });
    const water = makeScene({ name: 'water', objects: [piece(1, 0), piece(2, 2), piece(3, 4)] });
    const lives = (scene: Scene) => scene.objects.map(({ path, lifetime }) => [path, lifetime.birth, lifetime.death]);
    const limited = withLifetime(water, '/Water', { birth: 1, death: 4 });
    expect(lives(limited)).toEqual([
      ['/Water/piece1', 1, 2],
      ['/Water/piece2', 2, 4],
    ]);
    expect(lives(withLifetime(limited, '', { birth: 3, death: 9 }))).toEqual([['/Water/piece2', 3, 4]]);
    const gone = withLifetime(water, '', { birth: 8, death: 9 });
    expect(gone.objects).toHaveLength(3);
    // Told once of a thing.
    expect(validate(gone, 10).map(({ code }) => code)).toEqual(['object.lifetime']);
  });

  it('copies and merged scenes keep pieces together', () => {
    const objects = [1, 2].map((n) => ({ ...makeObject({ path: `/Water/piece${n}`, mesh }), pieceOf: '/Water' }));
    const water = makeScene({ name: 'water', objects });
    const names = (scene: Scene) => scene.objects.map(({ path, pieceOf }) => `${pieceOf} ${path}`);
    expect(names(mergeScenes([water, water])).slice(2)).toEqual(['/Water2 /Water2/piece1', '/Water2 /Water2/piece2']);
    expect(names(arrangeCopies(water, ringPoses(2, 1, [0, 0, 1]))).slice(2)).toEqual([
      '/Water/copy2 /Water/copy2/piece1',
      '/Water/copy2 /Water/copy2/piece2',
    ]);
  });
});

describe('moved objects', () => {
  const object = makeObject({
    path: '/It',
    mesh,
    motion: { kind: 'static', pose: { position: [2, 0, 1], orientation: turn } },
  });
  const scene = makeScene({ name: 'it', objects: [object] });
  const at = (o: SceneObject, v: number, t: number) => vertexPosition(o, v, t, C);

  it('keep their positions in a circling frame of the given radius, speed and period', () => {
    const circle = {
      kind: 'circle',
      center: [1, 0, 0],
      axis: [0, 1, 0],
      radius: 4,
      rate: 1.5,
      facing: true,
      from: 1,
      to: 9,
    } as const;
    const frame = motionFromPath(circle, 5);
    const [carried] = applyRigidMotion(scene, '', frame, 'world').objects;
    const period = (2 * Math.PI) / circle.rate;
    for (const t of [1, 2.3, 3.9]) {
      const origin = poseAt(frame, t, C).position;
      expect(distance(origin, circle.center)).toBeCloseTo(4, 2);
      const speed = distance(poseAt(frame, t + 0.05, C).position, origin) / 0.05;
      expect(speed).toBeCloseTo(4 * circle.rate, 1);
      for (const v of [0, 7, 20]) {
        expectClose([...at(carried!, v, t)], at(carried!, v, t + period), 4e-3);
        // A body oriented along its path keeps its distance to the centre.
        expect(distance(at(carried!, v, t), circle.center)).toBeCloseTo(distance(at(carried!, v, 1), circle.center), 2);
      }
    }
  });

  it('spin about their axis: points on it are at rest, others move at ω r', () => {
    const frame = motionFromPath({ kind: 'spin', center: [2, 0, 1], axis: [0, 1, 0], rate: -2, from: 0, to: 5 }, 4);
    const [spun] = applyRigidMotion(scene, '', frame, 'world').objects;
    const p = (v: number, t: number) => sub(at(spun!, v, t), [2, 0, 1]);
    for (const v of [0, 5, 11, 23]) {
      const axial = cross([0, 1, 0], p(v, 2));
      const speed = scale(sub(p(v, 2.01), p(v, 1.99)), 1 / 0.02);
      expectClose([...speed], scale(axial, -2), 0.05);
      expect(p(v, 3)[1]).toBeCloseTo(p(v, 0)[1], 3);
    }
  });

  it('follow a path through all its points at constant speed', () => {
    const places: Vec3[] = [
      [0, 0, 0],
      [4, 0, 0],
      [4, 3, 0],
      [0, 3, 5],
    ];
    const frame = motionFromPath({ kind: 'path', points: places, facing: false, from: 2, to: 12 }, 1);
    const trail = Array.from({ length: 2001 }, (_, k) => poseAt(frame, 2 + k / 200, C).position);
    for (const place of places) expect(Math.min(...trail.map((x) => distance(x, place)))).toBeLessThan(0.02);
    const speeds = trail.slice(1).map((x, k) => 200 * distance(x, trail[k]!));
    expect(Math.max(...speeds) / Math.min(...speeds)).toBeLessThan(1.03);
    expectClose([...poseAt(frame, 99, C).position], [0, 3, 5], 1e-9);
  });

  it('with keyframes are at the keyed positions, and objects that already move are reported', () => {
    const keys = [
      { time: 0, position: [0, 0, 0] as Vec3, orientation: turn },
      { time: 2, position: [4, 0, 0] as Vec3, orientation: turn },
    ];
    const carried = applyRigidMotion(scene, '/It', keyframedMotion(keys), 'world');
    expectClose([...at(carried.objects[0]!, 3, 1)], add([2, 0, 0], rotate(turn, at(object, 3, 0))), 1e-12);
    expect(movingPaths(carried.objects, '')).toEqual(['/It']);
    expect(movingPaths(scene.objects, '')).toEqual([]);
  });
});

describe('finer meshes', () => {
  const area = ({ positions, indices }: Mesh) => {
    let sum = 0;
    for (let i = 0; i < indices.length; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => pointAt(positions, indices[i + k]!)) as [Vec3, Vec3, Vec3];
      sum += length(cross(sub(b, a), sub(c, a))) / 2;
    }
    return sum;
  };
  const deforming = makeObject({ path: '/It', mesh, motion: MOTIONS[3]! });

  it('of constant shape have the same area, four times the triangles per level, and deform alike', () => {
    const finer = midpointSubdivide(deforming, 2);
    expect(finer.mesh.indices.length).toBe(16 * mesh.indices.length);
    expect(finer.mesh.groups.reduce((n, { count }) => n + count, 0)).toBe(finer.mesh.indices.length);
    expect(area(finer.mesh)).toBeCloseTo(area(mesh), 4);
    for (const t of [0, 0.4, 1.7])
      for (let v = 0; v < mesh.positions.length / 3; v++)
        expectClose([...vertexPosition(finer, v, t, C)], vertexPosition(deforming, v, t, C), 1e-12);
  });

  it('that are smooth lie between the inscribed sphere and the mesh, and at each sample equal the refined shape of that sample', () => {
    const cage = sphere(1, { segments: 8, rings: 4 });
    const { mesh: round } = loopSubdivide(makeObject({ path: '/S', mesh: cage }), 2);
    const radii = Array.from({ length: round.positions.length / 3 }, (_, v) => length(pointAt(round.positions, v)));
    expect(Math.max(...radii)).toBeLessThan(1);
    expect(Math.min(...radii)).toBeGreaterThan(0.6);
    expect(round.indices.length).toBe(16 * cage.indices.length);
    const moving = loopSubdivide(deforming, 1);
    const still = loopSubdivide(makeObject({ path: '/S', mesh: { ...mesh, positions: points[1]! } }), 1);
    for (let v = 0; v < moving.mesh.positions.length / 3; v++)
      expectClose([...sub(vertexPosition(moving, v, 1, C), [5, 0, 0])], pointAt(still.mesh.positions, v), 1e-5);
  });
});

describe('copies', () => {
  const scene = makeScene({ name: 'it', objects: [makeObject({ path: '/It', mesh, motion: MOTIONS[1]! })] });

  it('in rows are spaced around the origin, share the mesh, and have unique names', () => {
    const rows = arrangeCopies(scene, gridPoses([2, 1, 3], [2, 9, 4]));
    expect(rows.objects).toHaveLength(6);
    expect(new Set(rows.objects.map(({ mesh: worn }) => worn)).size).toBe(1);
    expect(new Set(rows.objects.map(({ path }) => path)).size).toBe(6);
    const places = gridPoses([2, 1, 3], [2, 9, 4]).map(({ position }) => position);
    expect(places).toContainEqual([1, 0, -4]);
    expectClose([...places.reduce(add)], [0, 0, 0], 1e-12);
  });

  it('of copies have unique names too, below the same parent', () => {
    const paths = [2, 3, 2]
      .reduce((all, count) => arrangeCopies(all, gridPoses([count, 1, 1], [1, 1, 1])), scene)
      .objects.map(({ path }) => path);
    expect(new Set(paths).size).toBe(12);
    expect(paths.filter((path) => !path.startsWith('/It'))).toEqual([]);
    expect(paths.slice(0, 6)).toEqual([
      ...['/It', '/It/copy2'],
      ...['/It/copy3', '/It/copy2/copy2'],
      ...['/It/copy4', '/It/copy2/copy3'],
    ]);
  });

  it('on a circle have the given radius and equal spacing, each rotated with its angle', () => {
    const spots = ringPoses(5, 3, [0, 0, 1]);
    for (const [k, { position, orientation }] of spots.entries()) {
      expect(Math.hypot(position[0], position[1])).toBeCloseTo(3, 12);
      expect(position[2]).toBeCloseTo(0, 12);
      expectClose([...position], rotate(orientation, spots[0]!.position), 1e-12);
      expect(distance(position, spots[(k + 1) % 5]!.position)).toBeCloseTo(6 * Math.sin(Math.PI / 5), 12);
    }
  });
});
