import { distance } from '../../../../math/vec3.ts';
import { pointAt } from '../../../../scene/mesh/polygons.ts';
import type { Mesh } from '../../../../scene/types.ts';
import { attributeOf, numbersAt, sampleTimes } from '../../layer/attributes.ts';
import type { NumberArray, PrimSpec } from '../../layer/layer.ts';
import type { StageContext } from '../context.ts';
import type { DeformedPoints, PrimGeometry } from '../geometry/primGeometry.ts';
import { unionOfTimes } from '../transforms/xformOps.ts';
import { type MeshPiece, ratesAt } from './meshPieces.ts';

/** How far points are moved on beyond the life of their piece, relative to its longest edge, and how long, relative to that life. */
const MARGIN_EDGES = 8;
const MARGIN_LIVES = 100;

/** Straight pieces of a path under acceleration. */
const ACCELERATED_CHORDS = 4;

/**
 * The mesh of a piece with its motion; `pointsFor` maps the prim's points at a time to its vertices. The motion goes on before its birth and after its death: of
 * a triangle of which a part is seen alive, corners are seen earlier or later, and the renderer interpolates their velocities.
 */
export function pieceGeometry(
  { codesPerSecond }: Pick<StageContext, 'codesPerSecond'>,
  prim: PrimSpec,
  mesh: Mesh,
  piece: MeshPiece,
  pointsFor: (points: ArrayLike<number>, time: number) => DeformedPoints,
): PrimGeometry {
  const { codes, after, end } = piece;
  const [first, last] = [codes[0], codes[codes.length - 1]];
  const velocities = after === 'velocities' ? ratesAt(prim, 'velocities', last) : undefined;
  const accelerations = velocities && ratesAt(prim, 'accelerations', last);
  const count = accelerations ? ACCELERATED_CHORDS : 1;
  const chords = Float64Array.from({ length: count }, (_, k) => last + ((end - last) * (k + 1)) / count);
  const lasting = after === 'rest' || end === last ? codes : unionOfTimes([codes, chords]);
  if (lasting.length < 2) return { mesh };
  const rate =
    codes.length === 1
      ? velocities
      : chordVelocities(pointsOf(prim, first), pointsOf(prim, codes[1]), codes[1] - first);
  const toCodes = codes.length === 1 ? 1 / codesPerSecond : 1;
  const pointsAt = (time: number): ArrayLike<number> => {
    if (after === 'straight') return pointsOf(prim, time);
    if (time < first && rate) return movedPoints(pointsOf(prim, first), rate, (time - first) * toCodes);
    if (time <= last) return pointsOf(prim, time);
    const points = pointsOf(prim, last);
    if (!velocities) return points;
    const [within, beyond] = [Math.min(time, end) - last, Math.max(0, time - end)].map((dt) => dt / codesPerSecond);
    return accelerations
      ? acceleratedPoints(points, velocities, accelerations, within, beyond)
      : movedPoints(points, velocities, within + beyond);
  };
  const at = (time: number): DeformedPoints => {
    const placed = pointsFor(pointsAt(time), Math.max(first, Math.min(time, last)));
    // Of one sample, the normals keep their directions while the points move on.
    return codes.length === 1 && velocities ? { ...placed, normals: mesh.normals.slice() } : placed;
  };
  const margin = velocities ? marginOf(mesh, velocities, codesPerSecond, end - first) : 0;
  const beyond =
    after === 'straight'
      ? neighbours(sampleTimes(attributeOf(prim, 'points')), first, end)
      : margin > 0
        ? Float64Array.from(
            [first - margin, end + margin].filter((_, i) => Number.isFinite(i ? piece.until : piece.from)),
          )
        : NO_TIMES;
  return { mesh, deformation: { times: unionOfTimes([lasting, beyond]), at } };
}

const NO_TIMES = new Float64Array(0);

/** The last sample before a time and the first one after another. */
const neighbours = (times: Float64Array, from: number, to: number): Float64Array =>
  Float64Array.of(...times.filter((time) => time < from).slice(-1), ...times.filter((time) => time > to).slice(0, 1));

const pointsOf = (prim: PrimSpec, time: number): NumberArray => numbersAt(prim, 'points', time)!;

const movedPoints = (points: NumberArray, velocities: ArrayLike<number>, time: number): Float64Array =>
  Float64Array.from(points, (x, i) => x + velocities[i] * time);

/** After a time under acceleration, and then at the velocity reached [s]. */
const acceleratedPoints = (
  points: NumberArray,
  velocities: NumberArray,
  accelerations: NumberArray,
  time: number,
  beyond: number,
): Float64Array =>
  Float64Array.from(
    points,
    (x, i) => x + velocities[i] * (time + beyond) + accelerations[i] * time * (time / 2 + beyond),
  );

const chordVelocities = (from: NumberArray, to: NumberArray, time: number): Float64Array =>
  Float64Array.from(from, (x, i) => (to[i] - x) / time);

/** [time codes] The corners of a triangle that moves at up to 8/9 c are seen within less, because none is as fast as light. */
function marginOf({ positions, indices }: Mesh, velocities: NumberArray, codesPerSecond: number, life: number): number {
  let longest = 0;
  for (let i = 0; i < indices.length; i++) {
    const next = i % 3 === 2 ? i - 2 : i + 1;
    longest = Math.max(longest, distance(pointAt(positions, indices[i]), pointAt(positions, indices[next])));
  }
  let fastest = 0;
  for (let i = 0; i < velocities.length; i += 3)
    fastest = Math.max(fastest, Math.hypot(velocities[i], velocities[i + 1], velocities[i + 2]));
  if (!(fastest > 0)) return 0;
  const crossing = (MARGIN_EDGES * longest * codesPerSecond) / fastest;
  return Math.min(crossing, MARGIN_LIVES * life);
}
