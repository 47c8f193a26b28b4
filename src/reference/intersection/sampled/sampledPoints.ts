import { ZERO } from '../../../math/vec3.ts';
import type { SceneObject } from '../../../scene/types.ts';
import { BvhTraversal } from '../../acceleration/bvhTraversal.ts';
import type { Hit, SpacetimeRay } from '../../acceleration/ray.ts';
import type { Crossing, MovingBox, ObjectIntersector, RayQuery } from '../../acceleration/rayQuery.ts';
import type { CubicChords } from './cubicChords.ts';
import { PieceSearch } from './pieceSearch.ts';
import { hitOfVertices, offerCrossings, positionNoise } from './sampledCrossings.ts';
import { MAX_PIECES_PER_BLOCK, type SampledShapes } from './sampledShapes.ts';
import { SpacetimeTriangle } from './spacetimeTriangle.ts';

const traversal = new BvhTraversal();
/** Where the current ray is at the beginning of the current block, relative to the motion's origin, and its direction. */
const o = new Float64Array(3);
const d = new Float64Array(3);
/** The current ray from there on in the moving coordinates of the block: o x y z, d x y z. */
const line = new Float64Array(6);
/** Where it is at the samples of the block. */
const knots = new Float64Array(MAX_PIECES_PER_BLOCK + 1);
const triangle = new SpacetimeTriangle();
/** The corners of a triangle at both ends of a chord, relative to the motion's origin. */
const chordBegin = new Float64Array(9);
const chordFinish = new Float64Array(9);

/**
 * Intersects rays with a deforming mesh, whose vertices move straight between samples, or along chords of a cubic (`CubicChords`). Piece k lies between
 * samples k and k + 1; the object is at rest in piece −1, before its first sample, and in the last one, after its last sample. Slow pieces share a tree
 * with others of their block, fast ones have several.
 */
export class SampledPointsRayIntersector implements ObjectIntersector {
  readonly index: number;
  readonly doubleSided: boolean;
  private readonly object: SceneObject;
  private readonly c: number;
  private readonly samples: SampledShapes;
  private readonly blocks: PieceSearch;
  // Vertices at the ends of the current piece, and the ray's fraction of it, and that per unit of s.
  private before: ArrayLike<number> = [];
  private after: ArrayLike<number> = [];
  private fraction = 0;
  private rate = 0;

  constructor(index: number, object: SceneObject, c: number, samples: SampledShapes) {
    this.index = index;
    this.doubleSided = object.mesh.doubleSided;
    this.object = object;
    this.c = c;
    this.samples = samples;
    const { times, origin, blockEnds } = samples;
    const blockTimes = Float64Array.from(blockEnds, (k) => times[k]);
    this.blocks = new PieceSearch(blockTimes, origin, samples.blockBoxes(), c);
  }

  get bounds(): MovingBox | undefined {
    return this.samples.topology.first.length === 0 ? undefined : this.blocks.bounds;
  }

  intersect(ray: SpacetimeRay, search: RayQuery): void {
    const { blocks } = this;
    blocks.start(ray, this.object.lifetime, search.begin, search.end);
    while (blocks.next(search.end)) this.traceBlock(ray, blocks.piece, blocks.near, blocks.far, search);
  }

