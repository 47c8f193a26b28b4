import { availableParallelism } from 'node:os';
import { Worker } from 'node:worker_threads';
import type { TeamThreads } from '../../dynamics/threads/threadTeam.ts';

/** Threads of Node for simulations; they do not keep the process alive. */
export const teamThreads: TeamThreads = {
  count: availableParallelism(),
  start: (task) => new Worker(new URL('./teamWorker.js', import.meta.url), { workerData: task }).unref(),
};
