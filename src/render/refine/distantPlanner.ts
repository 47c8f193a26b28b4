import { distance } from '../../math/vec3.ts';
import { gamma } from '../../physics/boost.ts';
import { isStreamed } from '../../scene/points.ts';
import type { MovingBody } from '../bodies.ts';
import type { Look } from './look.ts';
import {
  type LevelledPlan,
  LocalPlanner,
  type PicturePlans,
  type PlannedPart,
  type Planner,
  type PlanOrder,
} from './planner.ts';
import type { PlannerReply, PlannerRequest } from './planServer.ts';
import { DRAWN } from './shown.ts';

/** What a worker plans is wider than the picture on all sides by this angle, for the picture turns while it is at work [rad]. */
const MARGIN = 0.2;
/** A plan for a look that is turned by more [rad] is not used, */
const MOST_TURN = 0.12;
/** nor for one that moves otherwise by a rapidity of more: directions turn by as much. */
const MOST_RAPIDITY = 0.05;
/** nor for one that is nearer or wider by more than this share. */
const MOST_ZOOM = 0.1;
/** Scenes with more are not copied to a worker [bytes]. */
const MOST_BYTES = 2 ** 28;

/**
 * Has plans made by a worker (planServer.ts) and hands out the last one that came, which is a picture or two old: every vertex is still where it is
 * seen now, only how finely edges are cut is of a moment ago. Plans itself where there is none for nearly the same look. A picture that rests gets a plan
 * of its own in the end, so that it is to the last bit what those see who plan while they draw.
 */
export class DistantPlanner implements Planner {
  private readonly worker: Worker;
  private readonly local: LocalPlanner;
  /** Batches whose samples are not in this thread. */
  private readonly streamed: readonly boolean[];
  private readonly better: () => void;
  private sent: PlanOrder | undefined;
  private exactly = false;
  private busy = false;
  /** For looks nearby. */
  private wide: { readonly look: Look; readonly plans: PicturePlans } | undefined;
  /** For one picture and no other. */
  private own: { readonly order: PlanOrder; readonly plans: PicturePlans } | undefined;
  /** A better plan than that of the last picture is on its way. */
  private waiting = false;

  /** `better` is called when a plan has come that fits the last picture better than the one it was drawn with. */
  constructor(parts: readonly PlannedPart[], worker: Worker, better: () => void) {
    this.worker = worker;
    this.better = better;
    this.local = new LocalPlanner(parts);
    this.streamed = parts.map(isLeftInFiles);
    worker.onmessage = ({ data }: MessageEvent<PlannerReply>) => this.receive(data);
    this.post({ kind: 'scene', parts: withoutMeshes(parts) });
  }

  plan(order: PlanOrder): PicturePlans {
    const { wide, own } = this;
    this.waiting = false;
    if (own && same(own.order, order)) return own.plans;
    const rests = wide !== undefined && same(wide.look, order.look);
    this.ask(rests ? order : { look: order.look, seen: order.seen.map(() => true) }, rests);
    const fits = wide !== undefined && nearly(wide.look, order.look);
    this.waiting = fits || this.streamed.includes(true);
    return fits ? wide.plans.map((plan, i) => (order.seen[i] ? plan : undefined)) : this.planHere(order);
  }

  starts(batch: number): Uint32Array {
    return this.local.starts(batch);
  }

  dispose(): void {
    this.worker.terminate();
  }

  /** What is streamed is drawn with its edges as they are, until the worker has cut them. */
  private planHere(order: PlanOrder): PicturePlans {
    const { streamed } = this;
    const plans = this.local.plan({ ...order, seen: order.seen.map((seen, i) => seen && !streamed[i]) });
    return plans.map((plan, i) => (order.seen[i] && streamed[i] ? this.uncut(i, order.look) : plan));
  }

  private uncut(batch: number, { tolerance }: Look): LevelledPlan {
    const clusters = new Uint8Array(this.starts(batch).length - 1).fill(DRAWN);
    return { whole: true, clusters, leaves: new Float32Array(0), count: 0, tolerance };
  }

  /** The wide plan is of all batches: others may have come into the picture when it is there. */
  private ask(order: PlanOrder, exactly: boolean): void {
    if (this.busy) return;
    this.busy = true;
    this.sent = order;
    this.exactly = exactly;
    this.post({ kind: 'plan', order: exactly ? order : { ...order, look: widened(order.look) } });
  }

  private receive(plans: PlannerReply): void {
    this.busy = false;
    if (!plans || !this.sent) return;
    if (this.exactly) this.own = { order: this.sent, plans };
    else this.wide = { look: this.sent.look, plans };
    if (this.waiting) this.better();
  }

  private post(request: PlannerRequest): void {
    this.worker.postMessage(request);
  }
}

const isLeftInFiles = ({ batch: { bodies } }: PlannedPart): boolean =>
  bodies.some(({ object: { motion } }) => motion.kind === 'sampled-points' && isStreamed(motion.points));

/** Whether a scene is small enough to be copied to a worker; what is left in files can only be planned there. */
export const canTravel = (parts: readonly PlannedPart[]): boolean => {
  if (parts.some(isLeftInFiles)) return true;
  const motions = parts.flatMap(({ batch }) => batch.bodies.map(({ object }) => object.motion));
  const points = new Set(
    motions.flatMap((motion) =>
      motion.kind === 'sampled-points' && !isStreamed(motion.points)
        ? [...motion.points, ...(motion.velocities ?? [])]
        : [],
    ),
  );
  const arrays = parts.flatMap(({ batch: { arrays } }) => [arrays.positions, arrays.indices, arrays.ids]);
  return [...points, ...arrays].reduce((sum, { byteLength }) => sum + byteLength, 0) <= MOST_BYTES;
};

/** What is shared stays so: two batches of one body have its samples once. */
function withoutMeshes(parts: readonly PlannedPart[]): readonly PlannedPart[] {
  return parts.map(({ levelled, batch: { transparent, doubleSided, worn, bodies, arrays } }) => {
    const { positions, indices, ids } = arrays;
    return {
      levelled,
      batch: {
        transparent,
        doubleSided,
        ...(worn && { worn }),
        bodies: bodies.map(bare),
        arrays: { positions, indices, ids },
      },
    };
  });
}

const bare = ({ id, object: { motion, authoredIn }, centre, radius, line }: MovingBody): MovingBody => ({
  id,
  object: { motion, authoredIn },
  centre,
  radius,
  line,
});

const widened = (look: Look): Look => ({ ...look, tanX: wider(look.tanX), tanY: wider(look.tanY) });
const wider = (tan: number): number => Math.tan(Math.min(1.5, Math.atan(tan) + MARGIN));

/** Plain data of numbers and short arrays: compared by its text. */
const same = (a: unknown, b: unknown): boolean => JSON.stringify(a) === JSON.stringify(b);

function nearly(from: Look, to: Look): boolean {
  return (
    same(fixed(from), fixed(to)) &&
    turn(from, to) < MOST_TURN &&
    distance(from.sight.u, to.sight.u) < MOST_RAPIDITY * gamma(to.sight.u) &&
    Math.abs(from.tanX / to.tanX - 1) < MOST_ZOOM &&
    Math.abs(from.focal / to.focal - 1) < MOST_ZOOM
  );
}

const fixed = ({ sight, projection, tolerance, budget }: Look) => [
  sight.surface,
  sight.c,
  projection,
  tolerance,
  budget,
];

/** The angle between two orientations [rad]. */
function turn({ orientation: p }: Look, { orientation: q }: Look): number {
  const cosine = Math.abs(p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3]);
  return 2 * Math.acos(Math.min(1, cosine));
}
