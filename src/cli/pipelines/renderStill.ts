import { CancelledError } from '../../graph/evaluation/evaluator.ts';
import { lightOf, queueStills, stillRequest } from '../../nodes/still.ts';
import { openSession, pipelineNamed } from '../../pipelines/registry.ts';
import { killWhenStopped, throwIfStopped } from '../files/outputFile.ts';
import { CliError, EXIT } from '../terminal/exitCodes.ts';
import { nodeHost } from './nodeHost.ts';

/** Draws the stills that nodes of a project ask for, with all processors. */
export const renderStill = queueStills(async (still, { signal, progress }) => {
  const session = await openSession(pipelineNamed(still.pipeline), stillRequest(still), nodeHost);
  const forget = killWhenStopped({ kill: () => session.stop?.(new CliError(EXIT.cancelled, 'stopped')) });
  signal?.addEventListener('abort', () => session.stop?.(new CancelledError()));
  try {
    // While it was being opened nobody heard that.
    throwIfStopped();
    if (signal?.aborted) throw new CancelledError();
    return await lightOf(session, still, progress);
  } finally {
    forget();
    await session.close();
  }
});
