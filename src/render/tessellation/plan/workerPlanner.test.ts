import { describe, expect, it } from 'vitest';
import { fromAxisAngle, IDENTITY } from '../../../math/quat.ts';
import { properVelocity } from '../../../physics/lorentz/boost.ts';
import { makeObject, makeScene, restingAt } from '../../../scene/defaults.ts';
import { box, plane } from '../../../scene/mesh/primitives.ts';
import { makeBatches } from '../../geometry/batches.ts';
import { makeBody } from '../../geometry/bodies.ts';
import type { TessellationView } from '../criterion/tessellationView.ts';
import { PATCH_FLOATS } from '../patches/patch.ts';
import { type FramePlans, LocalPlanner, type PlannedPart } from './planner.ts';
import { type PlannerMessage, type PlannerReply, servePlans } from './planServer.ts';
import { WorkerPlanner } from './workerPlanner.ts';

const LOOK: TessellationView = {
  observation: { t: 0, position: [0, 1.5, 0], u: properVelocity([0, 0, -0.9]), c: 1, hypersurface: 'past-light-cone' },
  projection: { event: 'emission', place: 'apparent' },
  orientation: IDENTITY,
  frustum: { tanX: 1, tanY: 0.6, aspect: 1 / 0.6, center: [0, 0] },
  focal: 300,
  tolerance: 0.25,
  maxPatches: 2 ** 16,
};
const turned = (angle: number): TessellationView => ({ ...LOOK, orientation: fromAxisAngle([0, 1, 0], angle) });

function parts(needsFactors: boolean): readonly PlannedPart[] {
  const scene = makeScene({
    name: 'street',
    objects: [
      makeObject({ path: '/floor', mesh: plane(40, 40, 'Y'), motion: restingAt([0, 0, 0]) }),
      makeObject({ path: '/house', mesh: box([4, 6, 4]), motion: restingAt([5, 3, -12]) }),
    ],
  });
  const bodies = scene.objects.map((object, i) => makeBody(object, i + 1));
  return makeBatches(scene, bodies).map((batch) => ({ batch, needsFactors }));
}

/** A worker whose work is done when `work` is called; what is posted is copied, as to a real one. */
function lazyWorker() {
  const requests: PlannerMessage[] = [];
  let serve: ((event: MessageEvent<PlannerMessage>) => void) | undefined;
  const worker = {
    onmessage: undefined as ((event: MessageEvent<PlannerReply>) => void) | undefined,
    terminated: false,
    postMessage: (request: PlannerMessage) => requests.push(structuredClone(request)),
    terminate() {
      this.terminated = true;
    },
  };
  servePlans({
    addEventListener: (_, listener) => {
      serve = listener;
    },
    postMessage: (plans, { transfer }) =>
      worker.onmessage?.({ data: structuredClone(plans, { transfer }) } as MessageEvent<PlannerReply>),
  });
  const work = (): number => {
    const waiting = requests.splice(0);
    for (const data of waiting) serve?.({ data } as MessageEvent<PlannerMessage>);
    return waiting.length;
  };
  return { worker, work };
}

const open = (needsFactors = false) => {
  const { worker, work } = lazyWorker();
  let better = 0;
  const given = parts(needsFactors);
  const planner = new WorkerPlanner(given, worker as unknown as Worker, () => better++);
  const seen = given.map(() => true);
  return { planner, work, worker, local: new LocalPlanner(given), seen, betterCalls: () => better };
};

/** Copies: plans are valid until the next one only. */
const content = (plans: FramePlans) =>
  plans.map((plan) => plan && { leaves: Array.from(plan.patches), clusters: Array.from(plan.clusterStates) });
const leavesIn = (plans: FramePlans): Set<string> =>
  new Set(
    plans.flatMap((plan, i) =>
      Array.from({ length: plan?.count ?? 0 }, (_, k) =>
        [i, ...(plan?.patches.subarray(PATCH_FLOATS * k, PATCH_FLOATS * k + 7) ?? [])].join(' '),
      ),
    ),
  );

