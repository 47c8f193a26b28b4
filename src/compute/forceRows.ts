import type { BarrierData, ForceData, NeighborForceData, PairForceData } from '../dynamics/forces/force.ts';
import type { Obstacle } from '../dynamics/forces/obstacle.ts';
import { type System, SystemError } from '../dynamics/system.ts';
import { msg } from '../messages/message.ts';

/**
 * All forces in a form for the GPU: each point sums a row of its own, so that there are no write conflicts. A spring is
 * in the rows of both ends; an obstacle in those of all points that it stops; pinned points have empty rows. Rows are
 * reordered: long rows come last, since the threads of a workgroup share each of these.
 */
export interface ForceRows {
  readonly pointOfRow: Uint32Array;
  readonly rowOfPoint: Uint32Array;
  /** Number of long rows. */
  readonly longRowCount: number;
  /** Start of each row; one more at the end. */
  readonly rowStarts: Uint32Array;
  /** Number of springs of each row; they come first. */
  readonly springCounts: Uint32Array;
  /** Of each link: row of the other end, or an obstacle; its law; strength and length as bits of 32-bit floats. */
  readonly words: Uint32Array<ArrayBuffer>;
  readonly obstacles: readonly Obstacle[];
  /** Constant forces: x, y, z by row [N]. */
  readonly constantForces: Float32Array;
  /** Forces between points that come near. */
  readonly near: NeighborForceData | undefined;
}

/** As in the shader. */
const LAW_CODES = { spring: 0, penalty: 1, 'inverse-square': 2, barrier: 3 } as const;
export const WORDS_PER_LINK = 4;
/** Rows with more links than this are long. */
const LONG_ROW = 64;

/** Throws a SystemError for forces that the GPU does not support. */
export function forceRowsOf({ forces, masses, pinned, kinematic: led = [] }: System): ForceRows {
  if (led.length > 0) throw new SystemError(msg`objects with prescribed motion are not supported on the GPU`);
  const all = forces.map((force) => force.data);
  const plain = [...all.filter(({ kind }) => kind === 'spring'), ...all.filter(({ kind }) => kind !== 'spring')];
  const nears = plain.filter(({ kind }) => kind === 'near');
  if (nears.length > 1) throw new SystemError(msg`points have several contact laws; the GPU supports one`);
  const barriers = plain.filter(({ kind }) => kind === 'barrier') as BarrierData[];
  const obstacles = [...new Set(barriers.map(({ obstacle }) => obstacle))];
  const tell = (of: LinkVisitor): void =>
    eachLink(plain, obstacles, (point, ...link) => !pinned[point] && of(point, ...link));

  const counts = new Uint32Array(masses.length);
  tell((point) => counts[point]++);
  const { pointOfRow, rowOfPoint: placeOf, longRowCount } = rowOrder(counts);
  const from = new Uint32Array(masses.length + 1);
  pointOfRow.forEach((point, place) => {
    from[place + 1] = from[place] + counts[point];
  });
  const words = new Uint32Array(WORDS_PER_LINK * from[masses.length]);
  const numbers = new Float32Array(words.buffer);
  const free = from.slice();
  const springs = new Uint32Array(masses.length);
  tell((point, other, law, strength, length) => {
    const at = WORDS_PER_LINK * free[placeOf[point]]++;
    words[at] = law === LAW_CODES.barrier ? other : placeOf[other];
    words[at + 1] = law;
    if (law === LAW_CODES.spring) springs[placeOf[point]]++;
    numbers[at + 2] = strength;
    numbers[at + 3] = length;
  });
  return {
    ...{ pointOfRow, rowOfPoint: placeOf, longRowCount, rowStarts: from, springCounts: springs, words, obstacles },
    constantForces: constantForcesOf(plain, pointOfRow),
    near: nears[0] as NeighborForceData | undefined,
  };
}

type LinkVisitor = (point: number, other: number, law: number, strength: number, length: number) => void;

function eachLink(forces: readonly ForceData[], obstacles: readonly Obstacle[], tell: LinkVisitor): void {
  for (const force of forces) {
    if (force.kind === 'barrier') {
      const which = obstacles.indexOf(force.obstacle);
      for (const point of force.points) tell(point, which, LAW_CODES.barrier, force.strength, force.margin);
    } else if (force.kind !== 'uniform' && force.kind !== 'near') eachPair(force, tell);
  }
}

function eachPair({ kind, ends, strengths, lengths }: PairForceData, tell: LinkVisitor): void {
  for (let s = 0; s < strengths.length; s++) {
    tell(ends[2 * s], ends[2 * s + 1], LAW_CODES[kind], strengths[s], lengths[s]);
    tell(ends[2 * s + 1], ends[2 * s], LAW_CODES[kind], strengths[s], lengths[s]);
  }
}

/** Short rows first; otherwise in the original order. */
function rowOrder(counts: Uint32Array): Pick<ForceRows, 'pointOfRow' | 'rowOfPoint' | 'longRowCount'> {
  const all = Array.from(counts, (_, point) => point);
  const long = all.filter((point) => counts[point] > LONG_ROW);
  const pointAt = Uint32Array.from([...all.filter((point) => counts[point] <= LONG_ROW), ...long]);
  const placeOf = new Uint32Array(counts.length);
  pointAt.forEach((point, place) => {
    placeOf[point] = place;
  });
  return { pointOfRow: pointAt, rowOfPoint: placeOf, longRowCount: long.length };
}

function constantForcesOf(forces: readonly ForceData[], pointAt: Uint32Array): Float32Array {
  const pull = new Float64Array(3 * pointAt.length);
  for (const force of forces)
    if (force.kind === 'uniform')
      pointAt.forEach((point, place) => {
        for (let k = 0; k < 3; k++) pull[3 * place + k] += force.amounts[point] * force.field[k];
      });
  return Float32Array.from(pull);
}

/** Pairs, from both ends, by row: start of each row, one more, and then the rows of the neighbours. */
export function neighborRows(placeOf: Uint32Array, ends: Uint32Array): Uint32Array<ArrayBuffer> {
  const count = placeOf.length;
  const rows = new Uint32Array(count + 1 + ends.length);
  for (const end of ends) rows[placeOf[end] + 1]++;
  for (let i = 0; i < count; i++) rows[i + 1] += rows[i];
  const free = rows.slice(0, count);
  for (let s = 0; s < ends.length; s++) rows[count + 1 + free[placeOf[ends[s]]]++] = placeOf[ends[s ^ 1]];
  return rows;
}
