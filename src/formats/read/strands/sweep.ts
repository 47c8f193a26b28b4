import { add, addScaled, cross, dot, normalize, scale, sub, type Vec3, ZERO } from '../../../math/vec3.ts';
import { pointAt } from '../../../scene/mesh/polygons.ts';

/** Maximum number of points of surfaces along curves that are made together. */
export const MAX_SURFACE_POINTS = 2 ** 20;

/** A curve among the samples of a prim. */
export interface CurveRun {
  readonly first: number;
  readonly count: number;
  readonly closed: boolean;
}

/** Points of a surface along curves, 3 numbers each, and its normals there. */
export interface SweptPoints {
  readonly points: Float32Array;
  readonly normals: Float32Array;
}

/** Faces of a surface along curves, and by point the sample that it is made at. */
export interface SweptFaces {
  readonly counts: Uint32Array;
  readonly indices: Uint32Array;
  readonly sampleOfPoint: Uint32Array;
}

/** Rings of `sides` points: the tube's, and for open curves one at each end for a lid. */
export function tubeFaces(runs: readonly CurveRun[], sides: number): SweptFaces {
  const [counts, indices, samples]: [number[], number[], number[]] = [[], [], []];
  for (const { first, count, closed } of runs) {
    const base = samples.length;
    for (let i = 0; i < count; i++) for (let k = 0; k < sides; k++) samples.push(first + i);
    for (let i = 0; i + (closed ? 0 : 1) < count; i++)
      for (let k = 0; k < sides; k++) {
        const [a, b] = [base + i * sides, base + ((i + 1) % count) * sides];
        const next = (k + 1) % sides;
        indices.push(a + k, a + next, b + next, b + k);
        counts.push(4);
      }
    if (closed) continue;
    for (const end of [0, count - 1]) {
      const lid = samples.length;
      for (let k = 0; k < sides; k++) {
        samples.push(first + end);
        indices.push(end === 0 ? lid + sides - 1 - k : lid + k);
      }
      counts.push(sides);
    }
  }
  return facesOf(counts, indices, samples);
}

/** Tubes around the samples `centres` with the given radii, in the order of `tubeFaces`. `mitred`: round lines with corners at the samples, instead of smooth curves. */
export function tubePoints(
  runs: readonly CurveRun[],
  centres: ArrayLike<number>,
  radii: ArrayLike<number>,
  sides: number,
  mitred: boolean,
): SweptPoints {
  const [points, normals]: [number[], number[]] = [[], []];
  const put = (centre: Vec3, radius: number, direction: Vec3, normal: Vec3): void => {
    points.push(...addScaled(centre, direction, radius));
    normals.push(...normal);
  };
  for (const run of runs) {
    const ways = waysOf(run, centres);
    const tangents = ways.map(({ tangent }) => tangent);
    const frames = transported(run, tangents);
    const ring = (i: number, normal?: Vec3): void => {
      const [x, y] = frames[i];
      const { across, mitre } = ways[i];
      for (let k = 0; k < sides; k++) {
        const angle = (2 * Math.PI * k) / sides;
        const direction = addScaled(scale(x, Math.cos(angle)), y, Math.sin(angle));
        const outward = mitred ? addScaled(direction, across, (mitre - 1) * dot(direction, across)) : direction;
        put(pointAt(centres, run.first + i), radii[run.first + i], outward, normal ?? direction);
      }
    };
    for (let i = 0; i < run.count; i++) ring(i);
    if (run.closed) continue;
    ring(0, scale(tangents[0], -1));
    ring(run.count - 1, tangents[run.count - 1]);
  }
  return { points: Float32Array.from(points), normals: Float32Array.from(normals) };
}

/** Two points at each sample. */
export function ribbonFaces(runs: readonly CurveRun[]): SweptFaces {
  const [counts, indices, samples]: [number[], number[], number[]] = [[], [], []];
  for (const { first, count, closed } of runs) {
    const base = samples.length;
    for (let i = 0; i < count; i++) samples.push(first + i, first + i);
    for (let i = 0; i + (closed ? 0 : 1) < count; i++) {
      const [a, b] = [base + 2 * i, base + 2 * ((i + 1) % count)];
      indices.push(a, a + 1, b + 1, b);
      counts.push(4);
    }
  }
  return facesOf(counts, indices, samples);
}

