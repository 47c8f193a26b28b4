import { extname } from 'node:path';
import { msg } from '../../messages/message.ts';
import { flightPath } from '../../nodes/flights/flightPath.ts';
import { FASTER_THAN_PICTURES, isFasterThanPictures } from '../../nodes/flights/pictureLimit.ts';
import { spacedFrames } from '../../nodes/pictures/frameSpacing.ts';
import { outputSize, type PictureSequence, renderPictureSequence } from '../../nodes/pictures/sequence.ts';
import type { FrameTime } from '../../nodes/project/outputFiles.ts';
import type { PictureRenderer } from '../../pipelines/pictureRenderer.ts';
import type { PipelineSession } from '../../pipelines/pipeline.ts';
import { pipelineNamed } from '../../pipelines/registry.ts';
import { assertLensEffects } from '../../scene/frameGraph/lensEffects.ts';
import { sampleTimes } from '../../scene/motion/motion.ts';
import { validate } from '../../scene/validation/validate.ts';
import { assertLensShape } from '../../scene/view/lenses/lensChoice.ts';
import { type ObserverSetup, observerPathFrom, ridesCamera } from '../../scene/view/observerPath.ts';
import type { PictureViews } from '../../scene/view/pictureViews.ts';
import type { AovName, ViewPoint } from '../../scene/view/view.ts';
import type { FalseColorScale } from '../../spectrum/falseColor/falseColor.ts';
import { throwIfStopped } from '../files/outputFile.ts';
import { observerSetup } from '../flags/observerPath.ts';
import { checkPipeline } from '../flags/pipelineFlags.ts';
import { renderSettings, speedOfLight } from '../flags/viewFlags.ts';
import { openFlaggedSession } from '../pipelines/openSession.ts';
import type { RenderJob } from '../project/project.ts';
import { reportDiagnostics, reportOmissions } from '../terminal/diagnostics.ts';
import { orRefuse, usageError } from '../terminal/exitCodes.ts';
import type { Progress } from '../terminal/progress.ts';
import type { FilmedFlight } from './flightFilm.ts';
import { type FrameSink, openFrameSink } from './frameSinks.ts';
import type { RenderFlags } from './renderFlags.ts';

export interface RenderReport {
  readonly files: readonly string[];
  readonly frames: readonly FrameTime[];
  readonly first: ViewPoint;
  readonly last: ViewPoint;
  readonly info: PipelineSession['info'];
  readonly samples: number;
  /** [m/s] */
  readonly speedOfLight: number;
  /** Per frame [EV]. */
  readonly exposures: readonly number[];
  readonly falseColours?: FalseColorScale;
}

/** Renders frames and writes them to the output; unfinished files are removed on errors. */
export async function renderFrames(
  { scene, others, projectSettings, flags }: RenderJob<RenderFlags>,
  instants: readonly FrameTime[],
  progress: Progress,
  flight?: FilmedFlight,
): Promise<RenderReport> {
  checkPipeline(flags);
  const aovs = chooseAovs(flags);
  checkFalseColors(flags, aovs);
  const c = flight?.speedOfLight ?? speedOfLight(scene, flags.c);
  reportDiagnostics([...scene.diagnostics, ...validate(scene, c)]);
  reportOmissions(scene.diagnostics);
  const { size, metering, falseColour, falseRange, legend } = flags;
  const setup = observerSetup(scene, flags, c, instants[0]!.t);
  const spaced = () => spacedFrames(instants, flags.spacing ?? 'world', setup, c);
  const frames = flight ? instants : orRefuse(spaced, usageError);
  if (!flight) noteCourse(setup, progress);
  else if (frames.some(({ t }) => isFasterThanPictures(flight.playback.stateAt(t))))
    progress.note(FASTER_THAN_PICTURES);
  const standing = observerPathFrom(setup, c, frames[0]!.t);
  const { lens } = standing(frames[0]!.t);
  orRefuse(() => assertLensShape(lens, size), usageError);
  const { frameGraph, outside } = projectSettings;
  if (frameGraph && !outside) orRefuse(() => assertLensEffects(lens, frameGraph), usageError);
  const observer = flight ? flightPath(flight.playback, standing(scene.startTime).lens) : standing;
  const settings = { ...renderSettings(flags, c), ...projectSettings };
  const views = (t: number): PictureViews => [observer(t)];
  const request = { settings, metering, size, aovs, views, frames, falseColour, falseRange, legend };
  const sink = await openFrameSink({ ...flags, size: outputSize(request) }, scene);
  try {
    progress.show(msg`getting ready to draw …`);
    const session = await openFlaggedSession([scene, ...others], flags, (text) => progress.note(text));
    const { info } = session;
    const samples = flags.samples ?? (flags.antialiasing ? pipelineNamed(info.pipeline).samples.default : 1);
    const made = await renderIntoSink(session, { ...request, samples }, sink, progress).finally(() => session.close());
    throwIfStopped();
    progress.show(msg`finishing …`);
    await sink.finish();
    const { files } = sink;
    const [first, last] = [observer(frames[0]!.t), observer(frames.at(-1)!.t)];
    return { files, frames, first, last, info, samples, speedOfLight: c, ...made };
  } finally {
    progress.clear();
    sink.discard();
  }
}

