import { expect, it } from 'vitest';
import { fromAxisAngle, IDENTITY } from '../../../math/quat.ts';
import { normalize, type Vec3 } from '../../../math/vec3.ts';
import { properVelocity } from '../../../physics/lorentz/boost.ts';
import { makeObject, makeScene } from '../../../scene/defaults.ts';
import { cylinder } from '../../../scene/mesh/primitives.ts';
import type { Mesh, Motion } from '../../../scene/types.ts';
import { makeBatches } from '../../geometry/batches.ts';
import { makeBody } from '../../geometry/bodies.ts';
import { TESSELLATED } from '../criterion/projectedBody.ts';
import type { TessellationView } from '../criterion/tessellationView.ts';
import { INSTANCE_OFFSET, PATCH_FLOATS } from '../patches/patch.ts';
import { BatchPlanner, type TessellationPlan } from './tessellationPlan.ts';

const VIEW: TessellationView = {
  observation: {
    t: 0.3,
    position: [0, 0.5, 0],
    u: properVelocity([0.2, 0, -0.9]),
    c: 1,
    hypersurface: 'past-light-cone',
    coneSlope: 1,
  },
  projection: { event: 'emission', place: 'apparent' },
  orientation: IDENTITY,
  frustum: { tanX: 1, tanY: 0.6, aspect: 1 / 0.6, center: [0, 0] },
  focal: 300,
  tolerance: 0.25,
  maxPatches: 2 ** 17,
};

const COUNT = 12;

function planOf(
  mesh: (i: number) => Mesh,
  motion: (place: Vec3, i: number) => Motion,
): { plan: TessellationPlan; isInstanced: boolean } {
  const objects = Array.from({ length: COUNT }, (_, i) => {
    const place: Vec3 = [3 * ((i % 4) - 1.5), 0, -2 - 8 * Math.floor(i / 4)];
    return makeObject({ path: `/${i}`, mesh: mesh(i), motion: motion(place, i) });
  });
  const scene = makeScene({ name: 'row', objects });
  const batches = makeBatches(
    scene,
    objects.map((object, i) => makeBody(object, i + 1)),
  );
  expect(batches).toHaveLength(1);
  return { plan: new BatchPlanner(batches[0]).plan(VIEW), isInstanced: batches[0].instancing !== undefined };
}

const pillar = cylinder(1, 4, { axis: 'Y', segments: 200 });
const triangles = pillar.indices.length / 3;
const turn = (i: number) => fromAxisAngle(normalize([1, i, 2]), i);

it.each<[string, (place: Vec3, i: number) => Motion]>([
  ['rest', (position, i) => ({ kind: 'static', pose: { position, orientation: turn(i) } })],
  ['fly', (position, i) => ({ kind: 'uniform', pose: { position, orientation: turn(i) }, velocity: [0.9, 0, 0] })],
  [
    'turn',
    ([x, y, z], i) => ({
      kind: 'sampled',
      times: Float64Array.of(-9, -4, 1),
      poses: Float64Array.of(x, y, z, ...turn(i), x, y, z, ...turn(i + 0.2), x + 1, y, z, ...turn(i + 0.4)),
    }),
  ],
])('an instanced mesh is tessellated for each body as a copy of it would be: bodies %s', (_, motion) => {
  const shared = planOf(() => pillar, motion);
  const copied = planOf(() => ({ ...pillar, positions: pillar.positions.slice() }), motion);
  expect([shared.isInstanced, copied.isInstanced]).toEqual([true, false]);
  // Copies are rotated in f32 and have bounding boxes of their own, so a few clusters get another state.
  expect(Math.abs(shared.plan.count / copied.plan.count - 1)).toBeLessThan(0.02);
  expect(shared.plan.clusterStates).toHaveLength(copied.plan.clusterStates.length);
  const differ = shared.plan.clusterStates.filter((state, k) => state !== copied.plan.clusterStates[k]).length;
  expect(differ).toBeLessThan(0.05 * shared.plan.clusterStates.length);
  expect(shared.plan.clusterStates).toContain(TESSELLATED);
  expect(perBody(shared.plan, (patches, at) => patches[at + INSTANCE_OFFSET])).toEqual(
    perBody(copied.plan, (patches, at) => Math.floor(patches[at] / triangles)),
  );
});

/** The bodies that have patches. */
function perBody(
  { patches, count }: TessellationPlan,
  bodyOf: (patches: Float32Array, at: number) => number,
): number[] {
  const bodies = new Set(Array.from({ length: count }, (_, i) => bodyOf(patches, PATCH_FLOATS * i)));
  return [...bodies].sort((a, b) => a - b);
}
