import { type Command, Option } from 'commander';
import { DEFAULT_LIGHT } from '../../reference/lights/lightOptions.ts';
import type { Backend } from '../../render/settings.ts';
import type { Solver } from '../../scene/settings/settings.ts';
import { usageError } from '../terminal/exitCodes.ts';
import { parseBounces, parseSeed, parseThreads } from './parse.ts';

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
  /** How it follows light; see `LightOptions` of reference/lights/lightingContext.ts. */
  readonly bounces?: number;
  readonly mirrors: boolean;
  readonly glass: boolean;
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
    )
    .option(
      '--bounces <n>',
      `of reference: how often light of the sky and of what glows is scattered on its way (default: ${DEFAULT_LIGHT.bounces})`,
      parseBounces,
    )
    .option('--no-mirrors', 'of reference: smooth surfaces mirror the sky and what glows, not each other')
    .option(
      '--glass',
      'of reference: closed transparent bodies refract light, by their material’s ior',
      DEFAULT_LIGHT.glass,
    );
}

/** Says so where flags do not go together, before any work is done. */
export function checkPipeline(flags: PipelineFlags & { readonly solver: Solver }): void {
  const { pipeline, backend, solver } = flags;
  const idle = unusedFlag(flags);
  if (idle) throw usageError(`${idle} is for the reference renderer: add --pipeline reference, or leave it out`);
  if (pipeline !== 'reference') return;
  const foreign = backend !== 'auto' ? `--backend ${backend}` : solver !== 'exact' ? `--solver ${solver}` : undefined;
  if (foreign) {
    throw usageError(
      `${foreign} is for the rasterizer; --pipeline reference needs no GPU and is always exact. Leave one of them out`,
    );
  }
}

/** A flag that only the reference renderer obeys. With `auto` it may come to that, but nothing that changes the picture may depend on the machine. */
function unusedFlag({ pipeline, threads, seed, bounces, mirrors, glass }: PipelineFlags): string | undefined {
  if (pipeline === 'reference') return undefined;
  if (bounces !== undefined) return '--bounces';
  if (!mirrors) return '--no-mirrors';
  if (glass) return '--glass';
  if (pipeline === 'auto') return undefined;
  if (threads !== undefined) return '--threads';
  return seed === undefined ? undefined : '--seed';
}
