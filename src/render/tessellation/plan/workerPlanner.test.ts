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

const VIEW: TessellationView = {
  observation: {
    t: 0,
    position: [0, 1.5, 0],
    u: properVelocity([0, 0, -0.9]),
    c: 1,
    hypersurface: 'past-light-cone',
    coneSlope: 1,
  },
  projection: { event: 'emission', place: 'apparent' },
  orientation: IDENTITY,
  frustum: { tanX: 1, tanY: 0.6, aspect: 1 / 0.6, center: [0, 0] },
  focal: 300,
  tolerance: 0.25,
  maxPatches: 2 ** 16,
};
const turned = (angle: number): TessellationView => ({ ...VIEW, orientation: fromAxisAngle([0, 1, 0], angle) });

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

/** A worker that handles its messages when `work` is called, which returns their number; messages are copied as for a real worker. */
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
  const visible = given.map(() => true);
  return { planner, work, worker, local: new LocalPlanner(given), visible, betterCalls: () => better };
};

/** Copies of the plans, which are valid only until the next call. */
const content = (plans: FramePlans) =>
  plans.map((plan) => plan && { patches: Array.from(plan.patches), clusters: Array.from(plan.clusterStates) });
const patchesIn = (plans: FramePlans): Set<string> =>
  new Set(
    plans.flatMap((plan, i) =>
      Array.from({ length: plan?.count ?? 0 }, (_, k) =>
        [i, ...(plan?.patches.subarray(PATCH_FLOATS * k, PATCH_FLOATS * k + 7) ?? [])].join(' '),
      ),
    ),
  );

describe('plans made by a worker', () => {
  it('plans locally before the first reply', () => {
    const { planner, local, visible } = open();
    const own = content(planner.plan({ viewIndex: 0, view: VIEW, visible }));
    expect(own).toEqual(content(local.plan({ viewIndex: 0, view: VIEW, visible })));
    expect(own[0]?.patches.length).toBeGreaterThan(100);
  });

  it('a reply is of the same view with a margin: most patches of the local plan are in it', () => {
    const { planner, work, local, visible } = open();
    planner.plan({ viewIndex: 0, view: VIEW, visible });
    work();
    const wide = patchesIn(planner.plan({ viewIndex: 0, view: VIEW, visible }));
    const own = patchesIn(local.plan({ viewIndex: 0, view: VIEW, visible }));
    expect(wide.size).toBeGreaterThan(own.size);
    const missing = [...own].filter((patch) => !wide.has(patch));
    // Near its corners a wider view needs finer patches.
    expect(missing.length / own.size).toBeLessThan(0.35);
  });

  it('a slightly turned view uses the last reply, is notified once a better one has arrived, and then no more', () => {
    const { planner, work, visible, betterCalls } = open();
    planner.plan({ viewIndex: 0, view: VIEW, visible });
    work();
    const before = planner.plan({ viewIndex: 0, view: VIEW, visible });
    expect(planner.plan({ viewIndex: 0, view: turned(0.05), visible })).toEqual(before);
    expect(betterCalls()).toBe(0);
    while (work() > 0) planner.plan({ viewIndex: 0, view: turned(0.05), visible });
    const notified = betterCalls();
    expect(notified).toBeGreaterThan(0);
    expect(content(planner.plan({ viewIndex: 0, view: turned(0.05), visible }))).not.toEqual(content(before));
    expect(work()).toBe(0);
    expect(betterCalls()).toBe(notified);
  });

  it('a view at rest finally gets exactly the plan that it would have made locally', () => {
    const { planner, work, local, visible } = open();
    planner.plan({ viewIndex: 0, view: VIEW, visible });
    work();
    const wide = content(planner.plan({ viewIndex: 0, view: VIEW, visible }));
    work();
    const own = content(planner.plan({ viewIndex: 0, view: VIEW, visible }));
    expect(own).toEqual(content(local.plan({ viewIndex: 0, view: VIEW, visible })));
    expect(own).not.toEqual(wide);
    // A view that then turns still uses the wide plan.
    expect(content(planner.plan({ viewIndex: 0, view: turned(0.05), visible }))).toEqual(wide);
  });

  it.each([
    ['turns away', turned(1)],
    ['speeds up', { ...VIEW, observation: { ...VIEW.observation, u: properVelocity([0, 0, -0.99]) } }],
    ['zooms', { ...VIEW, focal: 600, frustum: { ...VIEW.frustum, tanX: 0.5, tanY: 0.3 } }],
    ['changes projection', { ...VIEW, projection: { event: 'emission', place: 'plain' } as const }],
  ])('a view that %s abruptly is planned locally', (_, view) => {
    const { planner, work, local, visible } = open();
    planner.plan({ viewIndex: 0, view: VIEW, visible });
    work();
    expect(content(planner.plan({ viewIndex: 0, view, visible }))).toEqual(
      content(local.plan({ viewIndex: 0, view, visible })),
    );
  });

  it('an invisible batch has no plan, and gets one as soon as it becomes visible', () => {
    const { planner, work, visible } = open();
    planner.plan({ viewIndex: 0, view: VIEW, visible: visible.map(() => false) });
    work();
    expect(planner.plan({ viewIndex: 0, view: VIEW, visible: visible.map(() => false) })).toEqual(
      visible.map(() => undefined),
    );
    expect(planner.plan({ viewIndex: 0, view: VIEW, visible })[0]?.count).toBeGreaterThan(0);
  });

  it('factors come with the patches if they are needed', () => {
    const { planner, work, visible } = open(true);
    planner.plan({ viewIndex: 0, view: VIEW, visible });
    work();
    const [plan] = planner.plan({ viewIndex: 0, view: VIEW, visible });
    expect(plan?.patchesByPattern?.reduce((sum, { count }) => sum + count, 0)).toBe(plan?.count);
  });

  it('two views of a picture have plans of their own, and the worker serves them in turn', () => {
    const { planner, work, local, visible } = open();
    const views = [VIEW, turned(1)];
    const drawBoth = () => views.map((view, viewIndex) => content(planner.plan({ viewIndex, view, visible })));
    const own = views.map((view) => content(local.plan({ viewIndex: 0, view, visible })));
    expect(drawBoth()).toEqual(own);
    // First the wide plans of both views, then their exact plans: four in all.
    let plans = 0;
    for (let served = work(); served > 0; served = work()) {
      plans += served;
      drawBoth();
    }
    // The first message is the scene.
    expect(plans - 1).toBe(4);
    expect(drawBoth()).toEqual(own);
  });

  it('ends its worker', () => {
    const { planner, worker } = open();
    planner.dispose();
    expect(worker.terminated).toBe(true);
  });
});
