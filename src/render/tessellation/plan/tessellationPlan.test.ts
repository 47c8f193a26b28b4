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

const LOOK: TessellationView = {
  observation: {
    t: 0.3,
    position: [0, 0.5, 0],
    u: properVelocity([0.2, 0, -0.9]),
    c: 1,
    hypersurface: 'past-light-cone',
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
): { plan: TessellationPlan; worn: boolean } {
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
  return { plan: new BatchPlanner(batches[0]).plan(LOOK), worn: batches[0].instancing !== undefined };
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
])('a mesh that many wear is cut for each of them as its copies are: they %s', (_, motion) => {
  const shared = planOf(() => pillar, motion);
  const copied = planOf(() => ({ ...pillar, positions: pillar.positions.slice() }), motion);
  expect([shared.worn, copied.worn]).toEqual([true, false]);
  // Copies are turned in f32 and measured by their own boxes, so that a cluster here and there falls otherwise.
  expect(Math.abs(shared.plan.count / copied.plan.count - 1)).toBeLessThan(0.02);
  expect(shared.plan.clusterStates).toHaveLength(copied.plan.clusterStates.length);
  const differ = shared.plan.clusterStates.filter((fate, k) => fate !== copied.plan.clusterStates[k]).length;
  expect(differ).toBeLessThan(0.05 * shared.plan.clusterStates.length);
  expect(shared.plan.clusterStates).toContain(TESSELLATED);
  expect(perBody(shared.plan, (leaves, at) => leaves[at + INSTANCE_OFFSET])).toEqual(
    perBody(copied.plan, (leaves, at) => Math.floor(leaves[at] / triangles)),
  );
});

/** Which bodies have leaves. */
function perBody(
  { patches: leaves, count }: TessellationPlan,
  bodyOf: (leaves: Float32Array, at: number) => number,
): number[] {
  const bodies = new Set(Array.from({ length: count }, (_, i) => bodyOf(leaves, PATCH_FLOATS * i)));
  return [...bodies].sort((a, b) => a - b);
}
