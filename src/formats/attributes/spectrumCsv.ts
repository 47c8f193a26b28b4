import { type LocalizedText, type Message, msg } from '../../messages/message.ts';
import type { MeasuredReflectance } from '../../spectrum/reflectance/measuredReflectance.ts';
import type { SampledSpectrum } from '../../spectrum/sources/lightSpectrum.ts';
import { inputError } from '../diagnostics/inputError.ts';
import { textLines } from '../files/textLines.ts';

/** Accepted wavelengths [nm]: X-rays to the far infrared. */
const WAVELENGTH_RANGE = [1, 100_000] as const;
/** Maximum number of rows of a table and samples of a spectrum. */
const MAX_TABLE_ROWS = 100_000;
const MAX_SAMPLES = 4096;
/** Minimum step [nm]: finer is not visible, and spectral lines are wider in a table. */
const MIN_STEP = 0.25;

interface SpectrumRow {
  readonly nanometres: number;
  readonly value: number;
}

/**
 * A spectrum from text: a wavelength [nm] and a relative radiance per wavelength in each line, by rising wavelength, between them a comma,
 * a semicolon, a tab or blanks (a decimal comma is read where it is not the comma between them). Lines that start with `#`, empty ones and
 * one heading are left out; negative values, of noise, count as 0. Steps that are not even become so, with the light of each kept.
 * Throws an InputError that names the line.
 * @example
 * const csv = new TextEncoder().encode('# a lamp\n500, 0.2\n510, 0.8\n520, 0.4\n');
 * const { first, step, values } = readSpectrumCsv(csv, 'lamp.csv');
 * first; // 500.0e-9 m
 * step; // 10.0e-9 m
 * values; // [0.2, 0.8, 0.4]
 */
export function readSpectrumCsv(bytes: Uint8Array, name: string): SampledSpectrum {
  const rows: SpectrumRow[] = [];
  for (const { number, text } of textLines(bytes, name)) {
    const fail = (message: Message): Error => damaged(msg`${name}: line ${number}`, message);
    if (rows.length === MAX_TABLE_ROWS) throw fail(msg`there are more than ${MAX_TABLE_ROWS} rows`);
    const words = wordsOf(text);
    if (words.length === 0) continue;
    const row = rowOf(words);
    if (row) rows.push(checked(row, rows.at(-1), fail));
    else if (rows.length > 0) throw fail(msg`"${text.slice(0, 40)}" is not two numbers`);
  }
  if (rows.length < 2) throw damaged(name, msg`it has fewer than two rows of a wavelength in nm and a value`);
  if (rows.every(({ value }) => value === 0)) throw damaged(name, msg`all of its values are 0`);
  return evenlySampled(rows);
}

/** A reflectance, 0 … 1 at each wavelength, from text as `readSpectrumCsv` takes it. Throws an InputError. */
export function readReflectanceCsv(bytes: Uint8Array, name: string): MeasuredReflectance {
  const { first, step, values } = readSpectrumCsv(bytes, name);
  const most = values.reduce((a, b) => Math.max(a, b));
  if (most > 1)
    throw damaged(name, msg`its greatest value is ${most}, and no more than 1 is reflected; divide percents by 100`);
  return { first, step, values };
}

/** As `readSpectrumCsv` reads it. */
export function writeSpectrumCsv({ first, step, values }: MeasuredReflectance, of = 'relative radiance'): Uint8Array {
  const rows = values.map((value, i) => `${Number(((first + i * step) * 1e9).toPrecision(9))}, ${value}`);
  return new TextEncoder().encode([`# wavelength [nm], ${of}`, ...rows, ''].join('\n'));
}

const damaged = (place: LocalizedText, message: Message) =>
  inputError('spectrum.csv', place, msg`${message}; a spectrum is lines such as "550, 0.87", wavelengths in nm rising`);

