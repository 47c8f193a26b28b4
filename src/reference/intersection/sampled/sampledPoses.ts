import { toMatrix } from '../../../math/quat.ts';
import { add, addScaled, scale, sub, type Vec3, ZERO } from '../../../math/vec3.ts';
import { pointAt } from '../../../scene/mesh/polygons.ts';
import type { ObjectWith } from '../../../scene/motion/kinds/motionKind.ts';
import { samplePose } from '../../../scene/motion/poses.ts';
import type { SampledMotion } from '../../../scene/types.ts';
import { meanLeafSize } from '../../acceleration/bvh.ts';
import { BvhTraversal } from '../../acceleration/bvhTraversal.ts';
import type { Hit, SpacetimeRay } from '../../acceleration/ray.ts';
import type { Crossing, MovingBox, ObjectIntersector, RayQuery } from '../../acceleration/rayQuery.ts';
import { boxesBetween } from '../../acceleration/timeBvh.ts';
import type { TriangleBvh } from '../../acceleration/triangleBvh.ts';
import { PieceSearch } from './pieceSearch.ts';
import { hitOfVertices, type MovingVertex, offerCrossings, positionNoise } from './sampledCrossings.ts';
import { SpacetimeTriangle } from './spacetimeTriangle.ts';

const traversal = new BvhTraversal();
const triangle = new SpacetimeTriangle();
// The current ray in the current piece. From its beginning: where it is relative to the motion's origin, and its direction;
const o = new Float64Array(3);
const d = new Float64Array(3);
// the same relative to the middle of the mesh, which moves uniformly;
const r = new Float64Array(3);
const dr = new Float64Array(3);
// M, and in the axes of the mesh both ends of a chord, and the line through them: o x y z, d x y z.
const M = new Float64Array(9);
const points = new Float64Array(6);
const line = new Float64Array(6);

/** Lengths may be off by this fraction, since quaternions are unit vectors only to rounding. */
const MARGIN = 1e-3;
/** Rounding error of the ball's place, as a fraction of its distance. */
const ROUNDING = 1e-12;
/** Greatest distance of a chord from the ray's curve, as a fraction of the mean size of leaves, and how many chords there may be to reach that. */
const MAX_CHORD_ERROR = 0.25;
const MAX_CHORDS = 32;
/** The ball around the mesh is a closer bound than boxes of single pieces. */
const PIECES_PER_LEAF = 4;
/** Numbers per sample in `frames`. */
const FRAME = 12;

/** The box and the ball around a mesh, in its axes, and the mean size of its tree's leaves [m]. */
interface MeshExtent {
  readonly center: Vec3;
  readonly half: Vec3;
  readonly radius: number;
  readonly leafSize: number;
}

/** Shared by all objects on a path, and by all with a mesh. */
const PATHS = new WeakMap<Float64Array, { readonly frames: Float64Array; readonly turns: Float64Array }>();
const EXTENTS = new WeakMap<TriangleBvh, MeshExtent>();

/**
 * Intersects rays with a mesh at keyframed poses. Its vertices move straight between samples: the map from its axes to the world is x = p(f) + M(f) y, with p
 * and M linear in the fraction f of the piece. In the axes of the mesh its triangles rest, so one tree serves all times, and the ray is the curve
 * y(s) = M⁻¹(x(s) − p); it is followed in chords, thickened by their distance from it. docs/physics.md §10.2, §10.4.
 */
export class SampledPosesRayIntersector implements ObjectIntersector {
  readonly index: number;
  readonly doubleSided: boolean;
  private readonly object: ObjectWith<SampledMotion>;
  private readonly shape: TriangleBvh;
  private readonly c: number;
  /** The position at the first sample [m]. */
  private readonly origin: Vec3;
  /** Per sample p relative to `origin`, and M, row-major. */
  private readonly frames: Float64Array;
  /** Where they place the middle of the mesh: 3 per sample. */
  private readonly centers: Float64Array;
  /** Per piece upper bounds of |dM/df| and |M⁻¹|. */
  private readonly turns: Float64Array;
  private readonly pieces: PieceSearch;
  /** Of the ball around the mesh, in its axes [m]. */
  private readonly center: Vec3;
  private readonly radius: number;
  /** [m] */
  private readonly chordError: number;
  // The current piece: the samples around it, and the ray's fraction at its beginning, and per unit of s.
  private before = 0;
  private after = 0;
  private fraction = 0;
  private rate = 0;

