import { colorRow, type FalseColor, type FalseColors, partOf } from '../../spectrum/falseColor.ts';
import { tickDigits, ticksOf } from '../../spectrum/falseScale.ts';
import { BANDS, bandOf } from '../../spectrum/spectralBands.ts';
import { formatLength, formatNumber } from '../format.ts';
import type { Translate } from '../i18n/i18n.ts';
import type { Reading } from '../state/legend.ts';

/** Colours of the bar: enough that nobody sees steps. */
const STOPS = 33;

/** What a legend tells, on the page and in a saved picture, in the language of the page. Colours are CSS's, places parts 0 … 1 of the bar. */
export interface LegendWords {
  readonly title: string;
  /** From end to end, at equal steps. */
  readonly stops: readonly string[];
  readonly ticks: readonly { readonly part: number; readonly text: string }[];
  /** What the bar shows, for those who do not see it. */
  readonly range: string;
  readonly bands: readonly { readonly name: string; readonly color: string }[];
}

export function legendWords({ kind, ...scale }: FalseColors, t: Translate): LegendWords {
  const ticks = ticksOf(kind, scale);
  const digits = tickDigits(ticks);
  return {
    title: t(`legend.${kind}`),
    stops: colorRow(kind, scale, STOPS).map(css),
    ticks: ticks.map((value) => ({ part: partOf(kind, value, scale), text: shortText(kind, value, digits) })),
    range: t('legend.range', { from: valueText(kind, scale.from), to: valueText(kind, scale.to) }),
    bands: kind === 'band' ? BANDS.map(({ name, color }) => ({ name: t(`band.${name}`), color: css(color) })) : [],
  };
}

const css = (rgb: readonly number[]): string => `rgb(${rgb.join(' ')})`;

/** Where on the bar a value is that was read. */
export function readingPart({ kind, ...scale }: FalseColors, { value }: Reading): number | undefined {
  return Number.isNaN(value) ? undefined : Math.min(1, Math.max(0, partOf(kind, value, scale)));
}

/** A value that was read, and of what. */
export const readingWords = (kind: FalseColor, reading: Reading, t: Translate) => ({
  value: readingText(kind, reading, t),
  of: reading.path ?? t('legend.sky'),
});

function readingText(kind: FalseColor, { value }: Reading, t: Translate): string {
  if (Number.isNaN(value)) return t('legend.nothing');
  return kind === 'band' ? `${valueText(kind, value)} · ${t(`band.${bandOf(value)}`)}` : valueText(kind, value);
}

/** With its unit. */
function valueText(kind: FalseColor, value: number): string {
  if (kind === 'doppler') return `D = ${formatNumber(value)}`;
  if (kind === 'emission-time') return `${formatNumber(value)} s`;
  return kind === 'band' ? formatLength(value) : formatNumber(value);
}

/** Beside the bar there is little room. */
function shortText(kind: FalseColor, value: number, digits: number): string {
  const text = formatNumber(kind === 'band' ? value * 1e9 : value, digits);
  const short = text.includes('.') ? text.replace(/\.?0+$/, '') : text;
  return kind === 'emission-time' ? `${short} s` : short;
}
