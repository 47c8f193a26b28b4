import { msg } from '../messages/message.ts';
import { withFilms, withoutFilms } from './films.ts';
import type { PipelineHost } from './host.ts';
import { openOnGpu } from './interactiveSession.ts';
import { withDefaults } from './options.ts';
import { type Pipeline, PipelineRefusal, type PipelineSession, type UncheckedRequest } from './pipeline.ts';
import { rasterPipeline } from './raster.ts';
import { referencePipeline } from './reference.ts';

/** All pipelines, in the order in which they are tried and listed. A new one is added only here. */
export const PIPELINES: readonly [Pipeline, ...Pipeline[]] = [rasterPipeline, referencePipeline];

export function pipelineNamed(id: string): Pipeline {
  const found = PIPELINES.find((pipeline) => pipeline.id === id);
  if (!found) throw new Error(`there is no pipeline ${id}`);
  return found;
}

/** The pipelines of `--pipeline auto`: the first and its fallbacks. */
export const AUTOMATIC_PIPELINES: readonly Pipeline[] = PIPELINES.filter(
  (pipeline, i) => i === 0 || pipeline.fallback !== undefined,
);

type InteractivePipeline = Pipeline & Required<Pick<Pipeline, 'openInteractive'>>;
const isInteractive = (pipeline: Pipeline): pipeline is InteractivePipeline => pipeline.openInteractive !== undefined;

/** The first pipeline that draws frame by frame, which the page uses. */
export function interactivePipeline(): InteractivePipeline {
  const found = PIPELINES.find(isInteractive);
  if (!found) throw new Error('no pipeline draws frame by frame');
  return found;
}

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
