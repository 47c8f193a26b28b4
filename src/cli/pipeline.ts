import { type Command, Option } from 'commander';
import type { Backend } from '../render/settings.ts';
import type { Solver } from '../scene/view.ts';
import { usageError } from './exit.ts';
import { parseSeed, parseThreads } from './parse.ts';

/** What draws: the rasterizer, on a GPU; or the reference renderer, in 64-bit arithmetic on the processor. */
export type Pipeline = 'raster' | 'reference';

export interface PipelineFlags {
  readonly pipeline: Pipeline | 'auto';
  /** What the rasterizer draws with. */
  readonly backend: Backend | 'auto';
  /** Worker threads of the reference renderer. */
  readonly threads?: number;
  /** Of its random numbers. */
  readonly seed?: number;
}

const pipelines = ['auto', 'raster', 'reference'];
const backends = ['auto', 'webgpu', 'webgl'];

export function addPipelineFlags(command: Command): Command {
  const pipeline = new Option(
    '--pipeline <name>',
    'raster draws on a GPU; reference traces light in 64-bit arithmetic on the processor, and needs no GPU; auto: raster where it can',
  );
  const backend = new Option(
    '--backend <name>',
    'of raster: webgpu draws here; webgl in a headless Chromium; auto takes the first that works',
  );
  return command
    .addOption(pipeline.choices(pipelines).default('auto'))
    .addOption(backend.choices(backends).default('auto'))
    .option('--threads <n>', 'of reference: worker threads (default: as many as there are processors)', parseThreads)
    .option(
      '--seed <n>',
      'of reference: of its random numbers; the same seed gives the same bits (default: 0)',
      parseSeed,
    );
}

/** Says so where flags do not go together, before any work is done. */
export function checkPipeline({ pipeline, backend, solver, ...flags }: PipelineFlags & { solver: Solver }): void {
  if (pipeline === 'reference' && backend !== 'auto') {
    throw usageError(
      `--backend ${backend} is what the rasterizer draws with; --pipeline reference needs no GPU. Leave one of them out`,
    );
  }
  if (pipeline === 'reference' && solver !== 'exact') {
    throw usageError(
      `--solver ${solver} is the rasterizer's; --pipeline reference is always exact. Leave one of them out`,
    );
  }
  const idle = pipeline === 'raster' && (['threads', 'seed'] as const).find((name) => flags[name] !== undefined);
  if (idle) throw usageError(`--${idle} is for --pipeline reference; the rasterizer has no use for it`);
}
