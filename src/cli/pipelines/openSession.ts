import { anyOf, inLines, type Message, msg } from '../../messages/message.ts';
import { PictureTooLargeError } from '../../pipelines/maxSize.ts';
import { openSession } from '../../pipelines/openSession.ts';
import type { OptionValues } from '../../pipelines/options.ts';
import type { PictureScenes, Pipeline, PipelineSession, UncheckedRequest } from '../../pipelines/pipeline.ts';
import { AUTOMATIC_PIPELINES, pipelineNamed } from '../../pipelines/registry.ts';
import type { Backend } from '../../render/settings.ts';
import { killWhenStopped } from '../files/outputFile.ts';
import { foreignSetting, optionsOf } from '../flags/pipelineFlags.ts';
import { speedOfLight } from '../flags/viewFlags.ts';
import type { RenderFlags } from '../render/renderFlags.ts';
import { CliError, EXIT, unavailable } from '../terminal/exitCodes.ts';
import { nodeHost } from './nodeHost.ts';

/** Opens the named pipeline, or with `auto` the first on each of its backends in turn, then its fallbacks, unless a flag needs the first one. Throws if none works. */
export async function openFlaggedSession(
  scenes: PictureScenes,
  flags: RenderFlags,
  say: (text: Message) => void,
): Promise<PipelineSession> {
  const candidates = flags.pipeline === 'auto' ? AUTOMATIC_PIPELINES : [pipelineNamed(flags.pipeline)];
  const missing: Message[] = [];
  for (const [i, pipeline] of candidates.entries()) {
    if (i > 0) {
      if (foreignSetting(flags, pipeline)) break;
      const draws = msg`no usable GPU, so the ${pipeline.name} draws: ${pipeline.fallback ?? ''}.`;
      say(inLines([msg`slowlight: ${draws}`, ...missing]));
    }
    const session = await openOnBackend(pipeline, scenes, flags, missing);
    if (session) return stoppable(session);
  }
  const others = AUTOMATIC_PIPELINES.filter(({ backends }) => backends.length === 0).map(({ id }) => id);
  throw unavailable(inLines([...missing, msg`Without a GPU: --pipeline ${anyOf(others)}.`]));
}

/** Opens a pipeline on its first working backend, if it needs one; returns undefined, with the reasons in `missing`, if none works. */
async function openOnBackend(
  pipeline: Pipeline,
  scenes: PictureScenes,
  flags: RenderFlags,
  missing: Message[],
): Promise<PipelineSession | undefined> {
  const { size, backend } = flags;
  const request = {
    scenes,
    size,
    speedOfLight: speedOfLight(scenes[0], flags.c),
    options: optionsOf(pipeline, flags) satisfies OptionValues,
  };
  if (pipeline.backends.length === 0) return openSession(pipeline, request, nodeHost);
  for (const each of pipeline.backends.filter((own) => backend === 'auto' || own === backend)) {
    try {
      return await OPENERS[each](pipeline, request);
    } catch (error) {
      if (!isUnavailable(error)) throw error;
      missing.push(msg`${each}: ${error.text}`);
    }
  }
  return undefined;
}

/** Whether another backend may succeed. */
const isUnavailable = (error: unknown): error is PictureTooLargeError | CliError =>
  error instanceof PictureTooLargeError || (error instanceof CliError && error.exitCode === EXIT.unavailable);

const OPENERS: Record<Backend, (pipeline: Pipeline, request: UncheckedRequest) => Promise<PipelineSession>> = {
  webgpu: (pipeline, request) => openSession(pipeline, request, nodeHost),
  // Imported lazily: it needs a large library.
  webgl: async (pipeline, request) => (await import('./inChromium.ts')).openInChromium(pipeline, request),
};

/** Stops the session, if it can be stopped, when the program is. */
function stoppable(session: PipelineSession): PipelineSession {
  if (!session.stop) return session;
  const forget = killWhenStopped({ kill: () => session.stop?.(new CliError(EXIT.cancelled, msg`stopped`)) });
  return {
    ...session,
    close: () => {
      forget();
      return session.close();
    },
  };
}