  constructor(index: number, object: ObjectWith<SampledMotion>, shape: TriangleBvh, c: number) {
    const { times, poses } = object.motion;
    this.index = index;
    this.doubleSided = object.mesh.doubleSided;
    this.object = object;
    this.shape = shape;
    this.c = c;
    this.origin = samplePose(poses, 0).position;
    ({ frames: this.frames, turns: this.turns } = cached(PATHS, poses, () => ({
      frames: framesOf(poses, times.length, this.origin),
      turns: turnsOf(poses, times.length),
    })));
    const { center, half, radius, leafSize } = cached(EXTENTS, shape, () => extentOf(shape));
    this.center = center;
    this.radius = (1 + MARGIN) * radius;
    this.chordError = MAX_CHORD_ERROR * leafSize;
    this.centers = new Float64Array(3 * times.length);
    for (let k = 0; k < times.length; k++) this.centers.set(placeIn(this.frames, FRAME * k, this.center), 3 * k);
    this.pieces = new PieceSearch(
      times,
      this.origin,
      boxesBetween(outlinesOf(this.frames, center, half)),
      c,
      PIECES_PER_LEAF,
    );
  }

  get bounds(): MovingBox | undefined {
    return this.shape.first.length === 0 ? undefined : this.pieces.bounds;
  }

  intersect(ray: SpacetimeRay, search: RayQuery): void {
    const { pieces } = this;
    pieces.start(ray, this.object.lifetime, search.begin, search.end);
    while (pieces.next(search.end)) this.tracePiece(ray, pieces.piece, pieces.near, pieces.far, search);
  }

  hitAt(ray: SpacetimeRay, crossing: Crossing): Hit {
    const { corner, s, piece } = crossing;
    const { indices } = this.object.mesh;
    const time = ray.t + (s * ray.dt) / this.c;
    const vertices = [0, 1, 2].map((k) => this.vertex(indices[corner + k], piece, time));
    return hitOfVertices(ray, this.index, crossing, this.c, vertices);
  }

  /** Intersects the ray between s = near and s = far with piece k, in the part in which it is in the ball around the mesh. */
  private tracePiece(ray: SpacetimeRay, k: number, near: number, far: number, search: RayQuery): void {
    this.choosePiece(ray, k, near);
    const { before, after, fraction, rate, origin, centers } = this;
    const { x, dx } = ray;
    let [along, square, place] = [0, 0, 0];
    for (let i = 0; i < 3; i++) {
      o[i] = x[i] + dx[i] * near - origin[i];
      d[i] = dx[i];
      const from = centers[3 * before + i];
      const moved = centers[3 * after + i] - from;
      r[i] = o[i] - from - moved * fraction;
      dr[i] = d[i] - moved * rate;
      along += r[i] * dr[i];
      square += dr[i] * dr[i];
      place += Math.abs(r[i]);
    }
    const noise = positionNoise(o, this.pieces.reach);
    const nearest = square > 0 ? -along / square : 0;
    let away = 0;
    for (let i = 0; i < 3; i++) away += (r[i] + nearest * dr[i]) ** 2;
    const reach = this.radius + noise + ROUNDING * place;
    if (away > reach * reach) return;
    const half = square > 0 ? Math.sqrt((reach * reach - away) / square) : Number.POSITIVE_INFINITY;
    const begin = Math.max(0, nearest - half);
    const end = Math.min(far - near, nearest + half);
    if (begin <= end) this.traceChords(near, begin, end, Math.sqrt(square), reach, noise, k, search);
  }

  private choosePiece(ray: SpacetimeRay, k: number, near: number): void {
    const { times } = this.object.motion;
    const last = times.length - 1;
    const isMoving = k >= 0 && k < last;
    this.before = Math.max(0, k);
    this.after = Math.min(last, k + 1);
    const span = isMoving ? times[k + 1] - times[k] : 1;
    this.rate = isMoving ? ray.dt / (this.c * span) : 0;
    this.fraction = isMoving ? (ray.t - times[k]) / span + near * this.rate : 0;
  }

