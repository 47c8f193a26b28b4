import { msg } from '../messages/message.ts';
import { withFilms, withoutFilms } from './films/withFilms.ts';
import type { PipelineHost } from './host.ts';
import { openOnGpu } from './interactiveSession.ts';
import { withDefaults } from './options.ts';
import { type Pipeline, PipelineRefusal, type PipelineSession, type UncheckedRequest } from './pipeline.ts';
import { isInteractive } from './registry.ts';

/** Opens a session; absent options have their defaults. */
export async function openSession(
  pipeline: Pipeline,
  { options, ...request }: UncheckedRequest,
  host: PipelineHost,
): Promise<PipelineSession> {
  const { scenes } = request;
  const session = await openUnlimited(pipeline, { options, ...request, scenes: withoutFilms(scenes) }, host);
  return withViewLimit(pipeline, withFilms(session, scenes, host.openFilm));
}

async function openUnlimited(
  pipeline: Pipeline,
  { options, ...request }: UncheckedRequest,
  host: PipelineHost,
): Promise<PipelineSession> {
  if (pipeline.open) return pipeline.open({ ...request, options: withDefaults(pipeline.options, options) }, host);
  if (!isInteractive(pipeline)) throw new Error(`pipeline ${pipeline.id} draws neither pictures nor frames`);
  return openOnGpu(pipeline, request, await host.openGpu());
}

/** Rejects pictures with more views than the pipeline draws. */
function withViewLimit({ name, maxViews }: Pipeline, session: PipelineSession): PipelineSession {
  return {
    ...session,
    render: async (request, onPart) => {
      const { length: count } = request.views;
      if (count > maxViews)
        throw new PipelineRefusal(
          msg`${count} views are more than the ${name} draws into one picture: up to ${maxViews}`,
        );
      return session.render(request, onPart);
    },
  };
}
