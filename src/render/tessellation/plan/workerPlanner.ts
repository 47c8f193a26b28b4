import { distance } from '../../../math/vec3.ts';
import { gamma } from '../../../physics/lorentz/boost.ts';
import { pointSamples } from '../../../scene/motion/motion.ts';
import { isStreamed } from '../../../scene/streaming/samplePoints.ts';
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

/** What a worker plans is wider than the picture on all sides by this angle, for the picture turns while it is at work [rad]. */
const MARGIN = 0.2;
/** A plan for a look that is turned by more [rad] is not used, */
const MAX_TURN = 0.12;
/** nor for one that moves otherwise by a rapidity of more: directions turn by as much. */
const MAX_RAPIDITY_CHANGE = 0.05;
/** nor for one that is nearer or wider by more than this share. */
const MAX_ZOOM_CHANGE = 0.1;
/** Scenes with more are not copied to a worker [bytes]. */
const MAX_SCENE_BYTES = 2 ** 28;

/**
 * Has plans made by a worker (planServer.ts) and hands out the last one that came, which is a picture or two old: every vertex is still where it is
 * seen now, only how finely edges are cut is of a moment ago. Plans itself where there is none for nearly the same look. A picture that rests gets a plan
 * of its own in the end, so that it is to the last bit what those see who plan while they draw.
 */
export class WorkerPlanner implements Planner {
  private readonly worker: Worker;
  private readonly local: LocalPlanner;
  /** Batches whose samples are not in this thread. */
  private readonly streamed: readonly boolean[];
  private readonly onBetterPlan: () => void;
  private sent: PlanRequest | undefined;
  private sentExact = false;
  private busy = false;
  /** For looks nearby. */
  private widePlan: { readonly look: TessellationView; readonly plans: FramePlans } | undefined;
  /** For one picture and no other. */
  private exactPlan: { readonly order: PlanRequest; readonly plans: FramePlans } | undefined;
  /** A better plan than that of the last picture is on its way. */
  private waiting = false;

  /** `better` is called when a plan has come that fits the last picture better than the one it was drawn with. */
  constructor(parts: readonly PlannedPart[], worker: Worker, better: () => void) {
    this.worker = worker;
    this.onBetterPlan = better;
    this.local = new LocalPlanner(parts);
    this.streamed = parts.map(isStreamedPart);
    worker.onmessage = ({ data }: MessageEvent<PlannerReply>) => this.receive(data);
    this.post({ kind: 'scene', parts: withoutMeshes(parts) });
  }

  plan(order: PlanRequest): FramePlans {
    const { widePlan, exactPlan } = this;
    this.waiting = false;
    if (exactPlan && isEqual(exactPlan.order, order)) return exactPlan.plans;
    const rests = widePlan !== undefined && isEqual(widePlan.look, order.view);
    this.request(rests ? order : { view: order.view, visible: order.visible.map(() => true) }, rests);
    const fits = widePlan !== undefined && isNearlyEqual(widePlan.look, order.view);
    this.waiting = fits || this.streamed.includes(true);
    return fits ? widePlan.plans.map((plan, i) => (order.visible[i] ? plan : undefined)) : this.planLocally(order);
  }

  starts(batch: number): Uint32Array {
    return this.local.starts(batch);
  }

  dispose(): void {
    this.worker.terminate();
  }

  /** What is streamed is drawn with its edges as they are, until the worker has cut them. */
  private planLocally(order: PlanRequest): FramePlans {
    const { streamed } = this;
    const plans = this.local.plan({ ...order, visible: order.visible.map((seen, i) => seen && !streamed[i]) });
    return plans.map((plan, i) => (order.visible[i] && streamed[i] ? this.uncut(i, order.view) : plan));
  }

  private uncut(batch: number, { tolerance }: TessellationView): BatchPlan {
    const clusters = new Uint8Array(this.starts(batch).length - 1).fill(DRAWN);
    return { allDrawn: true, clusterStates: clusters, patches: new Float32Array(0), count: 0, tolerance };
  }

  /** The wide plan is of all batches: others may have come into the picture when it is there. */
  private request(order: PlanRequest, exactly: boolean): void {
    if (this.busy) return;
    this.busy = true;
    this.sent = order;
    this.sentExact = exactly;
    this.post({ kind: 'plan', order: exactly ? order : { ...order, view: widened(order.view) } });
  }

  private receive(plans: PlannerReply): void {
    this.busy = false;
    if (!plans || !this.sent) return;
    if (this.sentExact) this.exactPlan = { order: this.sent, plans };
    else this.widePlan = { look: this.sent.view, plans };
    if (this.waiting) this.onBetterPlan();
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

/** Whether a scene is small enough to be copied to a worker; what is left in files can only be planned there. */
export const fitsWorker = (parts: readonly PlannedPart[]): boolean => {
  if (parts.some(isStreamedPart)) return true;
  const motions = parts.flatMap(({ batch }) => batch.bodies.map(({ object }) => object.motion));
  const points = new Set(
    motions.flatMap((motion) => {
      const samples = pointSamples(motion);
      return samples && !isStreamed(samples.points) ? [...samples.points, ...(samples.velocities ?? [])] : [];
    }),
  );
  const arrays = parts.flatMap(({ batch: { arrays } }) => [arrays.positions, arrays.indices, arrays.ids]);
  return [...points, ...arrays].reduce((sum, { byteLength }) => sum + byteLength, 0) <= MAX_SCENE_BYTES;
};

/** What is shared stays so: two batches of one body have its samples once. */
function withoutMeshes(parts: readonly PlannedPart[]): readonly PlannedPart[] {
  return parts.map(({ needsFactors, batch: { transparent, doubleSided, instancing: worn, bodies, arrays } }) => {
    const { positions, indices, ids } = arrays;
    return {
      needsFactors,
      batch: {
        transparent,
        doubleSided,
        ...(worn && { instancing: worn }),
        bodies: bodies.map(withoutMesh),
        arrays: { positions, indices, ids },
      },
    };
  });
}

const withoutMesh = ({ id, object: { motion, authoredIn }, center, radius, line }: MovingBody): MovingBody => ({
  id,
  object: { motion, authoredIn },
  center,
  radius,
  line,
});

const widened = (look: TessellationView): TessellationView => ({
  ...look,
  tanX: wider(look.tanX),
  tanY: wider(look.tanY),
});
const wider = (tan: number): number => Math.tan(Math.min(1.5, Math.atan(tan) + MARGIN));

/** Plain data of numbers and short arrays: compared by its text. */
const isEqual = (a: unknown, b: unknown): boolean => JSON.stringify(a) === JSON.stringify(b);

function isNearlyEqual(from: TessellationView, to: TessellationView): boolean {
  return (
    isEqual(exactPart(from), exactPart(to)) &&
    angleBetween(from, to) < MAX_TURN &&
    distance(from.observation.u, to.observation.u) < MAX_RAPIDITY_CHANGE * gamma(to.observation.u) &&
    Math.abs(from.tanX / to.tanX - 1) < MAX_ZOOM_CHANGE &&
    Math.abs(from.focal / to.focal - 1) < MAX_ZOOM_CHANGE
  );
}

const exactPart = ({ observation, projection, tolerance, maxPatches }: TessellationView) => [
  observation.hypersurface,
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
