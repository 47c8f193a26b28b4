import { extname } from 'node:path';
import { length } from '../math/vec3.ts';
import { gamma, velocity } from '../physics/boost.ts';
import type { Scene } from '../scene/types.ts';
import { validate } from '../scene/validate.ts';
import type { AovName, ViewPoint } from '../scene/view.ts';
import type { FalseColors } from '../spectrum/falseColor.ts';
import { reportDiagnostics } from './diagnostics.ts';
import { usageError } from './exit.ts';
import { ExposureMeter } from './exposure.ts';
import { FalseColourPainter, writtenSize } from './falseColour.ts';
import { renderSettings, speedOfLight } from './flags.ts';
import { observerPath } from './observer.ts';
import { endIfStopped } from './output.ts';
import { openPainter, type Painter } from './painter.ts';
import { checkPipeline } from './pipeline.ts';
import { PlanSettings } from './planSettings.ts';
import { Progress } from './progress.ts';
import { isProject, type Opened, projectFlags } from './project.ts';
import type { RenderFlags } from './render.ts';
import { openChangedScene } from './scene.ts';
import { openSink, type Sink } from './sinks.ts';

/** A frame's number, where there are several, and its world time [s]. */
interface FrameTime {
  readonly number?: number;
  readonly t: number;
}

/** What has been made, for the report. */
interface Made {
  readonly frames: readonly FrameTime[];
  readonly first: ViewPoint;
  readonly painter: Painter;
  readonly samples: number;
  /** Of each frame [EV]. */
  readonly exposures: readonly number[];
  readonly falseColours?: FalseColors;
}

export async function render(path: string, written: RenderFlags, given: ReadonlySet<string>): Promise<void> {
  checkPipeline(written);
  checkSamples(written);
  const aovs = chooseAovs(written);
  const progress = new Progress();
  progress.show('reading …');
  const { scene, others, plan, flags } = await opened(path, written, given, progress);
  progress.clear();
  checkPipeline(flags);
  const c = speedOfLight(scene, flags.c);
  reportDiagnostics([...scene.diagnostics, ...validate(scene, c)]);
  const frames = frameTimes(scene, flags);
  const observer = observerPath(scene, flags, c, frames[0]!.t, flags.hold);
  const exposures: number[] = [];
  checkFalseColours(flags, aovs);
  const sink = await openSink({ ...flags, size: writtenSize(flags) }, scene, frames.length);
  try {
    progress.show('getting ready to draw …');
    const painter = await openPainter(path, [scene, ...others], flags, (text) => progress.note(text));
    const samples = flags.samples ?? (flags.antialiasing ? painter.usualSamples : 1);
    const meter = new ExposureMeter(painter, flags.metering, flags.size);
    const composer = plan && new PlanSettings(painter, plan, flags.size);
    const falsely = flags.falseColour && new FalseColourPainter(painter, flags.falseColour, flags);
    try {
      for (const [i, { number, t }] of frames.entries()) {
        const onPart = (part: number): void => progress.frames(i + part, frames.length);
        onPart(0);
        endIfStopped();
        const view = observer(t);
        const plain = renderSettings(flags, c);
        const request = {
          view,
          settings: plan ? { ...plain, plan } : plain,
          samples,
          pixels: aovs.length === 0,
          aovs,
        };
        // Data and light itself have no exposure.
        const metered = request.pixels && showsLight(flags) ? await meter.read(request) : 0;
        exposures.push(plain.exposure + metered);
        const settings = composer
          ? await composer.read(request, metered)
          : { ...request.settings, exposure: exposures.at(-1)! };
        const picture = await (falsely ?? painter).paint({ ...request, settings }, onPart);
        await sink.add(picture, { number, view, settings: { ...settings, falseColors: falsely?.colors } });
      }
    } finally {
      await painter.close();
    }
    endIfStopped();
    progress.show('finishing …');
    await sink.finish();
    progress.clear();
    report(
      flags,
      scene,
      c,
      { frames, first: observer(frames[0]!.t), painter, samples, exposures, falseColours: falsely?.colors },
      sink,
    );
  } finally {
    progress.clear();
    sink.discard();
  }
}

/** A scene file as the flags would have it, or what a project makes, with what it says of the picture. */
async function opened(
  path: string,
  flags: RenderFlags,
  given: ReadonlySet<string>,
  progress: Progress,
): Promise<Opened<RenderFlags>> {
  if (await isProject(path)) return projectFlags(path, flags, given, progress.node);
  if (flags.set) throw usageError('--set is for projects, .slowlight.json; of a scene file there are no nodes to set');
  return { scene: await openChangedScene(path, flags), others: [], flags };
}

function checkSamples({ samples, antialiasing }: RenderFlags): void {
  if (samples !== undefined && !antialiasing)
    throw usageError('--no-antialiasing takes one sample, at the centre of each pixel: leave it or --samples out');
}

/** Data channels need a format that can hold them; without a wish an EXR holds the picture in linear light. */
function chooseAovs({ output, aov }: RenderFlags): readonly AovName[] {
  if (extname(output).toLowerCase() === '.exr') return aov ?? ['beauty'];
  if (aov) throw usageError(`--aov needs a file that can hold data channels: write an .exr, not ${output}`);
  return [];
}

/** The others show numbers, whatever their light. */
const showsLight = ({ falseColour }: RenderFlags): boolean => falseColour === undefined || falseColour === 'band';

function checkFalseColours({ falseColour, falseRange, legend }: RenderFlags, aovs: readonly AovName[]): void {
  if (falseColour === undefined) {
    const idle = falseRange ? '--false-range' : legend ? '--legend' : undefined;
    if (idle) throw usageError(`${idle} is for false colours: add --false-colour, or leave it out`);
  } else if (aovs.length > 0) {
    throw usageError('--false-colour makes pictures for a screen; an .exr holds the numbers themselves: use --aov');
  } else if (falseRange && falseColour !== 'emission-time' && falseRange.from <= 0) {
    throw usageError(`--false-range: the scale of ${falseColour} is logarithmic, so that both ends must be above 0`);
  }
}

function frameTimes(scene: Scene, { time, frames, fps = scene.timeCodesPerSecond, output }: RenderFlags): FrameTime[] {
  if (!frames) {
    if (extname(output).toLowerCase() === '.mp4') throw usageError('an .mp4 needs --frames FIRST:LAST');
    return [{ t: time ?? scene.hints.openAt ?? scene.startTime }];
  }
  if (time !== undefined) throw usageError('--time and --frames exclude each other');
  const count = frames.last - frames.first + 1;
  return Array.from({ length: count }, (_, i) => ({ number: frames.first + i, t: (frames.first + i) / fps }));
}

function report(flags: RenderFlags, scene: Scene, c: number, made: Made, sink: Sink): void {
  const { files } = sink;
  const { frames, first } = made;
  if (!flags.json) {
    console.log(`${files.length > 1 ? `${files.length} files, the last ` : ''}${files.at(-1)}`);
    return;
  }
  const beta = velocity(first.u);
  const summary = {
    files,
    ...flags.size,
    frames: frames.length,
    times: [frames[0]!.t, frames.at(-1)!.t],
    speedOfLight: c,
    observer: { position: first.position, beta, speed: length(beta), gamma: gamma(first.u) },
    ...made.painter.info,
    samples: made.samples,
    exposure: [made.exposures[0]!, made.exposures.at(-1)!],
    falseColours: made.falseColours,
    objects: scene.objects.map((object, i) => ({ id: i + 1, path: object.path })),
  };
  console.log(JSON.stringify(summary, null, 2));
}
