import { skyDoppler } from '../../reference/post/falseColor.ts';
import type { MeteringMode } from '../../scene/settings/settings.ts';
import { isPanoramic, pixelSolidAngle } from '../../scene/view/lenses/lenses.ts';
import { type LightMeterReadings, METER_CELLS, meterPixel, relativeLuminance } from '../../scene/view/metering.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import { type PictureViews, scaleViewports, viewPixelAt } from '../../scene/view/pictureViews.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { isLuminous } from '../../scene/views/views.ts';
import { dopplerTint } from '../../spectrum/doppler/dopplerTint.ts';
import type { FalseColorQuantity, ValueRange } from '../../spectrum/falseColor/falseColor.ts';
import { fitScale } from '../../spectrum/falseColor/falseColorScale.ts';

/**
 * Percentile ranges of the lit pixels: midtones, without shadows and reflections; and highlights, without glints of the
 * sun.
 */
const MIDTONE_RANGE = [0.1, 0.95] as const;
const HIGHLIGHT_RANGE = [0.98, 0.995] as const;
/** Target luminance of the midtones: that of the example scenes at rest, as lit by their authors. */
const MIDTONE_LUMINANCE = 0.4;
/** Upper limit for the highlights, so that a small bright object before black space is exposed for. */
const HIGHLIGHT_LUMINANCE = 1.25;
/** Time constant of adaptation: the difference falls to 1/e [s]. */
const ADAPTATION_TIME = 0.3;

/**
 * `weights`: of the readings; absent: all count alike. Exposure that brings the midtones to their target, or less if the highlights require it [EV]; from means over
 * percentile ranges of log₂ luminance. It varies continuously with the light and is insensitive to lamps and glints; 0
 * if nothing is lit.
 */
export function meteredExposure(luminance: ArrayLike<number>, weights?: ArrayLike<number>): number {
  const stops = Float64Array.from(luminance, Math.log2);
  const readings = weights ? weighted(stops, weights) : { stops: stops.filter(Number.isFinite).sort() };
  if (readings.stops.length === 0) return 0;
  return Math.min(
    Math.log2(MIDTONE_LUMINANCE) - trimmedMean(readings, MIDTONE_RANGE),
    Math.log2(HIGHLIGHT_LUMINANCE) - trimmedMean(readings, HIGHLIGHT_RANGE),
  );
}

/** Readings in ascending order [EV], with their weights if these differ. */
interface SortedReadings {
  readonly stops: Float64Array;
  readonly weights?: Float64Array;
}

function weighted(stops: Float64Array, weights: ArrayLike<number>): SortedReadings {
  const order = [...stops.keys()]
    .filter((i) => Number.isFinite(stops[i]) && weights[i]! > 0)
    .sort((a, b) => stops[a]! - stops[b]!);
  return {
    stops: Float64Array.from(order, (i) => stops[i]!),
    weights: Float64Array.from(order, (i) => weights[i]!),
  };
}

/** Weighted mean of the readings whose middles are between two shares of the whole weight; at least of the one nearest to the first. */
function trimmedMean({ stops, weights }: SortedReadings, [from, to]: readonly [number, number]): number {
  const total = weights ? weights.reduce((sum, weight) => sum + weight, 0) : stops.length;
  let [before, sum, counted, nearest] = [0, 0, 0, stops[0]!];
  stops.forEach((value, i) => {
    const weight = weights?.[i] ?? 1;
    const middle = (before + weight / 2) / total;
    before += weight;
    if (middle < from) nearest = value;
    if (middle < from || middle > to) return;
    sum += weight * value;
    counted += weight;
  });
  return counted > 0 ? sum / counted : nearest;
}

/** The solid angles of the meter's cells where a lens is panoramic, since its pixels have very different ones; undefined otherwise: all count alike. */
function cellWeights(views: PictureViews, size: PictureSize): Float64Array | undefined {
  if (views.every(({ lens }) => !isPanoramic(lens))) return undefined;
  return Float64Array.from({ length: METER_CELLS * METER_CELLS }, (_, i) => {
    const [x, y] = [meterPixel(i % METER_CELLS, size.width), meterPixel(Math.floor(i / METER_CELLS), size.height)];
    const found = viewPixelAt(views, size, x + 0.5, y + 0.5);
    return found ? pixelSolidAngle(found.view.lens, found.x, found.y, found) : 0;
  });
}

/**
 * Metered exposure [EV] of a picture, to which the user's compensation is added. The readings precede exposure and tone
 * curve, so they are valid for any of these.
 */
export function exposureForMetering(
  metering: MeteringMode,
  { luminance }: Pick<LightMeterReadings, 'luminance'>,
  views: PictureViews,
  settings: RenderSettings,
  size: PictureSize,
): number {
  if (metering === 'manual') return 0;
  const metered = metering === 'automatic' ? luminance : restFrameLuminance(luminance, views, settings, size);
  return meteredExposure(metered, settings.outside ? undefined : cellWeights(views, size));
}

/**
 * Luminance divided by the factor that the observer's velocity applies to white daylight from that direction: D⁴, and
 * its shift out of the visible range. This is what an observer at rest receives at the same event from the same
 * objects.
 */
function restFrameLuminance(
  luminance: Float32Array,
  views: PictureViews,
  settings: RenderSettings,
  { width, height }: PictureSize,
): Float32Array {
  if (!isLuminous(settings) || settings.outside) return luminance;
  const aspect = width / height;
  const picture = { width: aspect * METER_CELLS, height: METER_CELLS };
  const scaled = scaleViewports(views, METER_CELLS / height);
  return luminance.map((value, i) => {
    const [x, y] = [aspect * ((i % METER_CELLS) + 0.5), Math.floor(i / METER_CELLS) + 0.5];
    const D = skyDoppler(scaled, picture, settings, x, y);
    const white = relativeLuminance(...dopplerTint([1, 1, 1], D, settings.dopplerMix));
    return value / (white * D ** (4 * settings.beaming));
  });
}

/** Exposure after dt [s] of adaptation; both in EV. */
export const adaptExposure = (from: number, to: number, dt: number): number =>
  to + (from - to) * Math.exp(-Math.max(dt, 0) / ADAPTATION_TIME);

/** The meter reading that each false colour displays. */
const MEASURED_BY: Readonly<Record<FalseColorQuantity, keyof LightMeterReadings>> = {
  doppler: 'doppler',
  'emission-time': 'time',
  radiance: 'luminance',
  band: 'doppler',
};

/** The false-colour scale that encloses the readings. */
export const measuredFalseColorScale = (
  kind: FalseColorQuantity,
  readings: LightMeterReadings | undefined,
): ValueRange => fitScale(kind, readings ? readings[MEASURED_BY[kind]] : []);
