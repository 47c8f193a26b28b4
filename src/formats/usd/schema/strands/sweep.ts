import { addScaled, cross, dot, normalize, scale, sub, type Vec3 } from '../../../../math/vec3.ts';
import { pointAt } from '../../../../scene/mesh/polygons.ts';

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

/** Tubes around the samples `centres` with the given radii, in the order of `tubeFaces`. */
export function tubePoints(
  runs: readonly CurveRun[],
  centres: ArrayLike<number>,
  radii: ArrayLike<number>,
  sides: number,
): SweptPoints {
  const [points, normals]: [number[], number[]] = [[], []];
  const put = (centre: Vec3, radius: number, direction: Vec3, normal: Vec3): void => {
    points.push(...addScaled(centre, direction, radius));
    normals.push(...normal);
  };
  for (const run of runs) {
    const tangents = tangentsOf(run, centres);
    const frames = transported(run, tangents);
    const ring = (i: number, normal?: Vec3): void => {
      const [x, y] = frames[i];
      for (let k = 0; k < sides; k++) {
        const angle = (2 * Math.PI * k) / sides;
        const direction = addScaled(scale(x, Math.cos(angle)), y, Math.sin(angle));
        put(pointAt(centres, run.first + i), radii[run.first + i], direction, normal ?? direction);
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
    const tangents = tangentsOf(run, centres);
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

/** Directions along a curve, by the chord between the neighbours of each sample. */
function tangentsOf({ first, count, closed }: CurveRun, centres: ArrayLike<number>): Vec3[] {
  let last: Vec3 = [0, 0, 1];
  return Array.from({ length: count }, (_, i) => {
    const before = closed ? (i + count - 1) % count : Math.max(0, i - 1);
    const after = closed ? (i + 1) % count : Math.min(count - 1, i + 1);
    last = normalize(sub(pointAt(centres, first + after), pointAt(centres, first + before)), last);
    return last;
  });
}

/** Two perpendicular directions across a curve at each sample, which turn no more than it does; a closed one meets itself. */
function transported({ count, closed }: CurveRun, tangents: readonly Vec3[]): (readonly [x: Vec3, y: Vec3])[] {
  const across: Vec3[] = [perpendicular(tangents[0])];
  const carried = (x: Vec3, tangent: Vec3): Vec3 =>
    normalize(addScaled(x, tangent, -dot(x, tangent)), perpendicular(tangent));
  for (let i = 1; i < count; i++) across.push(carried(across[i - 1], tangents[i]));
  let twist = 0;
  if (closed) {
    const back = carried(across[count - 1], tangents[0]);
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
