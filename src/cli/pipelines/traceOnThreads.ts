import { availableParallelism } from 'node:os';
import { CancelledError } from '../../graph/evaluation/evaluator.ts';
import { queueTraces } from '../../nodes/trace.ts';
import { renderWithPool, tilesOf } from '../../reference/tracerPool.ts';
import { killWhenStopped } from '../files/outputFile.ts';
import { CliError, EXIT } from '../terminal/exitCodes.ts';
import { tracerPool } from './tracerPool.ts';

/** Draws what nodes of a project ask of the reference renderer, with all processors. */
export const traceOnThreads = queueTraces(async (scene, picture, { signal, progress }) => {
  const threads = Math.min(availableParallelism(), tilesOf(picture).length);
  const pool = tracerPool(scene, picture.settings.speedOfLight, { threads });
  const forget = killWhenStopped({ kill: () => pool.stop(new CliError(EXIT.cancelled, 'stopped')) });
  signal?.addEventListener('abort', () => pool.stop(new CancelledError()));
  try {
    const layers = await renderWithPool(pool, { ...picture, layers: ['beauty'] }, progress);
    return layers.get('beauty')!;
  } finally {
    forget();
    await pool.close();
  }
});
