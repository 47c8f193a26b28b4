import { msg } from '../../../../messages/message.ts';
import { subsampleEvenly } from '../../../read/subsample.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, lowerSample, numbersOf, sampleTimes } from '../../layer/attributes.ts';
import type { AttributeSpec, NumberArray, PrimSpec, Value } from '../../layer/layer.ts';
import { metadataNumber } from '../../layer/query.ts';
import type { StageContext } from '../context.ts';
import { unionOfTimes } from '../transforms/xformOps.ts';
import { countIn, haveOneCount, topologyArrays } from './topology.ts';

/** One of the meshes that take turns where a topology changes: a run of samples with the same faces of as many points. */
export interface MeshPiece {
  /** Time code at which its faces, and what they wear, are read. */
  readonly at: number;
  /** It lives in [from, until) [time codes], the first from −∞ and the last to ∞. */
  readonly from: number;
  readonly until: number;
  /** Codes of its points' samples, between which they go straight; before the first they rest. */
  readonly codes: Float64Array;
  /**
   * What its points do after the last of `codes`: they rest; they keep the velocities that the file has for them, or accelerate as it says, until `end`; or they go straight to where the
   * next piece has them, because all pieces have the same points.
   */
  readonly after: 'rest' | 'velocities' | 'straight';
  /** Until when they do that [time code]. */
  readonly end: number;
}

/** Most pieces of a mesh. */
export const MAX_PIECES = 4096;

/** Memory of a piece per corner of its faces, at most a vertex each [bytes]: place, normal, uv, colour and index; and two samples, if it moves. */
const CORNER_BYTES = 48;
const MOVING_CORNER_BYTES = 96;

/** The pieces of a mesh whose topology changes, in the order of their times; undefined if it has one topology at all times, even if that is sampled. */
export function meshPieces(context: StageContext, prim: PrimSpec): readonly MeshPiece[] | undefined {
  const starts = pieceStarts(prim);
  if (starts.length < 2) return undefined;
  const kept = affordableStarts(context, prim, starts);
  const points = attributeOf(prim, 'points');
  const pointCodes = sampleTimes(points);
  const samePoints = haveOneCount(points);
  const lastCode = metadataNumber(context.layer.metadata, 'endTimeCode') ?? Number.NEGATIVE_INFINITY;
  return Array.from(kept, (start, i): MeshPiece => {
    const [from, until] = [i === 0 ? Number.NEGATIVE_INFINITY : start, kept[i + 1] ?? Number.POSITIVE_INFINITY];
    const own = pointCodes.filter((code) => code >= from && code < until);
    const codes = own.length > 0 && (i === 0 || own[0] === start) ? own : Float64Array.of(start, ...own);
    const last = codes[codes.length - 1];
    const alone = { at: Math.min(start, codes[0]), from, until, codes };
    const end = Number.isFinite(until) ? until : lastCode;
    if (end > last && hasVelocities(prim, last)) return { ...alone, after: 'velocities', end };
    if (!samePoints || pointCodes.length === 0) return { ...alone, after: 'rest', end: last };
    return { ...alone, after: 'straight', end: Math.max(last, Math.min(until, pointCodes[pointCodes.length - 1])) };
  });
}

/** What is said of a mesh that is drawn as so many pieces. */
export function reportPieces(context: StageContext, prim: PrimSpec, pieces: readonly MeshPiece[]): void {
  const isMoving = sampleTimes(attributeOf(prim, 'points')).length > 0;
  const rests = ({ after, codes }: MeshPiece): boolean =>
    after === 'rest' && codes.length === 1 && !hasVelocities(prim, codes[0]);
  const resting = isMoving ? pieces.filter(rests).length : 0;
  const [name, n] = ['usd.topology', pieces.length] as const;
  if (n < 2) return;
  if (resting === 0)
    report(
      context,
      'info',
      name,
      prim.path,
      msg`its topology changes: ${n} meshes take turns, each alive until the next`,
    );
  else {
    const message = msg`its topology changes: ${n} meshes take turns, each alive until the next; ${resting} of them have no velocities, so they rest while they live and show no Doppler effect of their own (write velocities)`;
    report(context, 'warning', name, prim.path, message);
  }
}

/** Codes at which the faces, the number of points, or the faces of a subset become others; first that of the first sample. */
function pieceStarts(prim: PrimSpec): Float64Array {
  const points = attributeOf(prim, 'points');
  const arrays = topologyArrays(prim);
  const changing = [...arrays, ...(haveOneCount(points) ? [] : [points])];
  const starts: number[] = [];
  let before: readonly (Value | undefined)[] | undefined;
  for (const code of unionOfTimes(changing.map(sampleTimes))) {
    const now = [...arrays.map((attribute) => heldValue(attribute, code)), heldValue(points, code)];
    const isSame = before?.every((value, i) =>
      i < arrays.length ? haveSameNumbers(value, now[i]) : countIn(value) === countIn(now[i]),
    );
    if (!isSame) starts.push(code);
    before = now;
  }
  return Float64Array.from(starts);
}

function heldValue(attribute: AttributeSpec | undefined, code: number): Value | undefined {
  const samples = attribute?.timeSamples;
  return samples && samples.times.length > 0 ? samples.values[lowerSample(samples.times, code)] : attribute?.value;
}

function haveSameNumbers(a: Value | undefined, b: Value | undefined): boolean {
  const [p, q] = [numbersOf(a), numbersOf(b)];
  if (a === b || p === q) return true;
  return p !== undefined && q !== undefined && p.length === q.length && p.every((x, i) => x === q[i]);
}

const hasVelocities = (prim: PrimSpec, code: number): boolean => ratesAt(prim, 'velocities', code) !== undefined;

/** The velocities or accelerations at a sample of the points; undefined unless there is one for each point. */
export function ratesAt(prim: PrimSpec, name: 'velocities' | 'accelerations', code: number): NumberArray | undefined {
  const [points, rates] = [attributeOf(prim, 'points'), attributeOf(prim, name)];
  const samples = rates?.timeSamples;
  const isThere = !samples || samples.times.length === 0 || samples.times.includes(code);
  const value = heldValue(rates, code);
  return isThere && countIn(value) === countIn(heldValue(points, code)) ? numbersOf(value) : undefined;
}

/** The starts of as many pieces as there is room for, evenly chosen; their memory is subtracted from the scene's. */
function affordableStarts(context: StageContext, prim: PrimSpec, starts: Float64Array): Float64Array {
  const indices = attributeOf(prim, 'faceVertexIndices');
  const perCorner = attributeOf(prim, 'velocities') ? MOVING_CORNER_BYTES : CORNER_BYTES;
  const bytes = (of: Float64Array): number =>
    of.reduce((sum, code) => sum + perCorner * countIn(heldValue(indices, code)), 0);
  const share = Math.min(1, context.pointBudget.bytes / Math.max(1, bytes(starts)));
  const kept = subsampleEvenly(starts, Math.max(2, Math.min(MAX_PIECES, Math.floor(share * starts.length))));
  context.pointBudget.bytes = Math.max(0, context.pointBudget.bytes - bytes(kept));
  if (kept.length < starts.length) {
    const message = msg`its topology changes ${starts.length} times, more than there is room for; ${kept.length} of its shapes are shown, each until the next (write fewer samples, or smaller ones)`;
    report(context, 'warning', 'usd.sample-budget', prim.path, message);
  }
  return kept;
}