/** A path that is this near to the file's is the same [m]. */
const MIN_TOLD_STRAY = 1e-6;

/** Says that the camera's path is not the file's to the letter. */
function noteCourse(setup: ObserverSetup, progress: Progress): void {
  const { path, motion, course } = setup.camera;
  if (!course || !ridesCamera(setup)) return;
  const samples = sampleTimes(motion)?.length ?? 0;
  const strayed = `${Number(course.strayed.toPrecision(2))} m`;
  if (course.strayed > MIN_TOLD_STRAY)
    progress.note(
      msg`${path}: a smooth path through its ${samples} samples, up to ${strayed} beside the straight lines between them (--camera-path straight)`,
    );
  const jumps = `${course.jumps
    .slice(0, 3)
    .map((t) => `${t} s`)
    .join(', ')}${course.jumps.length > 3 ? ', …' : ''}`;
  if (course.jumps.length > 0)
    progress.note(msg`${path}: its velocity still jumps at ${jumps}: no curve there is slower than light`);
}

async function renderIntoSink(
  renderer: PictureRenderer,
  sequence: PictureSequence,
  sink: FrameSink,
  progress: Progress,
): Promise<Pick<RenderReport, 'exposures' | 'falseColours'>> {
  const exposures: number[] = [];
  let falseColors: FalseColorScale | undefined;
  const count = sequence.frames.length;
  throwIfStopped();
  for await (const frame of renderPictureSequence(renderer, sequence, (done) => progress.frames(done, count))) {
    await sink.add(frame);
    exposures.push(frame.exposure);
    falseColors ??= frame.settings.falseColors;
    throwIfStopped();
  }
  return { exposures, ...(falseColors && { falseColours: falseColors }) };
}

/** The AOVs to write: those of `--aov`, by default beauty in EXR and none in other formats. Throws if the format cannot hold them. */
export function chooseAovs({ output, aov }: RenderFlags): readonly AovName[] {
  if (extname(output).toLowerCase() === '.exr') return aov ?? ['beauty'];
  if (aov) throw usageError(msg`--aov needs a file that can hold data channels: write an .exr, not ${output}`);
  return [];
}

function checkFalseColors(flags: RenderFlags, aovs: readonly AovName[]): void {
  const { falseColour, falseRange, legend, ghost, pastFuture } = flags;
  if (falseColour === undefined) {
    if (falseRange) throw usageError(msg`--false-range is for false colours: add --false-colour, or leave it out`);
    if (legend && ghost === 'none' && !pastFuture)
      throw usageError(
        msg`--legend is for false colours, a ghost, and past and future: add --false-colour, --ghost or --past-future, or leave it out`,
      );
    if (legend && aovs.length > 0)
      throw usageError(msg`--legend is below a picture for a screen; an .exr has data instead: leave it out`);
  } else if (aovs.length > 0) {
    throw usageError(msg`--false-colour makes pictures for a screen; an .exr holds the numbers themselves: use --aov`);
  } else if (falseRange && falseColour !== 'emission-time' && falseRange.from <= 0) {
    throw usageError(msg`--false-range: the scale of ${falseColour} is logarithmic, so that both ends must be above 0`);
  }
}
