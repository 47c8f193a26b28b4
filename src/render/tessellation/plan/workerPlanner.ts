import { distance } from '../../../math/vec3.ts';
import { gamma } from '../../../physics/lorentz/boost.ts';
import { pointSamples } from '../../../scene/motion/motion.ts';
import { isListed, isStreamed } from '../../../scene/streaming/samplePoints.ts';
import type { SampledPointsMotion } from '../../../scene/types.ts';
import type { Frustum } from '../../../scene/view/lenses/perspectiveLens.ts';
import type { MovingBody } from '../../geometry/bodies.ts';
import { DRAWN } from '../criterion/projectedBody.ts';
import type { TessellationView } from '../criterion/tessellationView.ts';
import {
  type BatchPlan,
  type FramePlans,
  LocalPlanner,
  type PlannedPart,
  type Planner,
  type PlanRequest,
} from './planner.ts';
import type { PlannerMessage, PlannerReply } from './planServer.ts';

/** A worker plans for a frustum wider by this angle on all sides, because the view turns meanwhile [rad]. */
const MARGIN = 0.2;
/** A plan is not used for views turned or shifted relative to its own by more than this [rad], */
const MAX_TURN = 0.12;
/** nor for views whose velocity differs by more than this rapidity, which bounds the change of directions by aberration, */
const MAX_RAPIDITY_CHANGE = 0.05;
/** nor for views zoomed by more than this fraction. */
const MAX_ZOOM_CHANGE = 0.1;
/** Larger scenes are not copied to a worker [bytes]. */
const MAX_SCENE_BYTES = 2 ** 28;

/** A request, and whether its plan is exact: for this view only. */
interface PlanTask {
  readonly request: PlanRequest & { readonly viewIndex: number };
  readonly exact: boolean;
}

/** The plans of one of a picture's views. */
interface ViewPlans {
  /** A plan with a margin, for nearby views. */
  wide?: { readonly view: TessellationView; readonly plans: FramePlans };
  /** A plan for one view only. */
  exact?: { readonly request: PlanRequest; readonly plans: FramePlans };
  /** Whether a better plan than the last one returned is being made. */
  awaitsBetter: boolean;
  /** The next task of this view, if the worker was busy with another view. */
  queued?: PlanTask;
}

/**
 * Has plans made by a worker (planServer.ts) and returns the latest one, which is a picture or two old: vertices are still drawn at their current positions,
 * only the tessellation is that of a moment ago. Plans locally while there is no plan for a nearby view. A view at rest finally gets an exact plan, and then
 * equals a locally planned picture to the bit.
 */
export class WorkerPlanner implements Planner {
  private readonly worker: Worker;
  private readonly local: LocalPlanner;
  /** By batch: whether its samples are streamed and therefore not available on this thread. */
  private readonly streamed: readonly boolean[];
  private readonly onBetterPlan: () => void;
  private readonly views: ViewPlans[] = [];
  /** The task that the worker is busy with. */
  private sent: PlanTask | undefined;

  /** `onBetterPlan` is called when a plan has arrived that fits the last picture better than the one it was drawn with. */
  constructor(parts: readonly PlannedPart[], worker: Worker, onBetterPlan: () => void) {
    this.worker = worker;
    this.onBetterPlan = onBetterPlan;
    this.local = new LocalPlanner(parts);
    this.streamed = parts.map(isStreamedPart);
    worker.onmessage = ({ data }: MessageEvent<PlannerReply>) => this.receive(data);
    this.post({ kind: 'scene', parts: withoutMeshes(parts) });
  }

  plan(request: PlanRequest): FramePlans {
    const { view, visible, viewIndex } = request;
    if (viewIndex === undefined) return this.planLocally(request);
    const state = this.plansOf(viewIndex);
    const { wide, exact } = state;
    state.awaitsBetter = false;
    const kept = { ...request, viewIndex };
    if (exact && isEqual(exact.request, kept)) return exact.plans;
    const isAtRest = wide !== undefined && isEqual(wide.view, view);
    // A wide plan includes all batches, because others may be visible when it arrives.
    const task = isAtRest ? kept : { viewIndex, view, visible: visible.map(() => true) };
    this.enqueue({ request: task, exact: isAtRest }, state);
    const fits = wide !== undefined && isNearlyEqual(wide.view, view);
    state.awaitsBetter = fits || this.streamed.includes(true);
    return fits ? wide.plans.map((plan, i) => (visible[i] ? plan : undefined)) : this.planLocally(request);
  }

  starts(batch: number): Uint32Array {
    return this.local.starts(batch);
  }

  awaitsBetter(viewIndex: number): boolean {
    return this.plansOf(viewIndex).awaitsBetter;
  }

  dispose(): void {
    this.worker.terminate();
  }

  private plansOf(viewIndex: number): ViewPlans {
    this.views[viewIndex] ??= { awaitsBetter: false };
    return this.views[viewIndex];
  }

  /** Streamed batches are drawn without tessellation until the worker has planned them. */
  private planLocally(request: PlanRequest): FramePlans {
    const { streamed } = this;
    const plans = this.local.plan({
      ...request,
      visible: request.visible.map((visible, i) => visible && !streamed[i]),
    });
    return plans.map((plan, i) => (request.visible[i] && streamed[i] ? this.untessellated(i, request.view) : plan));
  }

  private untessellated(batch: number, { tolerance }: TessellationView): BatchPlan {
    const clusters = new Uint8Array(this.starts(batch).length - 1).fill(DRAWN);
    return { allDrawn: true, clusterStates: clusters, patches: new Float32Array(0), count: 0, tolerance };
  }

