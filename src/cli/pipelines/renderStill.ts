import { CancelledError } from '../../graph/evaluation/evaluator.ts';
import { msg } from '../../messages/message.ts';
import { lightOf, queueStills, stillRequest } from '../../nodes/still.ts';
import { openSession } from '../../pipelines/openSession.ts';
import { pipelineNamed } from '../../pipelines/registry.ts';
import { killWhenStopped, throwIfStopped } from '../files/outputFile.ts';
import { CliError, EXIT } from '../terminal/exitCodes.ts';
import { nodeHost } from './nodeHost.ts';

/** Draws the stills that nodes of a project request, one after the other. */
export const renderStill = queueStills(async (still, { signal, progress }) => {
  const session = await openSession(pipelineNamed(still.pipeline), stillRequest(still), nodeHost);
  const forget = killWhenStopped({ kill: () => session.stop?.(new CliError(EXIT.cancelled, msg`stopped`)) });
  signal?.addEventListener('abort', () => session.stop?.(new CancelledError()));
  try {
    // Signals during opening had no listener.
    throwIfStopped();
    if (signal?.aborted) throw new CancelledError();
    return await lightOf(session, still, progress);
  } finally {
    forget();
    await session.close();
  }
});
