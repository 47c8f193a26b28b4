import { colorAt, type FalseColor, type FalseColors, partOf } from '../spectrum/falseColor.ts';
import { tickDigits, ticksOf } from '../spectrum/falseScale.ts';
import { BANDS, type BandName } from '../spectrum/spectralBands.ts';
import { type Canvas, canvas, paste } from './compare/canvas.ts';
import { GROUND, type LegendBar, legendBar, legendHeight, letterSize } from './compare/legendBar.ts';

const TITLES: Readonly<Record<FalseColor, string>> = {
  doppler: 'DOPPLER FACTOR D',
  'emission-time': 'EMITTED, FROM NOW (S)',
  radiance: 'LUMINANCE BEFORE EXPOSURE',
  band: '550 NM WAS EMITTED AT (NM)',
};
const BAND_NAMES: Readonly<Record<BandName, string>> = {
  'far-ultraviolet': 'FAR UV',
  'near-ultraviolet': 'NEAR UV',
  visible: 'VISIBLE',
  'near-infrared': 'NEAR IR',
  'thermal-infrared': 'THERMAL IR',
};

/** How high a picture of this width is with its legend, beyond its own height [px]. */
export const legendRoom = (width: number, kind: FalseColor): number =>
  legendHeight(letterSize(width), kind === 'band' ? 2 : 1);

/** A picture over the legend of its colours. */
export function withLegend(picture: Canvas, colors: FalseColors): Canvas {
  const { width, height } = picture;
  const { kind, ...scale } = colors;
  const legend: LegendBar = {
    title: TITLES[kind],
    color: (part) => colorAt(kind, part, scale),
    rows: rowsOf(colors),
  };
  const whole = canvas(width, height + legendRoom(width, kind), GROUND);
  paste(whole, picture, 0, 0);
  paste(whole, legendBar(width, letterSize(width), legend), 0, height);
  return whole;
}

/** Numbers, both ends first, for what has no room is left out from the end of the list on; of bands also their names. */
function rowsOf({ kind, ...scale }: FalseColors): LegendBar['rows'] {
  const at = (value: number, text: string) => ({ part: partOf(kind, value, scale), text });
  const ticks = ticksOf(kind, scale);
  const digits = tickDigits(ticks);
  const plain = (value: number): string => String(Number(value.toPrecision(digits)));
  if (kind !== 'band') return [[scale.from, scale.to, ...ticks.slice(1, -1)].map((value) => at(value, plain(value)))];
  const names = BANDS.map(({ name, from }, i) => {
    const [start, end] = [Math.max(from, scale.from), Math.min(BANDS[i + 1]?.from ?? scale.to, scale.to)];
    return at(Math.sqrt(start * end), BAND_NAMES[name]);
  });
  // The visible is the one to find the others by.
  const visible = BANDS.findIndex(({ name }) => name === 'visible');
  return [ticks.map((value) => at(value, plain(value * 1e9))), [names[visible]!, ...names]];
}
