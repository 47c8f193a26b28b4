import { extname } from 'node:path';
import { writtenSize } from '../nodes/drawing/falseColour.ts';
import { framesOfSequence, type Sequence } from '../nodes/drawing/sequence.ts';
import type { FrameTime } from '../nodes/files.ts';
import { validate } from '../scene/validate.ts';
import type { AovName, ViewPoint } from '../scene/view.ts';
import type { FalseColors } from '../spectrum/falseColor.ts';
import { reportDiagnostics } from './diagnostics.ts';
import { usageError } from './exit.ts';
import { renderSettings, speedOfLight } from './flags.ts';
import { observerPath } from './observer.ts';
import { endIfStopped } from './output.ts';
import { openPainter, type Painter, type PainterInfo } from './painter.ts';
import { checkPipeline } from './pipeline.ts';
import type { Progress } from './progress.ts';
import type { Opened } from './project.ts';
import type { RenderFlags } from './render.ts';
import { openSink, type Sink } from './sinks.ts';

/** What has been made, for a report. */
export interface Drawn {
  readonly files: readonly string[];
  readonly frames: readonly FrameTime[];
  readonly first: ViewPoint;
  readonly info: PainterInfo;
  readonly samples: number;
  /** [m/s] */
  readonly speedOfLight: number;
  /** Of each frame [EV]. */
  readonly exposures: readonly number[];
  readonly falseColours?: FalseColors;
}

/** Draws frames of a scene, of a file or of a project, and writes them as the flags say: files that are not finished do not stay. */
export async function drawFiles(
  { scene, others, plan, flags }: Opened<RenderFlags>,
  frames: readonly FrameTime[],
  progress: Progress,
): Promise<Drawn> {
  checkPipeline(flags);
  const aovs = chooseAovs(flags);
  checkFalseColours(flags, aovs);
  const c = speedOfLight(scene, flags.c);
  reportDiagnostics([...scene.diagnostics, ...validate(scene, c)]);
  const { size, metering, falseColour, falseRange, legend } = flags;
  const observer = observerPath(scene, flags, c, frames[0]!.t, flags.hold);
  const settings = { ...renderSettings(flags, c), ...(plan && { plan }) };
  const wanted = { settings, metering, size, aovs, observer, frames, falseColour, falseRange, legend };
  const sink = await openSink({ ...flags, size: writtenSize(flags) }, scene, frames.length);
  try {
    progress.show('getting ready to draw …');
    const painter = await openPainter([scene, ...others], flags, (text) => progress.note(text));
    const samples = flags.samples ?? (flags.antialiasing ? painter.usualSamples : 1);
    const made = await intoSink(painter, { ...wanted, samples }, sink, progress).finally(() => painter.close());
    endIfStopped();
    progress.show('finishing …');
    await sink.finish();
    const { info } = painter;
    const { files } = sink;
    return { files, frames, first: observer(frames[0]!.t), info, samples, speedOfLight: c, ...made };
  } finally {
    progress.clear();
    sink.discard();
  }
}

async function intoSink(
  painter: Painter,
  sequence: Sequence,
  sink: Sink,
  progress: Progress,
): Promise<Pick<Drawn, 'exposures' | 'falseColours'>> {
  const exposures: number[] = [];
  let falseColours: FalseColors | undefined;
  const count = sequence.frames.length;
  endIfStopped();
  for await (const frame of framesOfSequence(painter, sequence, (done) => progress.frames(done, count))) {
    await sink.add(frame);
    exposures.push(frame.exposure);
    falseColours ??= frame.settings.falseColors;
    endIfStopped();
  }
  return { exposures, ...(falseColours && { falseColours }) };
}

/** Data channels need a format that can hold them; without a wish an EXR holds the picture in linear light. */
export function chooseAovs({ output, aov }: RenderFlags): readonly AovName[] {
  if (extname(output).toLowerCase() === '.exr') return aov ?? ['beauty'];
  if (aov) throw usageError(`--aov needs a file that can hold data channels: write an .exr, not ${output}`);
  return [];
}

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
