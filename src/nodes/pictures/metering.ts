import { skyDoppler } from '../../reference/post/falseColor.ts';
import type { MeteringMode } from '../../scene/settings/settings.ts';
import { type LightMeterReadings, METER_CELLS, relativeLuminance } from '../../scene/view/metering.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import { VIEWS } from '../../scene/views/views.ts';
import { dopplerTint } from '../../spectrum/doppler/dopplerTint.ts';
import type { FalseColorQuantity, ValueRange } from '../../spectrum/falseColor/falseColor.ts';
import { fitScale } from '../../spectrum/falseColor/falseColorScale.ts';

/** Shares of what is lit at all, from the darkest on: its middle, without shadows and reflections, and its highlights, without the sun's glints. */
const MIDTONE_RANGE = [0.1, 0.95] as const;
const HIGHLIGHT_RANGE = [0.98, 0.995] as const;
/** Luminance that the middle is brought to: what the example scenes have at rest, as their authors lit them. */
const MIDTONE_LUMINANCE = 0.4;
/** Luminance that the highlights are not brought above: a small bright thing before black space is what the picture is of. */
const HIGHLIGHT_LUMINANCE = 1.25;
/** In so long an eye makes all but 1/e of its way to another brightness [s]. */
const ADAPTATION_TIME = 0.3;

/**
 * The exposure at which a picture of this light has a middle brightness, or less where its highlights ask for it [EV]: by means over parts of
 * the distribution of log₂ of luminance. It follows the light without steps, and a lamp or a glint does not move it; 0 where nothing is lit.
 */
export function meteredExposure(luminance: ArrayLike<number>): number {
  const stops = Float64Array.from(luminance, Math.log2).filter(Number.isFinite).sort();
  if (stops.length === 0) return 0;
  return Math.min(
    Math.log2(MIDTONE_LUMINANCE) - trimmedMean(stops, MIDTONE_RANGE),
    Math.log2(HIGHLIGHT_LUMINANCE) - trimmedMean(stops, HIGHLIGHT_RANGE),
  );
}

function trimmedMean(sorted: Float64Array, [from, to]: readonly [number, number]): number {
  const last = sorted.length - 1;
  const part = sorted.subarray(Math.round(from * last), Math.round(to * last) + 1);
  return part.reduce((sum, value) => sum + value, 0) / part.length;
}

/**
 * The exposure that the metering sets [EV], to which the person's own is added. The gauge's light may be that of another exposure and another
 * tone curve, for it is before both. `aspect`: width over height.
 */
export function exposureForMetering(
  metering: MeteringMode,
  { luminance }: Pick<LightMeterReadings, 'luminance'>,
  view: ViewPoint,
  settings: RenderSettings,
  aspect: number,
): number {
  if (metering === 'manual') return 0;
  return meteredExposure(metering === 'automatic' ? luminance : restFrameLuminance(luminance, view, settings, aspect));
}

/**
 * Each light divided by what the observer's own velocity makes of white daylight from there: D⁴, and its shift out of the visible. So is the
 * light that somebody at rest receives at the same place and time from the same things.
 */
function restFrameLuminance(
  luminance: Float32Array,
  view: ViewPoint,
  settings: RenderSettings,
  aspect: number,
): Float32Array {
  if (!VIEWS[settings.view].luminous) return luminance;
  return luminance.map((value, i) => {
    const [x, y] = [aspect * ((i % METER_CELLS) + 0.5), Math.floor(i / METER_CELLS) + 0.5];
    const D = skyDoppler(view, settings, x, y, aspect * METER_CELLS, METER_CELLS);
    const white = relativeLuminance(...dopplerTint([1, 1, 1], D, settings.dopplerMix));
    return value / (white * D ** (4 * settings.beaming));
  });
}

/** An eye's way from one exposure to another in dt [s]; both in EV. */
export const adaptExposure = (from: number, to: number, dt: number): number =>
  to + (from - to) * Math.exp(-Math.max(dt, 0) / ADAPTATION_TIME);

/** Which of what is measured false colours stand for. */
const MEASURED_BY: Readonly<Record<FalseColorQuantity, keyof LightMeterReadings>> = {
  doppler: 'doppler',
  'emission-time': 'time',
  radiance: 'luminance',
  band: 'doppler',
};

/** The scale of false colours that holds what was measured. */
export const measuredFalseColorScale = (kind: FalseColorQuantity, gauge: LightMeterReadings | undefined): ValueRange =>
  fitScale(kind, gauge ? gauge[MEASURED_BY[kind]] : []);
