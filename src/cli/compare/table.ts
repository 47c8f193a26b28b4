import { type LocalizedText, listed, msg } from '../../messages/message.ts';
import type { ChannelDifference } from '../../reference/compare/aovDifference.ts';
import type { ErrorSummary } from '../../reference/compare/statistics.ts';
import { columns, type Row } from '../terminal/columns.ts';
import { localized } from '../terminal/language.ts';
import type { AovFindings, Findings, FlipFindings, PixelFindings } from './metrics.ts';

interface ComparisonHeader {
  readonly a: string;
  readonly b: string;
  readonly width: number;
  readonly height: number;
}

/** The findings as lines of text. */
export function compareLines({ a, b, width, height }: ComparisonHeader, findings: Findings): string[] {
  const head = localized(msg`${TITLES[findings.metric]}: ${a} against ${b}, ${width} × ${height} pixels`);
  if (findings.metric === 'aov') return [head, ...aovLines(findings, width * height)];
  const more = findings.metric === 'flip' ? exposureLines(findings) : noiseLines(findings);
  const rows: Row[] = [
    [msg`mean`, number(findings.mean)],
    [msg`99 of 100 pixels are at most`, number(findings.p99)],
    [msg`largest`, number(findings.max)],
    [msg`above ${findings.threshold}`, msg`${percent(findings.share)} of the pixels`],
    ...more,
  ];
  return [head, ...columns(rows, 2)];
}

const TITLES: Readonly<Record<Findings['metric'], LocalizedText>> = {
  flip: 'FLIP',
  pixels: msg`Difference of pixels`,
  aov: msg`Difference of channels`,
};

const exposureLines = ({ exposures }: FlipFindings): Row[] =>
  exposures
    ? [[msg`exposures`, msg`${exposures.count}, ${number(exposures.start)} … ${number(exposures.stop)} EV`]]
    : [];

const noiseLines = ({ rmse, psnr }: PixelFindings): Row[] => [
  [msg`root of the mean square`, number(rmse)],
  [msg`peak signal to noise`, Number.isFinite(psnr) ? `${psnr.toFixed(2)} dB` : msg`nothing differs`],
];

function aovLines(findings: AovFindings, pixels: number): string[] {
  const { channels, onlyA, onlyB, otherObject, displacement, channel } = findings;
  const heading = [
    msg`channel`,
    msg`mean`,
    '99 %',
    msg`largest`,
    msg`relative: mean`,
    '99 %',
    msg`largest`,
    msg`pixels`,
    '',
  ];
  const facts: Row[] = [
    ...(otherObject === undefined
      ? []
      : [[msg`another object`, msg`${otherObject} pixels, ${percent(otherObject / pixels)}`]]),
    ...(displacement ? displacementRows(displacement) : []),
    ...(channel
      ? [[msg`${channel.name} above ${channel.threshold}`, msg`${percent(channel.share)} of the pixels`]]
      : []),
    ...(onlyA.length > 0 ? [[msg`only in A`, listed(onlyA)]] : []),
    ...(onlyB.length > 0 ? [[msg`only in B`, listed(onlyB)]] : []),
  ];
  const table = channels.length > 0 ? columns([heading, ...channels.map(channelRow)], 2) : [];
  return [...table, ...(table.length > 0 && facts.length > 0 ? [''] : []), ...columns(facts, 2)];
}

const channelRow = ({ name, pixels, notFinite, absolute, relative }: ChannelDifference): Row => [
  name,
  ...summaryCells(absolute),
  ...summaryCells(relative),
  String(pixels),
  notFinite > 0 ? msg`${notFinite} not finite` : '',
];

const summaryCells = (summary: ErrorSummary | undefined): string[] =>
  [summary?.mean, summary?.p99, summary?.max].map(number);

function displacementRows(found: NonNullable<AovFindings['displacement']>): Row[] {
  const { mean, p99, max, threshold, share, measured, lost } = found;
  return [
    [msg`displacement`, msg`mean ${number(mean)} px, 99 % at most ${number(p99)} px, largest ${number(max)} px`],
    [
      msg`beyond ${threshold} px`,
      msg`${percent(share)} of ${measured + lost} pixels; of these without a counterpart within a pixel: ${lost}`,
    ],
  ];
}

const number = (value: number | undefined): string =>
  value === undefined ? '–' : String(Number(value.toPrecision(4)));
/** 0.0123 → `1.23 %` */
export const percent = (share: number): string => `${Number((100 * share).toPrecision(3))} %`;
