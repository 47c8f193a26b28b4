import type { Pipeline } from './pipeline.ts';
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
export const isInteractive = (pipeline: Pipeline): pipeline is InteractivePipeline =>
  pipeline.openInteractive !== undefined;

/** The first pipeline that draws frame by frame, which the page uses. */
export function interactivePipeline(): InteractivePipeline {
  const found = PIPELINES.find(isInteractive);
  if (!found) throw new Error('no pipeline draws frame by frame');
  return found;
}