/** Ribbons across the given normals. */
export function ribbonPoints(
  runs: readonly CurveRun[],
  centres: ArrayLike<number>,
  radii: ArrayLike<number>,
  facing: ArrayLike<number>,
): SweptPoints {
  const [points, normals]: [number[], number[]] = [[], []];
  for (const run of runs) {
    const tangents = waysOf(run, centres).map(({ tangent }) => tangent);
    for (let i = 0; i < run.count; i++) {
      const s = run.first + i;
      const side = normalize(cross(tangents[i], pointAt(facing, s)), perpendicular(tangents[i]));
      const normal = normalize(cross(side, tangents[i]));
      for (const sign of [1, -1]) {
        points.push(...addScaled(pointAt(centres, s), side, sign * radii[s]));
        normals.push(...normal);
      }
    }
  }
  return { points: Float32Array.from(points), normals: Float32Array.from(normals) };
}

const facesOf = (counts: number[], indices: number[], samples: number[]): SweptFaces => ({
  counts: Uint32Array.from(counts),
  indices: Uint32Array.from(indices),
  sampleOfPoint: Uint32Array.from(samples),
});

/** How a curve goes through a sample. */
interface CurveWay {
  /** Halfway between the directions of both chords. */
  readonly tangent: Vec3;
  /** In the plane of the bend, perpendicular to the tangent; zero where it is straight. */
  readonly across: Vec3;
  /** How much wider a ring is there, for a tube of constant width. */
  readonly mitre: number;
}

const MAX_MITRE = 2;

function waysOf({ first, count, closed }: CurveRun, centres: ArrayLike<number>): CurveWay[] {
  const at = (i: number): Vec3 => pointAt(centres, first + ((i + count) % count));
  let last: Vec3 = [0, 0, 1];
  return Array.from({ length: count }, (_, i) => {
    const before = normalize(closed || i > 0 ? sub(at(i), at(i - 1)) : ZERO);
    const after = normalize(closed || i + 1 < count ? sub(at(i + 1), at(i)) : ZERO);
    last = normalize(add(before, after), last);
    const along = dot(after, last);
    const across = normalize(addScaled(after, last, -along));
    return { tangent: last, across, mitre: Math.min(MAX_MITRE, 1 / Math.max(along, 1 / MAX_MITRE)) };
  });
}

/** Two perpendicular directions across a curve at each sample, which turn no more than it does; a closed one meets itself. */
function transported({ count, closed }: CurveRun, tangents: readonly Vec3[]): (readonly [x: Vec3, y: Vec3])[] {
  const across: Vec3[] = [perpendicular(tangents[0])];
  // The smallest rotation from one tangent to the next.
  const carried = (x: Vec3, from: Vec3, to: Vec3): Vec3 => {
    const turned = addScaled(x, add(from, to), -dot(x, to) / Math.max(1 + dot(from, to), 1e-9));
    return normalize(addScaled(turned, to, -dot(turned, to)), perpendicular(to));
  };
  for (let i = 1; i < count; i++) across.push(carried(across[i - 1], tangents[i - 1], tangents[i]));
  let twist = 0;
  if (closed) {
    const back = carried(across[count - 1], tangents[count - 1], tangents[0]);
    twist = Math.atan2(dot(cross(back, across[0]), tangents[0]), dot(back, across[0]));
  }
  return across.map((x, i) => {
    const angle = (twist * i) / count;
    const y = cross(tangents[i], x);
    const turned = addScaled(scale(x, Math.cos(angle)), y, Math.sin(angle));
    return [turned, cross(tangents[i], turned)];
  });
}

function perpendicular([x, y, z]: Vec3): Vec3 {
  const [ax, ay, az] = [Math.abs(x), Math.abs(y), Math.abs(z)];
  const other: Vec3 = ax <= ay && ax <= az ? [1, 0, 0] : ay <= az ? [0, 1, 0] : [0, 0, 1];
  return normalize(cross([x, y, z], other), [1, 0, 0]);
}