  /**
   * Follows the ray from `near` + begin to `near` + end, where it is within `reach` of the middle of the mesh. With z = M⁻¹r, r relative to that middle, it has
   * z′ = M⁻¹(r′ − M′z) and z″ = −2M⁻¹M′z′; a chord over h is off by at most h²|z″|/8.
   */
  private traceChords(
    near: number,
    begin: number,
    end: number,
    speed: number,
    reach: number,
    noise: number,
    k: number,
    search: RayQuery,
  ): void {
    const { rate } = this;
    const turn = rate === 0 ? 0 : this.turns[2 * k] * Math.abs(rate);
    const inverse = this.before === this.after ? 1 : this.turns[2 * k + 1];
    const bend = turn === 0 ? 0 : 2 * inverse * turn * inverse * (speed + turn * inverse * reach);
    const error = (bend * (end - begin) ** 2) / 8;
    const chords = error > this.chordError ? Math.min(MAX_CHORDS, Math.ceil(Math.sqrt(error / this.chordError))) : 1;
    const thickness = error / (chords * chords) + 4 * inverse * noise;
    const step = (end - begin) / chords;
    this.placeInMesh(begin, 0);
    for (let j = 0; j < chords; j++) {
      const from = begin + j * step;
      const to = j + 1 < chords ? from + step : end;
      if (near + from > search.end) return;
      this.placeInMesh(to, 3);
      this.traceChord(near, from, to, thickness, noise, k, search);
      for (let i = 0; i < 3; i++) points[i] = points[3 + i];
    }
  }

  /** Writes the ray's place at s to `points`, in the axes of the mesh. */
  private placeInMesh(s: number, at: number): void {
    const { frames, center } = this;
    const f = this.fraction + s * this.rate;
    const before = FRAME * this.before + 3;
    const after = FRAME * this.after + 3;
    for (let i = 0; i < 9; i++) M[i] = frames[before + i] + f * (frames[after + i] - frames[before + i]);
    const x = r[0] + s * dr[0];
    const y = r[1] + s * dr[1];
    const z = r[2] + s * dr[2];
    const p = M[4] * M[8] - M[5] * M[7];
    const q = M[5] * M[6] - M[3] * M[8];
    const u = M[3] * M[7] - M[4] * M[6];
    const scale = 1 / (M[0] * p + M[1] * q + M[2] * u);
    points[at] = (p * x + (M[2] * M[7] - M[1] * M[8]) * y + (M[1] * M[5] - M[2] * M[4]) * z) * scale + center[0];
    points[at + 1] = (q * x + (M[0] * M[8] - M[2] * M[6]) * y + (M[2] * M[3] - M[0] * M[5]) * z) * scale + center[1];
    points[at + 2] = (u * x + (M[1] * M[6] - M[0] * M[7]) * y + (M[0] * M[4] - M[1] * M[3]) * z) * scale + center[2];
  }

  /** Intersects the ray from `near` + from to `near` + to, along the chord between `points`. */
  private traceChord(
    near: number,
    from: number,
    to: number,
    thickness: number,
    noise: number,
    k: number,
    search: RayQuery,
  ): void {
    const perLength = to > from ? 1 / (to - from) : 0;
    for (let i = 0; i < 3; i++) {
      line[3 + i] = (points[3 + i] - points[i]) * perLength;
      line[i] = points[i] - from * line[3 + i];
    }
    // Without a bound, NaN: every box is met.
    if (!Number.isFinite(thickness)) line.fill(Number.NaN);
    const { bvh, first } = this.shape;
    traversal.start(bvh, line, from);
    traversal.thicken(ZERO, Number.isFinite(thickness) ? thickness : 0);
    for (;;) {
      const end = Math.min(to, search.end - near);
      const leaf = traversal.next(end);
      if (leaf < 0) return;
      traversal.clip(leaf, end);
      const { near: enters, far: leaves } = traversal;
      const start = bvh.link[leaf];
      for (let i = start; i < start + bvh.count[leaf]; i++) {
        for (let corner = 0; corner < 3; corner++) this.setCorner(9 * i + 3 * corner, 3 * corner, enters);
        offerCrossings(search, this, triangle, near + enters, leaves - enters, noise, first[i], k);
      }
    }
  }

  /** Sets the triangle's corner at `to` to the mesh's at `at`, relative to the ray, with σ = 0 at s = `enters`. */
  private setCorner(at: number, to: number, enters: number): void {
    const { frames, fraction, rate } = this;
    const before = FRAME * this.before;
    const after = FRAME * this.after;
    const { corners } = this.shape;
    const x = corners[at];
    const y = corners[at + 1];
    const z = corners[at + 2];
    const f = fraction + rate * enters;
    for (let i = 0; i < 3; i++) {
      const m = before + 3 + 3 * i;
      const n = after + 3 + 3 * i;
      const place = frames[before + i] + frames[m] * x + frames[m + 1] * y + frames[m + 2] * z;
      const moved = frames[after + i] + frames[n] * x + frames[n + 1] * y + frames[n + 2] * z - place;
      triangle.a[to + i] = place - o[i] + (moved * f - d[i] * enters);
      triangle.b[to + i] = moved * rate - d[i];
    }
  }

