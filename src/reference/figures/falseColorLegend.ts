import {
  colorAt,
  type FalseColorQuantity,
  type FalseColorScale,
  positionOnScale,
} from '../../spectrum/falseColor/falseColor.ts';
import { tickDigits, ticksOf } from '../../spectrum/falseColor/falseColorScale.ts';
import { SPECTRAL_BANDS, type SpectralBandName } from '../../spectrum/falseColor/spectralBands.ts';
import { BACKGROUND, type ColorBar, colorBarHeight, drawColorBar, textScale } from './colorBar.ts';
import { createCanvas, type PixelCanvas, paste } from './pixelCanvas.ts';

const TITLES: Readonly<Record<FalseColorQuantity, string>> = {
  doppler: 'DOPPLER FACTOR D',
  'emission-time': 'EMITTED, FROM NOW (S)',
  radiance: 'LUMINANCE BEFORE EXPOSURE',
  band: '550 NM WAS EMITTED AT (NM)',
};
const BAND_NAMES: Readonly<Record<SpectralBandName, string>> = {
  'far-ultraviolet': 'FAR UV',
  'near-ultraviolet': 'NEAR UV',
  visible: 'VISIBLE',
  'near-infrared': 'NEAR IR',
  'thermal-infrared': 'THERMAL IR',
};

/** Height that the legend adds to a picture of this width [px]. */
export const falseColorLegendHeight = (width: number, kind: FalseColorQuantity): number =>
  colorBarHeight(textScale(width), kind === 'band' ? 2 : 1);

/** A picture with its legend below. */
export function withFalseColorLegend(picture: PixelCanvas, colors: FalseColorScale): PixelCanvas {
  const { width, height } = picture;
  const { kind, ...scale } = colors;
  const legend: ColorBar = {
    title: TITLES[kind],
    color: (part) => colorAt(kind, part, scale),
    rows: labelRows(colors),
  };
  const canvas = createCanvas(width, height + falseColorLegendHeight(width, kind), BACKGROUND);
  paste(canvas, picture, 0, 0);
  paste(canvas, drawColorBar(width, textScale(width), legend), 0, height);
  return canvas;
}

/** Values, both ends first, because labels that do not fit beside earlier ones are omitted; for bands also a row of names. */
function labelRows({ kind, ...scale }: FalseColorScale): ColorBar['rows'] {
  const at = (value: number, text: string) => ({ part: positionOnScale(kind, value, scale), text });
  const ticks = ticksOf(kind, scale);
  const digits = tickDigits(ticks);
  const plain = (value: number): string => String(Number(value.toPrecision(digits)));
  if (kind !== 'band') return [[scale.from, scale.to, ...ticks.slice(1, -1)].map((value) => at(value, plain(value)))];
  const names = SPECTRAL_BANDS.map(({ name, from }, i) => {
    const [start, end] = [Math.max(from, scale.from), Math.min(SPECTRAL_BANDS[i + 1]?.from ?? scale.to, scale.to)];
    return at(Math.sqrt(start * end), BAND_NAMES[name]);
  });
  // The visible band comes first, so that its label is never omitted.
  const visible = SPECTRAL_BANDS.findIndex(({ name }) => name === 'visible');
  return [ticks.map((value) => at(value, plain(value * 1e9))), [names[visible]!, ...names]];
}
