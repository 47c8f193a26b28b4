import type { PictureRenderer, PictureRequest, RenderedPicture } from '../../pipelines/pictureRenderer.ts';
import { falseColorLegendHeight } from '../../reference/figures/falseColorLegend.ts';
import type { MeteringMode } from '../../scene/settings/settings.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { PictureViews } from '../../scene/view/pictureViews.ts';
import type { AovName, RenderSettings } from '../../scene/view/view.ts';
import type { FrameTime } from '../project/outputFiles.ts';
import type { PictureInfo } from './encode.ts';
import { ExposureMeter } from './exposureMeter.ts';
import { type FalseColorOptions, FalseColorRenderer } from './falseColor.ts';
import { FrameGraphSettings } from './frameGraphSettings.ts';
import { overlayLegendHeight, withOverlayLegend } from './overlayLegend.ts';
import { PictureMeter } from './pictureMeter.ts';

/** Consecutive pictures of one scene. */
export interface PictureSequence extends FalseColorOptions {
  /** Before metering. */
  readonly settings: RenderSettings;
  readonly metering: MeteringMode;
  /** n × n samples per pixel. */
  readonly samples: number;
  /** AOVs to write instead of the display picture; empty: the display picture. */
  readonly aovs: readonly AovName[];
  /** At world time t [s]. */
  readonly views: (t: number) => PictureViews;
  readonly frames: readonly FrameTime[];
}

/** A picture of the sequence. */
export interface PictureFrame extends PictureInfo {
  readonly number?: number;
  readonly rendered: RenderedPicture;
  /** Including the metered exposure [EV]. */
  readonly exposure: number;
}

/** Size of written files, with the legends that are asked for. */
export function outputSize({ size, falseColour, legend, settings }: LegendOptions): PictureSize {
  if (!legend) return size;
  const { width, height } = size;
  const bar = falseColour ? falseColorLegendHeight(width, falseColour) : 0;
  return { width, height: height + bar + overlayLegendHeight(width, settings) };
}

type LegendOptions = Pick<PictureSequence, 'size' | 'falseColour' | 'legend' | 'settings'>;

/**
 * Renders a sequence frame by frame: each frame is metered, and its exposure eased from the previous one's;
 * false-colour scales are those of the first frame. `onPart` gets the number of finished frames, with fractions. Ending
 * the iteration ends the work.
 */
export async function* renderPictureSequence(
  renderer: PictureRenderer,
  sequence: PictureSequence,
  onPart: (done: number) => void,
): AsyncGenerator<PictureFrame, void> {
  const { settings: plain, size, samples, aovs, falseColour } = sequence;
  const pictureMeter = new PictureMeter(renderer, size);
  const exposureMeter = new ExposureMeter(pictureMeter, sequence.metering, size);
  const frameGraphSettings = plain.frameGraph && new FrameGraphSettings(pictureMeter, plain.frameGraph);
  const falseColorRenderer = falseColour && new FalseColorRenderer(renderer, pictureMeter, falseColour, sequence);
  for (const [i, { number, t }] of sequence.frames.entries()) {
    onPart(i);
    const views = sequence.views(t);
    const request: PictureRequest = { views, settings: plain, samples, pixels: aovs.length === 0, aovs };
    // AOVs are not exposed.
    const metered = request.pixels && showsLight(sequence) ? await exposureMeter.read(request) : 0;
    const exposure = plain.exposure + metered;
    const settings = frameGraphSettings ? await frameGraphSettings.read(request, metered) : { ...plain, exposure };
    const drawn = await (falseColorRenderer ?? renderer).render({ ...request, settings }, (part) => onPart(i + part));
    const rendered = sequence.legend && request.pixels ? withOverlaysTold(drawn, sequence) : drawn;
    const colors = falseColorRenderer?.colors;
    const finalSettings = colors ? { ...settings, falseColors: colors } : settings;
    yield { ...(number !== undefined && { number }), views, settings: finalSettings, exposure, rendered };
  }
}

/** With the legend of what is drawn over the picture. */
function withOverlaysTold(drawn: RenderedPicture, { size: { width }, settings }: LegendOptions): RenderedPicture {
  const picture = { width, height: drawn.pixels.length / (4 * width), pixels: drawn.pixels };
  return { ...drawn, pixels: withOverlayLegend(picture, settings).pixels };
}

/** All others show numbers, which do not depend on exposure. */
const showsLight = ({ falseColour }: FalseColorOptions): boolean => falseColour === undefined || falseColour === 'band';