  /** Vertex i at world time t in piece k. */
  private vertex(i: number, k: number, t: number): MovingVertex {
    const { frames, origin } = this;
    const { mesh, motion } = this.object;
    const { times } = motion;
    const last = times.length - 1;
    const [before, after] = [Math.max(0, k), Math.min(last, k + 1)];
    const span = before === after ? Number.POSITIVE_INFINITY : times[after] - times[before];
    const fraction = before === after ? 0 : (t - times[before]) / span;
    const x = pointAt(mesh.positions, i);
    const [a, b] = [placeIn(frames, FRAME * before, x), placeIn(frames, FRAME * after, x)];
    const moved = sub(b, a);
    return { place: add(origin, addScaled(a, moved, fraction)), velocity: scale(moved, 1 / span) };
  }
}

/** p + M x for the frame at `at`. */
function placeIn(frames: Float64Array, at: number, [x, y, z]: Vec3): Vec3 {
  const row = (i: number): number => {
    const m = at + 3 + 3 * i;
    return frames[at + i] + frames[m] * x + frames[m + 1] * y + frames[m + 2] * z;
  };
  return [row(0), row(1), row(2)];
}

function cached<K extends object, V>(map: WeakMap<K, V>, key: K, make: () => V): V {
  const known = map.get(key);
  if (known) return known;
  const made = make();
  map.set(key, made);
  return made;
}

function extentOf({ bvh, corners }: TriangleBvh): MeshExtent {
  const b = bvh.bounds;
  if (b.length === 0) return { center: ZERO, half: ZERO, radius: 0, leafSize: 0 };
  const center: Vec3 = [(b[0] + b[3]) / 2, (b[1] + b[4]) / 2, (b[2] + b[5]) / 2];
  const half: Vec3 = [(b[3] - b[0]) / 2, (b[4] - b[1]) / 2, (b[5] - b[2]) / 2];
  return { center, half, radius: greatestDistance(corners, center), leafSize: meanLeafSize(bvh) };
}

/** Of points, 3 numbers each, from another. */
function greatestDistance(points: ArrayLike<number>, [x, y, z]: Vec3): number {
  let square = 0;
  for (let i = 0; i < points.length; i += 3)
    square = Math.max(square, (points[i] - x) ** 2 + (points[i + 1] - y) ** 2 + (points[i + 2] - z) ** 2);
  return Math.sqrt(square);
}

function framesOf(poses: Float64Array, samples: number, origin: Vec3): Float64Array {
  const frames = new Float64Array(FRAME * samples);
  for (let k = 0; k < samples; k++) {
    const { position, orientation } = samplePose(poses, k);
    frames.set(sub(position, origin), FRAME * k);
    frames.set(toMatrix(orientation), FRAME * k + 3);
  }
  return frames;
}

/**
 * For each piece |dM/df| = 2 sin θ/2 and |M⁻¹| ≤ 1/cos θ/2, where the orientation turns by θ. The unit quaternions of both are 2 sin θ/4 apart, or their
 * negatives are.
 */
function turnsOf(poses: Float64Array, samples: number): Float64Array {
  const turns = new Float64Array(2 * samples);
  for (let k = 0; k + 1 < samples; k++) {
    const [p, q] = [samplePose(poses, k).orientation, samplePose(poses, k + 1).orientation];
    const apart = Math.min(Math.hypot(...p.map((x, i) => x - q[i])), Math.hypot(...p.map((x, i) => x + q[i])));
    const cosine = 1 - apart ** 2 / 2;
    turns[2 * k] = (1 + MARGIN) * 2 * apart;
    turns[2 * k + 1] = cosine > MARGIN ? (1 + MARGIN) / cosine : Number.POSITIVE_INFINITY;
  }
  return turns;
}

/** The boxes at all samples of the box of the mesh: its half extents are |M| times those in the axes of the mesh. */
function outlinesOf(frames: Float64Array, center: Vec3, half: Vec3): Float64Array {
  const samples = frames.length / FRAME;
  const boxes = new Float64Array(6 * samples);
  for (let k = 0; k < samples; k++) {
    const middle = placeIn(frames, FRAME * k, center);
    for (let i = 0; i < 3; i++) {
      const m = FRAME * k + 3 + 3 * i;
      let extent = 0;
      for (let j = 0; j < 3; j++) extent += Math.abs(frames[m + j]) * half[j];
      boxes[6 * k + i] = middle[i] - extent;
      boxes[6 * k + 3 + i] = middle[i] + extent;
    }
  }
  return boxes;
}
