import { InputError } from '../../../scene/types.ts';
import { type BatchPlan, type FramePlans, LocalPlanner, type PlannedPart, type PlanRequest } from './planner.ts';

/** What a worker that plans is told: a scene, once, then one look after another, each when the one before has been answered. */
export type PlannerMessage =
  | { readonly kind: 'scene'; readonly parts: readonly PlannedPart[] }
  | { readonly kind: 'plan'; readonly request: PlanRequest };
/** undefined where samples that are left in files could not be read: whoever draws them says so. */
export type PlannerReply = FramePlans | undefined;

/** The worker's side of a port, as far as it is needed here. */
interface WorkerPort {
  addEventListener(type: 'message', listener: (event: MessageEvent<PlannerMessage>) => void): void;
  postMessage(message: PlannerReply, options: { transfer: ArrayBuffer[] }): void;
}

/** Makes a worker plan pictures off the main thread, for `WorkerPlanner`. */
export function servePlans(port: WorkerPort): void {
  let planner: LocalPlanner | undefined;
  port.addEventListener('message', ({ data }) => {
    if (data.kind === 'scene') planner = new LocalPlanner(data.parts);
    else if (planner) answer(port, planner, data.request);
  });
}

function answer(port: WorkerPort, planner: LocalPlanner, request: PlanRequest): void {
  try {
    send(port, planner.plan(request));
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    port.postMessage(undefined, { transfer: [] });
  }
}

function send(port: WorkerPort, plans: FramePlans): void {
  const transfer: ArrayBuffer[] = [];
  // The planner's own lists are used again.
  const own = <T extends Float32Array | Uint8Array>(array: T): T => {
    const copy = array.slice() as T;
    transfer.push(copy.buffer as ArrayBuffer);
    return copy;
  };
  const copied = plans.map((plan): BatchPlan | undefined => {
    if (!plan) return undefined;
    const { patchesByPattern: levels, patches: leaves, clusterStates } = plan;
    if (!levels) return { ...plan, clusterStates: own(clusterStates), patches: own(leaves) };
    const lists = levels.map((list) => ({ count: list.count, patches: own(list.patches) }));
    return { ...plan, clusterStates: own(clusterStates), patches: new Float32Array(), patchesByPattern: lists };
  });
  port.postMessage(copied, { transfer });
}
