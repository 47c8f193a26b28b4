import { type Message, msg } from '../../../../messages/message.ts';
import type { Value } from '../../layer/layer.ts';
import { mapTime, type TimeOffset } from '../layers/timeOffset.ts';

/** A clip set, explicit or expanded from a template. */
export interface ClipTable {
  readonly assets: readonly string[];
  /** Stage time from which a clip is active, and its index. */
  readonly active: readonly TimeKnot[];
  /** Stage time, clip time. */
  readonly times: readonly TimeKnot[];
}
export type TimeKnot = readonly [time: number, other: number];

/** Maximum number of clips of one template. */
const MAX_CLIPS = 4096;

interface Template {
  readonly folder: string;
  /** Before, between and after the digits. */
  readonly parts: readonly string[];
  readonly digits: readonly number[];
}

/** `./fire.###.usda`, `./fire.##.##.usda`: one group of hashes, or two that are neighbours. */
function templateOf(written: string): Template | undefined {
  const cut = written.lastIndexOf('/') + 1;
  const tokens = written.slice(cut).split('.');
  const groups = tokens.flatMap((token, i) => (/^#+$/.test(token) ? [i] : []));
  if (groups.length === 0 || groups.length > 2 || groups[1] - groups[0] > 1) return undefined;
  const [first, last] = [groups[0], groups[groups.length - 1]];
  const parts = [tokens.slice(0, first).join('.'), tokens.slice(last + 1).join('.')];
  return { folder: written.slice(0, cut), parts, digits: groups.map((i) => tokens[i].length) };
}

function nameAt({ folder, parts: [before, after], digits }: Template, time: number): string | undefined {
  const [whole, decimals] = time.toFixed(digits[1] ?? 0).split('.');
  if (digits[1] === undefined && !Number.isInteger(time)) return undefined;
  const number = whole.startsWith('-')
    ? `-${whole.slice(1).padStart(digits[0] - 1, '0')}`
    : whole.padStart(digits[0], '0');
  const names = [before, number, ...(decimals === undefined ? [] : [decimals]), after];
  return folder + names.filter((part) => part !== '').join('.');
}

/**
 * Expands a template to its existing clips: one per step, active from its own time or `templateActiveOffset` later.
 * Returns a message for errors in the template.
 */
export function tableOfTemplate(
  entries: ReadonlyMap<string, Value>,
  isThere: (asset: string) => boolean,
  layerTime: TimeOffset,
): ClipTable | Message {
  const number = (key: string): number | undefined => {
    const value = entries.get(`template${key}`);
    return value && 'data' in value && typeof value.data === 'number' ? value.data : undefined;
  };
  const [start, end, stride, offset] = ['StartTime', 'EndTime', 'Stride', 'ActiveOffset'].map(number);
  const written = entries.get('templateAssetPath');
  const text = written?.type === 'string' || written?.type === 'asset' ? written.data : '';
  const template = templateOf(text);
  if (!template) return msg`its templateAssetPath '${text}' has no group of # between dots, or more than two`;
  if (start === undefined || end === undefined || stride === undefined)
    return msg`it has no templateStartTime, templateEndTime or templateStride`;
  if (!(stride > 0) || !(start <= end) || !Number.isFinite(end - start))
    return msg`its template goes from ${start} to ${end} in steps of ${stride}, which does not end`;
  if ((end - start) / stride >= MAX_CLIPS) return msg`its template stands for more than ${MAX_CLIPS} clips`;
  if (offset !== undefined && Math.abs(offset) > stride)
    return msg`its templateActiveOffset ${offset} is more than the stride ${stride}`;
  const made = clipsOf(template, isThere, { start, end, stride, offset });
  const mapped = (knots: readonly TimeKnot[]): TimeKnot[] =>
    knots.map(([time, other]) => [mapTime(layerTime, time), other]);
  return { assets: made.assets, active: mapped(made.active), times: mapped(made.times) };
}

interface TemplateSteps {
  readonly start: number;
  readonly end: number;
  readonly stride: number;
  readonly offset: number | undefined;
}

function clipsOf(
  template: Template,
  isThere: (asset: string) => boolean,
  { start, end, stride, offset }: TemplateSteps,
): ClipTable {
  const assets: string[] = [];
  const active: TimeKnot[] = [];
  const times: TimeKnot[] = [];
  const reach = Math.abs(offset ?? 0);
  if (offset !== undefined) times.push([start - reach, start - reach]);
  for (let i = 0; start + i * stride <= end; i++) {
    const time = start + i * stride;
    const asset = nameAt(template, time);
    if (asset === undefined || !isThere(asset)) continue;
    active.push([time + (offset ?? 0), assets.length]);
    times.push([time, time]);
    if (offset !== undefined) times.push([time + offset, time + offset]);
    assets.push(asset);
  }
  if (offset !== undefined) times.push([end + reach, end + reach]);
  return { assets, active, times };
}