  /** While the worker is busy with a view, newer requests of that view are dropped: its next picture sends another. */
  private enqueue(task: PlanTask, state: ViewPlans): void {
    if (!this.sent) this.send(task, state);
    else if (this.sent.request.viewIndex !== task.request.viewIndex) state.queued = task;
  }

  private send(task: PlanTask, state: ViewPlans): void {
    const { request, exact } = task;
    this.sent = task;
    delete state.queued;
    this.post({ kind: 'plan', request: exact ? request : { ...request, view: widened(request.view) } });
  }

  private receive(plans: PlannerReply): void {
    const { sent } = this;
    this.sent = undefined;
    if (!sent) return;
    const { request, exact } = sent;
    const state = this.plansOf(request.viewIndex);
    if (plans && exact) state.exact = { request, plans };
    else if (plans) state.wide = { view: request.view, plans };
    const next = this.views.find((other) => other?.queued);
    if (next?.queued) this.send(next.queued, next);
    if (plans && state.awaitsBetter) this.onBetterPlan();
  }

  private post(request: PlannerMessage): void {
    this.worker.postMessage(request);
  }
}

const isStreamedPart = ({ batch: { bodies } }: PlannedPart): boolean =>
  bodies.some(({ object: { motion } }) => {
    const samples = pointSamples(motion);
    return samples !== undefined && isStreamed(samples.points);
  });

/** Whether a scene is small enough to be copied to a worker. Always true if samples are streamed, which only a worker can plan. */
export const fitsWorker = (parts: readonly PlannedPart[]): boolean => {
  if (parts.some(isStreamedPart)) return true;
  const motions = parts.flatMap(({ batch }) => batch.bodies.map(({ object }) => object.motion));
  const points = new Set(
    motions.flatMap((motion) => {
      const samples = pointSamples(motion);
      return samples ? arraysOf(samples) : [];
    }),
  );
  const arrays = parts.flatMap(({ batch: { arrays } }) => [arrays.positions, arrays.indices, arrays.ids]);
  return [...points, ...arrays].reduce((sum, { byteLength }) => sum + byteLength, 0) <= MAX_SCENE_BYTES;
};

/** The arrays of its samples that are copied with it; those of a skin are shared by its meshes. */
function arraysOf({ points, velocities = [] }: SampledPointsMotion): readonly (Float32Array | Float64Array)[] {
  if (isStreamed(points)) return [];
  if (isListed(points)) return [...points, ...velocities];
  const { poses, weights, rest, shapes, shapeWeights } = points;
  return [
    poses.matrices,
    weights,
    shapeWeights,
    ...[rest, ...shapes].flatMap((each) => [each.positions, each.normals]),
  ];
}

/** Parts without the data that planning does not read. Shared objects stay shared, so samples used by two batches are copied once. */
function withoutMeshes(parts: readonly PlannedPart[]): readonly PlannedPart[] {
  return parts.map(({ needsFactors, batch: { transparent, doubleSided, instancing, solids, bodies, arrays } }) => {
    const { positions, indices, ids } = arrays;
    return {
      needsFactors,
      batch: {
        transparent,
        doubleSided,
        ...(instancing && { instancing }),
        ...(solids && { solids }),
        bodies: bodies.map(withoutMesh),
        arrays: { positions, indices, ids },
      },
    };
  });
}

const withoutMesh = ({
  id,
  object: { motion, authoredIn, stretch },
  center,
  radius,
  line,
}: MovingBody): MovingBody => ({
  id,
  object: { motion, authoredIn, ...(stretch && { stretch }) },
  center,
  radius,
  line,
});

const widened = (view: TessellationView): TessellationView => ({ ...view, frustum: widenedFrustum(view.frustum) });

function widenedFrustum({ tanX, tanY, center: [x, y] }: Frustum): Frustum {
  const [right, left] = [wider(x + tanX), wider(tanX - x)];
  const [top, bottom] = [wider(y + tanY), wider(tanY - y)];
  const [halfWidth, halfHeight] = [(right + left) / 2, (top + bottom) / 2];
  return {
    tanX: halfWidth,
    tanY: halfHeight,
    aspect: halfWidth / halfHeight,
    center: [(right - left) / 2, (top - bottom) / 2],
  };
}

const wider = (tan: number): number => Math.tan(Math.min(1.5, Math.atan(tan) + MARGIN));

/** Compares plain data by its JSON. */
const isEqual = (a: unknown, b: unknown): boolean => JSON.stringify(a) === JSON.stringify(b);

function isNearlyEqual(from: TessellationView, to: TessellationView): boolean {
  return (
    isEqual(exactPart(from), exactPart(to)) &&
    angleBetween(from, to) < MAX_TURN &&
    distance(from.observation.u, to.observation.u) < MAX_RAPIDITY_CHANGE * gamma(to.observation.u) &&
    Math.abs(from.frustum.tanX / to.frustum.tanX - 1) < MAX_ZOOM_CHANGE &&
    Math.abs(from.focal / to.focal - 1) < MAX_ZOOM_CHANGE &&
    Math.abs(from.frustum.center[0] - to.frustum.center[0]) < MAX_TURN &&
    Math.abs(from.frustum.center[1] - to.frustum.center[1]) < MAX_TURN
  );
}

const exactPart = ({ observation, projection, vantage, tolerance, maxPatches }: TessellationView) => [
  vantage !== undefined,
  observation.hypersurface,
  observation.coneSlope,
  observation.c,
  projection,
  tolerance,
  maxPatches,
];

/** The angle between two orientations [rad]. */
function angleBetween({ orientation: p }: TessellationView, { orientation: q }: TessellationView): number {
  const cosine = Math.abs(p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3]);
  return 2 * Math.acos(Math.min(1, cosine));
}
