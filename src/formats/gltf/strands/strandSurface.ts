import { transform, transpose } from '../../../math/mat3.ts';
import { dot, normalize, sub, type Vec3 } from '../../../math/vec3.ts';
import { pointAt } from '../../../scene/mesh/polygons.ts';
import { type CurveRun, tubeFaces, tubePoints } from '../../read/strands/sweep.ts';
import { LINE_LOOP, LINES, POINTS, type StrandFrame } from './strandPlan.ts';

/** Spheres or tubes in the axes of the mesh, as triangles. */
export interface StrandSurface {
  /** 3 numbers per vertex. */
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly indices: Uint32Array;
  /** By vertex: the vertex of the file that it belongs to. */
  readonly source: Uint32Array;
}

/** A line through vertices of the file. */
interface StrandLine {
  readonly vertices: readonly number[];
  readonly closed: boolean;
}

/** The surface of a primitive of points or lines; `corners`: its vertices in order, `points`: where they are, 3 numbers each. */
export function strandSurface(
  mode: number,
  corners: Uint32Array,
  points: ArrayLike<number>,
  frame: StrandFrame,
): StrandSurface {
  const round = mode === POINTS ? spheres(corners, points, frame) : tubes(linesOf(mode, corners, frame), points, frame);
  const [positions, normals] = [round.points, round.normals].map((values) => Float32Array.from(values));
  const along = transpose(frame.metric);
  for (let i = 0; i < positions.length; i += 3) {
    positions.set(transform(frame.inverse, pointAt(round.points, i / 3)), i);
    normals.set(normalize(transform(along, pointAt(round.normals, i / 3)), [0, 0, 1]), i);
  }
  return { positions, normals, indices: round.indices, source: round.source };
}

/** The same in axes where lengths are the world's. */
interface RoundSurface {
  readonly points: ArrayLike<number>;
  readonly normals: ArrayLike<number>;
  readonly indices: Uint32Array;
  readonly source: Uint32Array;
}

function spheres(
  corners: Uint32Array,
  points: ArrayLike<number>,
  { metric, width, fineness: { pointStep, sphere } }: StrandFrame,
): RoundSurface {
  const count = Math.ceil(corners.length / pointStep);
  const { points: directions, triangles } = sphere;
  const each = directions.length / 3;
  const source = Uint32Array.from({ length: count * each }, (_, i) => corners[pointStep * Math.floor(i / each)]);
  const at = new Float64Array(3 * source.length);
  const normals = new Float64Array(3 * source.length);
  let centre: Vec3 = [0, 0, 0];
  for (let i = 0; i < source.length; i++) {
    if (i % each === 0) centre = transform(metric, pointAt(points, source[i]));
    for (let k = 0; k < 3; k++) {
      const direction = directions[3 * (i % each) + k];
      normals[3 * i + k] = direction;
      at[3 * i + k] = centre[k] + width * direction;
    }
  }
  const indices = Uint32Array.from(
    { length: count * triangles.length },
    (_, i) => triangles[i % triangles.length] + each * Math.floor(i / triangles.length),
  );
  return { points: at, normals, indices, source };
}

function tubes(lines: readonly StrandLine[], points: ArrayLike<number>, frame: StrandFrame): RoundSurface {
  const at = (vertex: number): Vec3 => transform(frame.metric, pointAt(points, vertex));
  const runs: CurveRun[] = [];
  const order: number[] = [];
  for (const { vertices, closed } of lines.flatMap((line) => partedAtTurns(line, at))) {
    runs.push({ first: order.length, count: vertices.length, closed });
    for (const vertex of vertices) order.push(vertex);
  }
  const centres = Float64Array.from({ length: 3 * order.length });
  order.forEach((vertex, i) => {
    centres.set(at(vertex), 3 * i);
  });
  const { sides } = frame.fineness;
  const faces = tubeFaces(runs, sides);
  const radii = new Float64Array(order.length).fill(frame.width / 2);
  return {
    ...tubePoints(runs, centres, radii, sides, true),
    indices: fans(faces.counts, faces.indices),
    source: faces.sampleOfPoint.map((sample) => order[sample]),
  };
}

/** The lines of a primitive. Separate ones that follow each other are one. */
function linesOf(mode: number, corners: Uint32Array, { fineness: { lineStep } }: StrandFrame): StrandLine[] {
  if (mode !== LINES) {
    const vertices = Array.from(corners).filter((_, i) => i % lineStep === 0 || i === corners.length - 1);
    return vertices.length > 1 ? [{ vertices, closed: mode === LINE_LOOP && vertices.length > 2 }] : [];
  }
  const chains: number[][] = [];
  for (let i = 0; i + 1 < corners.length; i += 2 * lineStep) {
    const last = chains[chains.length - 1];
    if (last?.[last.length - 1] === corners[i]) last.push(corners[i + 1]);
    else chains.push([corners[i], corners[i + 1]]);
  }
  return chains.map((chain) => {
    const closed = chain.length > 3 && chain[0] === chain[chain.length - 1];
    return { vertices: closed ? chain.slice(0, -1) : chain, closed };
  });
}

/** A line in parts that meet where it turns back by more than a right angle: one tube would be flat there. */
function partedAtTurns(line: StrandLine, at: (vertex: number) => Vec3): StrandLine[] {
  const { vertices, closed } = line;
  const count = vertices.length;
  const isTurn = (i: number): boolean => {
    if (!closed && (i === 0 || i === count - 1)) return false;
    const here = at(vertices[i]);
    const [before, after] = [at(vertices[(i + count - 1) % count]), at(vertices[(i + 1) % count])];
    return dot(sub(here, before), sub(after, here)) < 0;
  };
  const turns = vertices.flatMap((_, i) => (isTurn(i) ? [i] : []));
  if (turns.length === 0) return [line];
  // A closed one begins and ends at its first turn.
  const path = closed ? [...vertices.slice(turns[0]), ...vertices.slice(0, turns[0] + 1)] : vertices;
  const cuts = closed ? turns.slice(1).map((turn) => turn - turns[0]) : turns;
  return [...cuts, path.length - 1].map((end, k) => {
    const begin = k === 0 ? 0 : cuts[k - 1];
    return { vertices: path.slice(begin, end + 1), closed: false };
  });
}

/** Triangles of convex faces. */
function fans(counts: Uint32Array, indices: Uint32Array): Uint32Array {
  const out: number[] = [];
  let first = 0;
  for (const count of counts) {
    for (let k = 1; k + 1 < count; k++) out.push(indices[first], indices[first + k], indices[first + k + 1]);
    first += count;
  }
  return Uint32Array.from(out);
}
