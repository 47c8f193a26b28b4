import { InputError } from '../../../scene/types.ts';
import { type BatchPlan, type FramePlans, LocalPlanner, type PlannedPart, type PlanRequest } from './planner.ts';

/** Messages to a planning worker: the scene once, then requests, each after the previous one has been answered. */
export type PlannerMessage =
  | { readonly kind: 'scene'; readonly parts: readonly PlannedPart[] }
  | { readonly kind: 'plan'; readonly request: PlanRequest };
/** undefined if streamed samples could not be read; the renderer reports that error when it reads them itself. */
export type PlannerReply = FramePlans | undefined;

/** The part of the worker's port that is used here. */
interface WorkerPort {
  addEventListener(type: 'message', listener: (event: MessageEvent<PlannerMessage>) => void): void;
  postMessage(message: PlannerReply, options: { transfer: ArrayBuffer[] }): void;
}

/** Serves plans from a worker, for `WorkerPlanner`. */
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
  // The planner reuses its lists, so copies are transferred.
  const own = <T extends Float32Array | Uint8Array>(array: T): T => {
    const copy = array.slice() as T;
    transfer.push(copy.buffer as ArrayBuffer);
    return copy;
  };
  const copied = plans.map((plan): BatchPlan | undefined => {
    if (!plan) return undefined;
    const { patchesByPattern, patches, clusterStates } = plan;
    if (!patchesByPattern) return { ...plan, clusterStates: own(clusterStates), patches: own(patches) };
    const lists = patchesByPattern.map((list) => ({ count: list.count, patches: own(list.patches) }));
    return { ...plan, clusterStates: own(clusterStates), patches: new Float32Array(), patchesByPattern: lists };
  });
  port.postMessage(copied, { transfer });
}
