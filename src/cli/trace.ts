import { availableParallelism } from 'node:os';
import { CancelledError } from '../graph/evaluate.ts';
import { inTurn } from '../nodes/trace.ts';
import { drawnBy, tilesOf } from '../reference/pool.ts';
import { CliError, EXIT } from './exit.ts';
import { stopWithUs } from './output.ts';
import { tracerPool } from './tracerPool.ts';

/** Draws what nodes of a project ask of the reference renderer, with all processors. */
export const traceHere = inTurn(async (scene, picture, { signal, progress }) => {
  const threads = Math.min(availableParallelism(), tilesOf(picture).length);
  const pool = tracerPool(scene, picture.settings.speedOfLight, { threads });
  const forget = stopWithUs({ kill: () => pool.stop(new CliError(EXIT.cancelled, 'stopped')) });
  signal?.addEventListener('abort', () => pool.stop(new CancelledError()));
  try {
    const layers = await drawnBy(pool, { ...picture, layers: ['beauty'] }, progress);
    return layers.get('beauty')!;
  } finally {
    forget();
    await pool.close();
  }
});
