import { type LocalizedText, listed, msg } from '../../messages/message.ts';
import { type AovDifference, aovDifference, channelErrors } from '../../reference/compare/aovDifference.ts';
import { visiblePointsOf } from '../../reference/compare/channels.ts';
import { displacement } from '../../reference/compare/displacement.ts';
import { flip } from '../../reference/compare/flip.ts';
import { type Exposures, hdrFlip } from '../../reference/compare/hdrFlip.ts';
import { pixelDifference } from '../../reference/compare/pixelDifference.ts';
import type { RgbImage } from '../../reference/compare/rgbImage.ts';
import { type ErrorSummary, shareAbove, summarize } from '../../reference/compare/statistics.ts';
import { inputProblem } from '../terminal/exitCodes.ts';
import type { CompareFlags } from './compareFlags.ts';
import {
  displayedLinearRgb,
  type EncodedImageFile,
  type ExrFile,
  encodedRgb,
  linearRgb,
  type PictureFile,
} from './pictureFiles.ts';

export type Findings = FlipFindings | PixelFindings | AovFindings;

export interface FlipFindings extends ErrorFigures {
  readonly metric: 'flip';
  /** Of .exr pictures. */
  readonly exposures?: Exposures;
}
export interface PixelFindings extends ErrorFigures {
  readonly metric: 'pixels';
  readonly rmse: number;
  /** [dB]; infinite if the pictures are equal, which is null in JSON. */
  readonly psnr: number;
}
export interface AovFindings extends AovDifference {
  readonly metric: 'aov';
  readonly displacement: (ErrorFigures & { readonly measured: number; readonly lost: number }) | undefined;
  /** Errors of the channel that `--channel` names. */
  readonly channel: (ErrorFigures & { readonly name: string }) | undefined;
}
export interface ErrorFigures extends Partial<ErrorSummary> {
  readonly threshold: number;
  /** Fraction of the pixels, 0 … 1, with an error above the threshold. */
  readonly share: number;
}

export interface ErrorMap {
  readonly title: string;
  readonly errors: Float32Array;
  /** Error of the brightest colour. */
  readonly max: number;
}

export interface Comparison {
  readonly findings: Findings;
  /** Fraction of the pixels that are different; undefined, as the map, if the channels for it are missing. */
  readonly share: number | undefined;
  readonly map: ErrorMap | undefined;
}

export function comparePair(a: PictureFile, b: PictureFile, flags: CompareFlags): Comparison {
  if (a.kind === 'exr' && b.kind === 'exr') {
    if (flags.metric === 'aov') return compareAovs(a, b, flags);
    return flags.metric === 'flip' ? compareHdrFlip(a, b, flags) : compareLinear(linearRgb(a), linearRgb(b), flags);
  }
  if (a.kind === 'exr' || b.kind === 'exr') throw new TypeError('pictures of two kinds');
  if (flags.metric === 'aov')
    throw inputProblem(msg`${a.path}: only .exr pictures have channels to compare by --metric aov`);
  return flags.metric === 'flip' ? compareFlip(a, b, flags) : comparePixels(encodedRgb(a), encodedRgb(b), 1, flags);
}

function errorFigures(errors: Float32Array, threshold: number): ErrorFigures {
  return { threshold, share: shareAbove(errors, threshold), ...summarize(errors) };
}

// ── FLIP ───────────────────────────────────────────────────────────────────────────────────────────────────────────

const FLIP_THRESHOLD = 0.1;

const compareFlip = (a: EncodedImageFile, b: EncodedImageFile, flags: CompareFlags): Comparison =>
  flipFindings(flip(displayedLinearRgb(a), displayedLinearRgb(b)), flags);

function compareHdrFlip(a: ExrFile, b: ExrFile, flags: CompareFlags): Comparison {
  const { map, exposures } = hdrFlip(linearRgb(a), linearRgb(b));
  return flipFindings(map, flags, exposures);
}

function flipFindings(errors: Float32Array, flags: CompareFlags, exposures?: Exposures): Comparison {
  const findings: FlipFindings = {
    metric: 'flip',
    ...errorFigures(errors, flags.threshold ?? FLIP_THRESHOLD),
    exposures,
  };
  return { findings, share: findings.share, map: { title: 'FLIP', errors, max: flags.max ?? 1 } };
}

