import type { ChannelDifference } from '../../reference/compare/aovDifference.ts';
import type { ErrorSummary } from '../../reference/compare/statistics.ts';
import type { AovFindings, Findings, FlipFindings, PixelFindings } from './metrics.ts';

interface ComparisonHeader {
  readonly a: string;
  readonly b: string;
  readonly width: number;
  readonly height: number;
}

/** The findings as lines of text. */
export function compareLines({ a, b, width, height }: ComparisonHeader, findings: Findings): string[] {
  const head = `${titles[findings.metric]}: ${a} against ${b}, ${width} × ${height} pixels`;
  if (findings.metric === 'aov') return [head, ...aovLines(findings, width * height)];
  const more = findings.metric === 'flip' ? exposureLines(findings) : noiseLines(findings);
  const rows = [
    ['mean', number(findings.mean)],
    ['99 of 100 pixels are at most', number(findings.p99)],
    ['largest', number(findings.max)],
    [`above ${findings.threshold}`, `${percent(findings.share)} of the pixels`],
    ...more,
  ];
  return [head, ...columns(rows, 2)];
}

const titles = { flip: 'FLIP', pixels: 'Difference of pixels', aov: 'Difference of channels' } as const;

const exposureLines = ({ exposures }: FlipFindings): string[][] =>
  exposures ? [['exposures', `${exposures.count}, ${number(exposures.start)} … ${number(exposures.stop)} EV`]] : [];

const noiseLines = ({ rmse, psnr }: PixelFindings): string[][] => [
  ['root of the mean square', number(rmse)],
  ['peak signal to noise', Number.isFinite(psnr) ? `${psnr.toFixed(2)} dB` : 'nothing differs'],
];

function aovLines(findings: AovFindings, pixels: number): string[] {
  const { channels, onlyA, onlyB, otherObject, displacement, channel } = findings;
  const heading = ['channel', 'mean', '99 %', 'largest', 'relative: mean', '99 %', 'largest', 'pixels', ''];
  const facts = [
    ...(otherObject === undefined
      ? []
      : [['another object', `${otherObject} pixels, ${percent(otherObject / pixels)}`]]),
    ...(displacement ? displacementRows(displacement) : []),
    ...(channel ? [[`${channel.name} above ${channel.threshold}`, `${percent(channel.share)} of the pixels`]] : []),
    ...(onlyA.length > 0 ? [['only in A', onlyA.join(', ')]] : []),
    ...(onlyB.length > 0 ? [['only in B', onlyB.join(', ')]] : []),
  ];
  const table = channels.length > 0 ? columns([heading, ...channels.map(channelRow)], 2) : [];
  return [...table, ...(table.length > 0 && facts.length > 0 ? [''] : []), ...columns(facts, 2)];
}

const channelRow = ({ name, pixels, notFinite, absolute, relative }: ChannelDifference): string[] => [
  name,
  ...summaryCells(absolute),
  ...summaryCells(relative),
  String(pixels),
  notFinite > 0 ? `${notFinite} not finite` : '',
];

const summaryCells = (summary: ErrorSummary | undefined): string[] =>
  [summary?.mean, summary?.p99, summary?.max].map(number);

function displacementRows(found: NonNullable<AovFindings['displacement']>): string[][] {
  const { mean, p99, max, threshold, share, measured, lost } = found;
  return [
    ['displacement', `mean ${number(mean)} px, 99 % at most ${number(p99)} px, largest ${number(max)} px`],
    [
      `beyond ${threshold} px`,
      `${percent(share)} of ${measured + lost} pixels; of these without a counterpart within a pixel: ${lost}`,
    ],
  ];
}

const number = (value: number | undefined): string =>
  value === undefined ? '–' : String(Number(value.toPrecision(4)));
/** 0.0123 → `1.23 %` */
export const percent = (share: number): string => `${Number((100 * share).toPrecision(3))} %`;

/** Pads the cells of rows into columns. */
function columns(rows: readonly (readonly string[])[], indent: number): string[] {
  const width = (k: number) => Math.max(...rows.map((row) => row[k]?.length ?? 0));
  return rows.map((row) => (' '.repeat(indent) + row.map((cell, k) => cell.padEnd(width(k))).join('  ')).trimEnd());
}
