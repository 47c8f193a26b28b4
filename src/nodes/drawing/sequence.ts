import type { ObserverPath } from '../../scene/observerPath.ts';
import type { AovName, RenderSettings } from '../../scene/view.ts';
import type { FrameTime } from '../files.ts';
import type { Metering } from '../metering.ts';
import type { PictureNotes } from './encode.ts';
import { ExposureMeter } from './exposure.ts';
import { type FalseColouring, FalseColourPainter } from './falseColour.ts';
import { Gauges } from './gauges.ts';
import type { Painted, PicturePainter, PictureRequest } from './painter.ts';
import { PlanSettings } from './planSettings.ts';

/** Pictures of one scene, one after another. */
export interface Sequence extends FalseColouring {
  /** Before metering. */
  readonly settings: RenderSettings;
  readonly metering: Metering;
  /** n × n samples per pixel. */
  readonly samples: number;
  /** Data channels in place of the picture for a screen; none: that. */
  readonly aovs: readonly AovName[];
  readonly observer: ObserverPath;
  readonly frames: readonly FrameTime[];
}

/** One of them. */
export interface Frame extends PictureNotes {
  readonly number?: number;
  readonly painted: Painted;
  /** With what the metering set [EV]. */
  readonly exposure: number;
}

/**
 * Draws a sequence frame by frame: each is exposed by its own light, eased from that of the one before; scales of false colours are those of the first.
 * `onPart` hears how many frames are done, parts of a frame too. Who stops asking for frames ends the work.
 */
export async function* framesOfSequence(
  painter: PicturePainter,
  sequence: Sequence,
  onPart: (done: number) => void,
): AsyncGenerator<Frame, void> {
  const { settings: plain, size, samples, aovs, observer, falseColour } = sequence;
  const gauges = new Gauges(painter, size);
  const meter = new ExposureMeter(gauges, sequence.metering, size);
  const composer = plain.plan && new PlanSettings(gauges, plain.plan);
  const falsely = falseColour && new FalseColourPainter(painter, gauges, falseColour, sequence);
  for (const [i, { number, t }] of sequence.frames.entries()) {
    onPart(i);
    const view = observer(t);
    const request: PictureRequest = { view, settings: plain, samples, pixels: aovs.length === 0, aovs };
    // Data and light itself have no exposure.
    const metered = request.pixels && showsLight(sequence) ? await meter.read(request) : 0;
    const exposure = plain.exposure + metered;
    const settings = composer ? await composer.read(request, metered) : { ...plain, exposure };
    const painted = await (falsely ?? painter).paint({ ...request, settings }, (part) => onPart(i + part));
    const shown = falsely?.colors ? { ...settings, falseColors: falsely.colors } : settings;
    yield { ...(number !== undefined && { number }), view, settings: shown, exposure, painted };
  }
}

/** The others show numbers, whatever their light. */
const showsLight = ({ falseColour }: FalseColouring): boolean => falseColour === undefined || falseColour === 'band';