  /** Intersects the ray between s = near and s = far with a block, in the trees of its parts. */
  private traceBlock(ray: SpacetimeRay, block: number, near: number, far: number, search: RayQuery): void {
    const { samples } = this;
    const { blockEnds, times } = samples;
    const { x, dx } = ray;
    const { moved, parts } = samples.frameOf(block);
    const isMoving = block >= 0 && block + 1 < blockEnds.length;
    const from = isMoving ? times[blockEnds[block]] : 0;
    const span = isMoving ? times[blockEnds[block + 1]] - from : Number.POSITIVE_INFINITY;
    const rate = ray.dt / (this.c * span);
    const fraction = isMoving ? (ray.t - from) / span + near * rate : 0;
    for (let i = 0; i < 3; i++) {
      o[i] = x[i] + dx[i] * near - samples.origin[i];
      d[i] = dx[i];
      line[i] = o[i] - moved[i] * fraction;
      line[3 + i] = d[i] - moved[i] * rate;
    }
    const length = far - near;
    const cubic = isMoving ? samples.cubic : undefined;
    const noise = positionNoise(o, this.blocks.reach);
    const partAt = (s: number) => Math.min(parts - 1, Math.max(0, Math.floor((fraction + rate * s) * parts)));
    const step = rate < 0 ? -1 : 1;
    const last = parts === 1 || rate === 0 ? partAt(0) : partAt(length);
    for (let part = partAt(0); part * step <= last * step; part += step) {
      // Where the ray is in the part.
      const isWhole = parts === 1 || rate === 0;
      const one = isWhole ? 0 : (part / parts - fraction) / rate;
      const other = isWhole ? length : ((part + 1) / parts - fraction) / rate;
      const begin = Math.max(0, Math.min(one, other));
      const end = Math.min(length, Math.max(one, other));
      traversal.start(samples.treeOf(block, part), line, begin);
      traversal.thicken(ZERO, noise + (cubic?.chordErrorIn(block) ?? 0));
      if (cubic) this.intersectCubicLeaves(cubic, fraction, rate, near, end, noise, block, search);
      else this.intersectLeaves(ray, block, near, end, noise, search);
    }
  }

  /** Intersects the triangles of the leaves before s = begin + `length`, in each piece that the ray passes while it is inside a leaf. */
  private intersectLeaves(
    ray: SpacetimeRay,
    block: number,
    begin: number,
    length: number,
    noise: number,
    search: RayQuery,
  ): void {
    const { topology, times } = this.samples;
    const { bvh, first } = topology;
    const [early, late] = this.samples.piecesOf(block);
    const isMoving = early >= 0 && early + 1 < times.length;
    // Where the ray is at the samples; a piece at rest has no end.
    for (let k = early; k <= late + 1; k++) knots[k - early] = isMoving ? this.placeAt(ray, times[k]) - begin : 0;
    if (!isMoving) [knots[0], knots[1]] = ray.dt < 0 ? [length, 0] : [0, length];
    const step = ray.dt < 0 ? -1 : 1;
    const [start, last] = step > 0 ? [early, late] : [late, early];
    for (;;) {
      const end = Math.min(length, search.end - begin);
      const leaf = traversal.next(end);
      if (leaf < 0) return;
      traversal.clip(leaf, end);
      const { near, far } = traversal;
      const from = bvh.link[leaf];
      const to = from + bvh.count[leaf];
      for (let k = start; k * step <= last * step; k += step) {
        const [one, other] = [knots[k - early], knots[k - early + 1]];
        const enters = Math.max(near, Math.min(one, other));
        const leaves = Math.min(far, Math.max(one, other));
        if (enters > leaves) continue;
        this.startPiece(ray, k, begin + enters);
        for (let i = from; i < to; i++) {
          this.setTriangle(first[i], enters);
          offerCrossings(search, this, triangle, begin + enters, leaves - enters, noise, first[i], k);
        }
      }
    }
  }

  /** Where a ray is at a world time [s]; in a slice of simultaneity before all later times. */
  private placeAt({ t, dt }: SpacetimeRay, time: number): number {
    if (dt === 0) return time <= t ? Number.NEGATIVE_INFINITY : Number.POSITIVE_INFINITY;
    return ((time - t) * this.c) / dt;
  }

  /** Sets the piece of the triangles that `setTriangle` sets, where the ray is at s. */
  private startPiece(ray: SpacetimeRay, k: number, s: number): void {
    const { samples } = this;
    const { times } = samples;
    const isMoving = k >= 0 && k + 1 < times.length;
    const span = isMoving ? times[k + 1] - times[k] : Number.POSITIVE_INFINITY;
    this.before = samples.pointsAt(Math.max(0, k));
    this.after = isMoving ? samples.pointsAt(k + 1) : this.before;
    this.rate = ray.dt / (this.c * span);
    this.fraction = isMoving ? (ray.t - times[k]) / span + s * this.rate : 0;
  }