// ── Pixels ─────────────────────────────────────────────────────────────────────────────────────────────────────────

/** 5 of 255. */
const PIXEL_THRESHOLD = 0.02;

const compareLinear = (a: RgbImage, b: RgbImage, flags: CompareFlags): Comparison =>
  comparePixels(a, b, peakValue(a, b), flags);

function comparePixels(a: RgbImage, b: RgbImage, peak: number, flags: CompareFlags): Comparison {
  const { map, mean, max, rmse, psnr } = pixelDifference(a, b, peak);
  const threshold = flags.threshold ?? PIXEL_THRESHOLD;
  const share = shareAbove(map, threshold);
  const findings: PixelFindings = {
    metric: 'pixels',
    mean,
    max,
    p99: summarize(map)?.p99,
    rmse,
    psnr,
    threshold,
    share,
  };
  return {
    findings,
    share,
    map: { title: 'LARGEST DIFFERENCE OF R, G, B', errors: map, max: flags.max ?? roundUp(max) },
  };
}

/** The largest value of both pictures. */
const peakValue = (a: RgbImage, b: RgbImage): number =>
  Math.max(...[a, b].map(({ rgb }) => rgb.reduce((x, y) => Math.max(x, y), 0)));

/** 1, 2 or 5 times a power of ten, at least `value`. */
function roundUp(value: number): number {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  return power * ([1, 2, 5].find((digit) => digit * power >= value) ?? 10);
}

// ── Channels ───────────────────────────────────────────────────────────────────────────────────────────────────────

/** [pixels] */
const DISPLACEMENT_THRESHOLD = 0.5;
const MAX_MAPPED_DISPLACEMENT = 2;

function compareAovs(a: ExrFile, b: ExrFile, flags: CompareFlags): Comparison {
  const difference = aovDifference(a, b);
  if (difference.channels.length === 0 && difference.otherObject === undefined)
    throw inputProblem(msg`${a.path} and ${b.path} have no channel in common: ${namesOf(a)}, and ${namesOf(b)}`);
  const moved = compareDisplacement(a, b, flags);
  const channel = flags.channel === undefined ? undefined : compareChannel(a, b, flags.channel, flags);
  const findings: AovFindings = {
    metric: 'aov',
    ...difference,
    displacement: moved?.figures,
    channel: channel?.figures,
  };
  const chosen = channel ?? moved;
  return { findings, share: chosen?.figures.share, map: chosen?.map };
}

const namesOf = ({ channels }: ExrFile): LocalizedText => listed([...channels.keys()]);

function compareDisplacement(a: ExrFile, b: ExrFile, flags: CompareFlags) {
  const [shownA, shownB] = [visiblePointsOf(a), visiblePointsOf(b)];
  if (!shownA || !shownB) return undefined;
  const { pixels, lost } = displacement(shownA, shownB, a.width, a.height);
  const compared = pixels.filter((value) => !Number.isNaN(value));
  const threshold = flags.channel === undefined ? (flags.threshold ?? DISPLACEMENT_THRESHOLD) : DISPLACEMENT_THRESHOLD;
  const measured = compared.filter(Number.isFinite);
  return {
    figures: {
      measured: measured.length,
      lost,
      threshold,
      share: shareAbove(compared, threshold),
      ...summarize(measured),
    },
    map: { title: 'DISPLACEMENT (PIXELS)', errors: pixels, max: flags.max ?? MAX_MAPPED_DISPLACEMENT },
  };
}

function compareChannel(a: ExrFile, b: ExrFile, name: string, flags: CompareFlags) {
  for (const file of [a, b]) {
    if (!file.channels.has(name)) throw inputProblem(msg`${file.path} has no channel ${name}; it has ${namesOf(file)}`);
  }
  const errors = channelErrors(a, b, name);
  const threshold = flags.threshold ?? 0;
  const max = flags.max ?? roundUp(errors.filter(Number.isFinite).reduce((x, y) => Math.max(x, y), 0));
  return {
    figures: { name, threshold, share: shareAbove(errors, threshold) },
    map: { title: `DIFFERENCE OF ${name}`, errors, max },
  };
}
