import { workerData } from 'node:worker_threads';
import { serveTeam } from '../../dynamics/threads/teamHelper.ts';

/** Entry of a thread of a simulation; teamThreads.ts starts it with the task. */
serveTeam(workerData);