  /** Sets the triangle's corners relative to the ray, with σ = 0 at `enters`. */
  private setTriangle(corner: number, enters: number): void {
    const { before, after, fraction, rate } = this;
    const { indices } = this.object.mesh;
    const { a, b } = triangle;
    for (let k = 0; k < 3; k++) {
      const at = 3 * indices[corner + k];
      for (let axis = 0; axis < 3; axis++) {
        const moved = after[at + axis] - before[at + axis];
        a[3 * k + axis] = before[at + axis] - o[axis] + (moved * fraction - d[axis] * enters);
        b[3 * k + axis] = moved * rate - d[axis];
      }
    }
  }

  /** As `intersectLeaves`, for each chord that the ray passes while it is inside a leaf. */
  private intersectCubicLeaves(
    cubic: CubicChords,
    fraction: number,
    rate: number,
    begin: number,
    length: number,
    noise: number,
    piece: number,
    search: RayQuery,
  ): void {
    const { bvh, first } = this.samples.topology;
    const { indices } = this.object.mesh;
    const chords = cubic.chordsIn(piece);
    const chordAt = (s: number) => Math.min(chords - 1, Math.max(0, Math.floor((fraction + rate * s) * chords)));
    for (;;) {
      const end = Math.min(length, search.end - begin);
      const leaf = traversal.next(end);
      if (leaf < 0) return;
      traversal.clip(leaf, end);
      const { near, far } = traversal;
      const [early, late] = rate < 0 ? [chordAt(far), chordAt(near)] : [chordAt(near), chordAt(far)];
      const from = bvh.link[leaf];
      for (let i = from; i < from + bvh.count[leaf]; i++)
        for (let chord = early; chord <= late; chord++) {
          for (let corner = 0; corner < 3; corner++) {
            cubic.chordEnd(indices[first[i] + corner], piece, chord, chordBegin, 3 * corner);
            cubic.chordEnd(indices[first[i] + corner], piece, chord + 1, chordFinish, 3 * corner);
          }
          // At s the ray is at the fraction `chordFraction` + `chordRate` s of the chord.
          const chordFraction = fraction * chords - chord;
          const chordRate = rate * chords;
          const ends =
            chordRate === 0
              ? [near, far]
              : [-chordFraction / chordRate, (1 - chordFraction) / chordRate].sort((a, b) => a - b);
          const [enters, leaves] = [Math.max(near, ends[0]), Math.min(far, ends[1])];
          if (enters > leaves) continue;
          this.setTriangleFromChord(chordFraction, chordRate, enters);
          offerCrossings(search, this, triangle, begin + enters, leaves - enters, noise, first[i], piece);
        }
    }
  }

  /** Sets the triangle's corners relative to the ray, with σ = 0 at s = `enters`. */
  private setTriangleFromChord(fraction: number, rate: number, enters: number): void {
    const { a, b } = triangle;
    for (let k = 0; k < 9; k++) {
      const axis = k % 3;
      const moved = chordFinish[k] - chordBegin[k];
      a[k] = chordBegin[k] - o[axis] + (moved * (fraction + rate * enters) - d[axis] * enters);
      b[k] = moved * rate - d[axis];
    }
  }

  hitAt(ray: SpacetimeRay, crossing: Crossing): Hit {
    const { corner, s, piece } = crossing;
    const { indices } = this.object.mesh;
    const time = ray.t + (s * ray.dt) / this.c;
    const vertices = [0, 1, 2].map((k) => this.samples.vertex(indices[corner + k], piece, time));
    return hitOfVertices(ray, this.index, crossing, this.c, vertices);
  }
}
