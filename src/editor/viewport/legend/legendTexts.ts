import { type Message, msg, type Translate } from '../../../messages/message.ts';
import {
  colorRamp,
  type FalseColorQuantity,
  type FalseColorScale,
  positionOnScale,
} from '../../../spectrum/falseColor/falseColor.ts';
import { tickDigits, ticksOf } from '../../../spectrum/falseColor/falseColorScale.ts';
import { bandOf, SPECTRAL_BANDS, type SpectralBandName } from '../../../spectrum/falseColor/spectralBands.ts';
import { formatLength, formatNumber } from '../../format.ts';
import type { PickedValue } from './legendState.ts';

/** Enough stops for a smooth gradient. */
const GRADIENT_STOPS = 33;

const QUANTITY_TITLES: Readonly<Record<FalseColorQuantity, Message>> = {
  doppler: msg`Doppler factor D`,
  'emission-time': msg`Happened, from now`,
  radiance: msg`Luminance before exposure`,
  band: msg`Seen at 550 nm, emitted at [nm]`,
};
const BAND_TITLES: Readonly<Record<SpectralBandName, Message>> = {
  'far-ultraviolet': msg`far UV`,
  'near-ultraviolet': msg`near UV`,
  visible: msg`visible`,
  'near-infrared': msg`near IR`,
  'thermal-infrared': msg`thermal IR`,
};

/**
 * Texts of a legend in the page's language, for page and saved pictures. Colours are CSS colours, positions 0 … 1 along
 * the bar.
 */
export interface LegendTexts {
  readonly title: string;
  /** From end to end, equally spaced. */
  readonly stops: readonly string[];
  readonly ticks: readonly { readonly part: number; readonly text: string }[];
  /** Text alternative of the bar. */
  readonly range: string;
  readonly bands: readonly { readonly name: string; readonly color: string }[];
}

export function legendTexts({ kind, ...scale }: FalseColorScale, t: Translate): LegendTexts {
  const ticks = ticksOf(kind, scale);
  const digits = tickDigits(ticks);
  return {
    title: t(QUANTITY_TITLES[kind]),
    stops: colorRamp(kind, scale, GRADIENT_STOPS).map(css),
    ticks: ticks.map((value) => ({ part: positionOnScale(kind, value, scale), text: shortText(kind, value, digits) })),
    range: t(msg`Colours from ${valueText(kind, scale.from)} to ${valueText(kind, scale.to)}`),
    bands:
      kind === 'band'
        ? SPECTRAL_BANDS.map(({ name, color }) => ({ name: t(BAND_TITLES[name]), color: css(color) }))
        : [],
  };
}

const css = (rgb: readonly number[]): string => `rgb(${rgb.join(' ')})`;

/** Position of a picked value on the bar. */
export function pickedPosition({ kind, ...scale }: FalseColorScale, { value }: PickedValue): number | undefined {
  return Number.isNaN(value) ? undefined : Math.min(1, Math.max(0, positionOnScale(kind, value, scale)));
}

/** A picked value and its object as texts. */
export const pickedTexts = (kind: FalseColorQuantity, reading: PickedValue, t: Translate) => ({
  value: pickedText(kind, reading, t),
  of: reading.path ?? t(msg`sky`),
});

function pickedText(kind: FalseColorQuantity, { value }: PickedValue, t: Translate): string {
  if (Number.isNaN(value)) return t(msg`nothing there`);
  return kind === 'band' ? `${valueText(kind, value)} · ${t(BAND_TITLES[bandOf(value)])}` : valueText(kind, value);
}

/** Value with unit. */
function valueText(kind: FalseColorQuantity, value: number): string {
  if (kind === 'doppler') return `D = ${formatNumber(value)}`;
  if (kind === 'emission-time') return `${formatNumber(value)} s`;
  return kind === 'band' ? formatLength(value) : formatNumber(value);
}

/** Short form, for the space beside the bar. */
function shortText(kind: FalseColorQuantity, value: number, digits: number): string {
  const text = formatNumber(kind === 'band' ? value * 1e9 : value, digits);
  const short = text.includes('.') ? text.replace(/\.?0+$/, '') : text;
  return kind === 'emission-time' ? `${short} s` : short;
}
