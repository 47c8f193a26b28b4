import { InputError } from '../../scene/types.ts';
import { type LevelledPlan, LocalPlanner, type PicturePlans, type PlannedPart, type PlanOrder } from './planner.ts';

/** What a worker that plans is told: a scene, once, then one look after another, each when the one before has been answered. */
export type PlannerRequest =
  | { readonly kind: 'scene'; readonly parts: readonly PlannedPart[] }
  | { readonly kind: 'plan'; readonly order: PlanOrder };
/** undefined where samples that are left in files could not be read: whoever draws them says so. */
export type PlannerReply = PicturePlans | undefined;

/** The worker's side of a port, as far as it is needed here. */
interface Port {
  addEventListener(type: 'message', listener: (event: MessageEvent<PlannerRequest>) => void): void;
  postMessage(message: PlannerReply, options: { transfer: ArrayBuffer[] }): void;
}

/** Makes a worker plan pictures off the main thread, for `DistantPlanner`. */
export function servePlans(port: Port): void {
  let planner: LocalPlanner | undefined;
  port.addEventListener('message', ({ data }) => {
    if (data.kind === 'scene') planner = new LocalPlanner(data.parts);
    else if (planner) answer(port, planner, data.order);
  });
}

function answer(port: Port, planner: LocalPlanner, order: PlanOrder): void {
  try {
    send(port, planner.plan(order));
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    port.postMessage(undefined, { transfer: [] });
  }
}

function send(port: Port, plans: PicturePlans): void {
  const transfer: ArrayBuffer[] = [];
  // The planner's own lists are used again.
  const own = <T extends Float32Array | Uint8Array>(array: T): T => {
    const copy = array.slice() as T;
    transfer.push(copy.buffer as ArrayBuffer);
    return copy;
  };
  const copied = plans.map((plan): LevelledPlan | undefined => {
    if (!plan) return undefined;
    const { levels, leaves, clusters } = plan;
    if (!levels) return { ...plan, clusters: own(clusters), leaves: own(leaves) };
    const lists = levels.map((list) => ({ count: list.count, leaves: own(list.leaves) }));
    return { ...plan, clusters: own(clusters), leaves: new Float32Array(), levels: lists };
  });
  port.postMessage(copied, { transfer });
}
