import { length } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import type { FrameTime } from '../../nodes/project/outputFiles.ts';
import { gamma, velocity } from '../../physics/lorentz/boost.ts';
import type { Scene } from '../../scene/types.ts';
import type { LensChoice } from '../../scene/view/lenses/lensChoice.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import { openSceneWithFlags } from '../flags/openScene.ts';
import { checkPipeline } from '../flags/pipelineFlags.ts';
import { isProject, openProjectJob, type RenderJob, refuseSets } from '../project/project.ts';
import { usageError } from '../terminal/exitCodes.ts';
import { toJson } from '../terminal/json.ts';
import { localized } from '../terminal/language.ts';
import { Progress } from '../terminal/progress.ts';
import { filmedFlight, flightFrames } from './flightFilm.ts';
import { checkOutput } from './frameSinks.ts';
import type { RenderFlags } from './renderFlags.ts';
import { chooseAovs, type RenderReport, renderFrames } from './renderFrames.ts';

export async function render(path: string, flags: RenderFlags, given: ReadonlySet<string>): Promise<void> {
  checkPipeline(flags);
  checkSamples(flags);
  checkOutput(flags);
  chooseAovs(flags);
  const progress = new Progress();
  progress.show(msg`reading …`);
  const flight = flags.flight === undefined ? undefined : filmedFlight(flags.flight, flags, given);
  const job = sized(await openJob(path, flags, given, progress), given);
  progress.clear();
  const frames = flight
    ? flightFrames(flight, job.flags, job.flags.fps ?? job.scene.timeCodesPerSecond)
    : frameTimes(job.scene, job.flags);
  report(job, await renderFrames(job, frames, progress, flight));
}

/** Opens a scene file or a project as a render job. */
async function openJob(
  path: string,
  flags: RenderFlags,
  given: ReadonlySet<string>,
  progress: Progress,
): Promise<RenderJob<RenderFlags>> {
  if (await isProject(path)) return openProjectJob(path, flags, given, progress.node);
  refuseSets(flags.set);
  return { scene: await openSceneWithFlags(path, flags), others: [], projectSettings: {}, flags };
}

/** Pictures of panoramic lenses have shapes of their own, which the usual size is not. */
function sized(job: RenderJob<RenderFlags>, given: ReadonlySet<string>): RenderJob<RenderFlags> {
  const size = given.has('size') ? undefined : PANORAMIC_SIZES[job.flags.lens ?? 'perspective'];
  return size ? { ...job, flags: { ...job.flags, size } } : job;
}

const PANORAMIC_SIZES: Partial<Record<LensChoice, PictureSize>> = {
  equirectangular: { width: 2048, height: 1024 },
  fisheye: { width: 1024, height: 1024 },
  dome: { width: 1024, height: 1024 },
  cube: { width: 1536, height: 1024 },
  'cube-strip': { width: 3072, height: 512 },
  stereo: { width: 2048, height: 2048 },
};

function checkSamples({ samples, antialiasing }: RenderFlags): void {
  if (samples !== undefined && !antialiasing)
    throw usageError(msg`--no-antialiasing takes one sample, at the centre of each pixel: leave it or --samples out`);
}

function frameTimes(scene: Scene, { time, frames, fps = scene.timeCodesPerSecond }: RenderFlags): FrameTime[] {
  if (!frames) return [{ t: time ?? scene.hints.openAt ?? scene.startTime }];
  const count = frames.last - frames.first + 1;
  return Array.from({ length: count }, (_, i) => ({ number: frames.first + i, t: (frames.first + i) / fps }));
}

function report({ scene, flags }: RenderJob<RenderFlags>, drawn: RenderReport): void {
  const { files, frames, first, last: end } = drawn;
  if (!flags.json) {
    const last = files.at(-1) ?? '';
    console.log(localized(files.length > 1 ? msg`${files.length} files, the last ${last}` : last));
    return;
  }
  const beta = velocity(first.u);
  const summary = {
    files,
    ...flags.size,
    frames: frames.length,
    times: [first.t, end.t],
    speedOfLight: drawn.speedOfLight,
    observer: { position: first.position, beta, speed: length(beta), gamma: gamma(first.u) },
    ...drawn.info,
    samples: drawn.samples,
    exposure: [drawn.exposures[0]!, drawn.exposures.at(-1)!],
    falseColours: drawn.falseColours,
    objects: scene.objects.map((object, i) => ({ id: i + 1, path: object.path })),
  };
  console.log(toJson(summary));
}