describe('plans from afar', () => {
  it('before the first answer it plans itself', () => {
    const { planner, local, seen } = open();
    const own = content(planner.plan({ viewIndex: 0, view: LOOK, visible: seen }));
    expect(own).toEqual(content(local.plan({ viewIndex: 0, view: LOOK, visible: seen })));
    expect(own[0]?.leaves.length).toBeGreaterThan(100);
  });

  it('an answer is of the same look, a margin wider: all leaves of the own plan are in it', () => {
    const { planner, work, local, seen } = open();
    planner.plan({ viewIndex: 0, view: LOOK, visible: seen });
    work();
    const far = leavesIn(planner.plan({ viewIndex: 0, view: LOOK, visible: seen }));
    const own = leavesIn(local.plan({ viewIndex: 0, view: LOOK, visible: seen }));
    expect(far.size).toBeGreaterThan(own.size);
    const missing = [...own].filter((leaf) => !far.has(leaf));
    // At its rim a wider picture asks for finer pieces.
    expect(missing.length / own.size).toBeLessThan(0.35);
  });

  it('what turns a little is drawn with the last answer, and told when a better one has come; then it is left in peace', () => {
    const { planner, work, seen, betterCalls } = open();
    planner.plan({ viewIndex: 0, view: LOOK, visible: seen });
    work();
    const before = planner.plan({ viewIndex: 0, view: LOOK, visible: seen });
    expect(planner.plan({ viewIndex: 0, view: turned(0.05), visible: seen })).toEqual(before);
    expect(betterCalls()).toBe(0);
    while (work() > 0) planner.plan({ viewIndex: 0, view: turned(0.05), visible: seen });
    const told = betterCalls();
    expect(told).toBeGreaterThan(0);
    expect(content(planner.plan({ viewIndex: 0, view: turned(0.05), visible: seen }))).not.toEqual(content(before));
    expect(work()).toBe(0);
    expect(betterCalls()).toBe(told);
  });

  it('what rests has, in the end, the very plan that it would have made itself', () => {
    const { planner, work, local, seen } = open();
    planner.plan({ viewIndex: 0, view: LOOK, visible: seen });
    work();
    const wide = content(planner.plan({ viewIndex: 0, view: LOOK, visible: seen }));
    work();
    const own = content(planner.plan({ viewIndex: 0, view: LOOK, visible: seen }));
    expect(own).toEqual(content(local.plan({ viewIndex: 0, view: LOOK, visible: seen })));
    expect(own).not.toEqual(wide);
    // What turns then still has the wide one.
    expect(content(planner.plan({ viewIndex: 0, view: turned(0.05), visible: seen }))).toEqual(wide);
  });

  it.each([
    ['turns away', turned(1)],
    ['is faster', { ...LOOK, observation: { ...LOOK.observation, u: properVelocity([0, 0, -0.99]) } }],
    ['zooms', { ...LOOK, focal: 600, frustum: { ...LOOK.frustum, tanX: 0.5, tanY: 0.3 } }],
    ['sees otherwise', { ...LOOK, projection: { event: 'emission', place: 'plain' } as const }],
  ])('what %s at once is planned at once', (_, look) => {
    const { planner, work, local, seen } = open();
    planner.plan({ viewIndex: 0, view: LOOK, visible: seen });
    work();
    expect(content(planner.plan({ viewIndex: 0, view: look, visible: seen }))).toEqual(
      content(local.plan({ viewIndex: 0, view: look, visible: seen })),
    );
  });

  it('a batch that is not seen has no plan, and has one as soon as it comes into the picture', () => {
    const { planner, work, seen } = open();
    planner.plan({ viewIndex: 0, view: LOOK, visible: seen.map(() => false) });
    work();
    expect(planner.plan({ viewIndex: 0, view: LOOK, visible: seen.map(() => false) })).toEqual(
      seen.map(() => undefined),
    );
    expect(planner.plan({ viewIndex: 0, view: LOOK, visible: seen })[0]?.count).toBeGreaterThan(0);
  });

  it('levels come with the leaves where they are wanted', () => {
    const { planner, work, seen } = open(true);
    planner.plan({ viewIndex: 0, view: LOOK, visible: seen });
    work();
    const [plan] = planner.plan({ viewIndex: 0, view: LOOK, visible: seen });
    expect(plan?.patchesByPattern?.reduce((sum, { count }) => sum + count, 0)).toBe(plan?.count);
  });

  it('two views of a picture have plans of their own, and the worker serves them in turn', () => {
    const { planner, work, local, seen } = open();
    const views = [LOOK, turned(1)];
    const drawBoth = () => views.map((view, viewIndex) => content(planner.plan({ viewIndex, view, visible: seen })));
    const own = views.map((view) => content(local.plan({ viewIndex: 0, view, visible: seen })));
    expect(drawBoth()).toEqual(own);
    // At first the wide plans of both, at rest their exact plans: four plans in all.
    let plans = 0;
    for (let served = work(); served > 0; served = work()) {
      plans += served;
      drawBoth();
    }
    // One message is the scene.
    expect(plans - 1).toBe(4);
    expect(drawBoth()).toEqual(own);
  });

  it('ends its worker', () => {
    const { planner, worker } = open();
    planner.dispose();
    expect(worker.terminated).toBe(true);
  });
});