function wordsOf(text: string): string[] {
  const line = text.replace(/^\uFEFF/, '').trim();
  if (line === '' || line.startsWith('#')) return [];
  if (!/[;\t]/.test(line)) return line.split(/[\s,]+/);
  return line.split(/[;\t]/).map((word) => word.trim().replace(',', '.'));
}

/** The first two words as numbers; undefined where they are not numbers. */
function rowOf([wavelength, value]: string[]): SpectrumRow | undefined {
  if (!wavelength || !value) return undefined;
  const row = { nanometres: Number(wavelength), value: Number(value) };
  return Number.isFinite(Math.fround(row.nanometres)) && Number.isFinite(Math.fround(row.value)) ? row : undefined;
}

function checked(
  { nanometres, value }: SpectrumRow,
  before: SpectrumRow | undefined,
  fail: (message: Message) => Error,
): SpectrumRow {
  if (nanometres < WAVELENGTH_RANGE[0] || nanometres > WAVELENGTH_RANGE[1])
    throw fail(msg`${nanometres} nm is not between ${WAVELENGTH_RANGE[0]} and ${WAVELENGTH_RANGE[1]} nm`);
  if (before && nanometres <= before.nanometres) throw fail(msg`${nanometres} nm comes after ${before.nanometres} nm`);
  return { nanometres, value: Math.max(value, 0) };
}

/** The rows unchanged if evenly spaced, else resampled to an even step by mean. */
function evenlySampled(rows: readonly SpectrumRow[]): SampledSpectrum {
  const [first, last] = [rows[0].nanometres, rows[rows.length - 1].nanometres];
  const gaps = rows.slice(1).map(({ nanometres }, i) => nanometres - rows[i].nanometres);
  const even = (last - first) / gaps.length;
  const isEven = rows.length <= MAX_SAMPLES && gaps.every((gap) => Math.abs(gap - even) < 1e-3 * even);
  if (isEven)
    return spectrum(
      first,
      even,
      rows.map(({ value }) => value),
    );
  const narrowest = gaps.reduce((least, gap) => Math.min(least, gap));
  const wanted = Math.max(narrowest, MIN_STEP, (last - first) / (MAX_SAMPLES - 1));
  const count = Math.max(Math.round((last - first) / wanted), 1) + 1;
  const step = (last - first) / (count - 1);
  return spectrum(first, step, means(rows, first, step, Math.min(count, MAX_SAMPLES)));
}

const spectrum = (first: number, step: number, values: readonly number[]): SampledSpectrum => ({
  kind: 'sampled',
  first: first / 1e9,
  step: step / 1e9,
  values,
});

/** Mean of the linear interpolation over half a step to each side of each sample. */
function means(rows: readonly SpectrumRow[], first: number, step: number, count: number): number[] {
  const integralUpTo = runningIntegral(rows);
  const last = rows[rows.length - 1].nanometres;
  const ends = Array.from({ length: count + 1 }, (_, i) => Math.min(Math.max(first + (i - 0.5) * step, first), last));
  const integrals = ends.map(integralUpTo);
  return Array.from({ length: count }, (_, i) => (integrals[i + 1] - integrals[i]) / (ends[i + 1] - ends[i]));
}

/** Running integral of the rows up to a wavelength, for non-decreasing arguments. */
function runningIntegral(rows: readonly SpectrumRow[]): (nanometres: number) => number {
  let [i, sum] = [0, 0];
  return (nanometres) => {
    while (i < rows.length - 2 && rows[i + 1].nanometres <= nanometres) {
      sum += ((rows[i].value + rows[i + 1].value) / 2) * (rows[i + 1].nanometres - rows[i].nanometres);
      i++;
    }
    const [a, b] = [rows[i], rows[i + 1]];
    const within = nanometres - a.nanometres;
    const slope = (b.value - a.value) / (b.nanometres - a.nanometres);
    return sum + within * (a.value + (slope * within) / 2);
  };
}
