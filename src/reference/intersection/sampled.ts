import { type Vec3, ZERO } from '../../math/vec3.ts';
import type { SceneObject } from '../../scene/types.ts';
import { BvhTraversal } from '../acceleration/bvhTraversal.ts';
import type { Hit, SpacetimeRay } from '../acceleration/ray.ts';
import type { Crossing, MovingBox, ObjectIntersector, RayQuery } from '../acceleration/rayQuery.ts';
import type { CubicChords } from './cubicChords.ts';
import { PieceSearch } from './pieceSearch.ts';
import { hitOfVertices, offerCrossings, positionNoise } from './sampledCrossings.ts';
import type { SampledShapes } from './sampledShapes.ts';
import { SpacetimeTriangle } from './spacetimeTriangle.ts';

const traversal = new BvhTraversal();
/** Where the current ray is at the beginning of the current piece, relative to the motion's origin. */
const o = new Float64Array(3);
/** The current ray from there on in the moving coordinates of the piece: o x y z, d x y z. */
const line = new Float64Array(6);
const triangle = new SpacetimeTriangle();
/** The corners of a triangle at both ends of a chord, relative to the motion's origin. */
const chordBegin = new Float64Array(9);
const chordFinish = new Float64Array(9);

/**
 * Intersects rays with a deforming mesh, whose vertices move straight between samples, or along chords of a cubic (`CubicChords`). Piece k lies between
 * samples k and k + 1; the object is at rest in piece −1, before its first sample, and in the last one, after its last sample.
 */
export class SampledRayIntersector implements ObjectIntersector {
  readonly index: number;
  readonly doubleSided: boolean;
  private readonly object: SceneObject;
  private readonly c: number;
  private readonly samples: SampledShapes;
  private readonly pieces: PieceSearch;

  constructor(index: number, object: SceneObject, c: number, samples: SampledShapes) {
    this.index = index;
    this.doubleSided = object.mesh.doubleSided;
    this.object = object;
    this.c = c;
    this.samples = samples;
    const { times, origin } = samples;
    this.pieces = new PieceSearch(times, origin, samples.outlines(), c);
  }

  get bounds(): MovingBox | undefined {
    return this.samples.topology.first.length === 0 ? undefined : this.pieces.bounds;
  }

  intersect(ray: SpacetimeRay, search: RayQuery): void {
    const { pieces } = this;
    pieces.start(ray, this.object.lifetime, search.begin, search.end);
    while (pieces.next(search.end)) this.tracePiece(ray, pieces.piece, pieces.near, pieces.far, search);
  }

  /** Intersects the ray between s = near and s = far with piece k, in the trees of its parts. */
  private tracePiece(ray: SpacetimeRay, k: number, near: number, far: number, search: RayQuery): void {
    const { samples } = this;
    const { x, dx } = ray;
    const { moved, parts } = samples.frameOf(k);
    const isMoving = k >= 0 && k + 1 < samples.times.length;
    const from = samples.times[k];
    const span = samples.times[k + 1] - from;
    const rate = isMoving ? ray.dt / (this.c * span) : 0;
    const fraction = isMoving ? (ray.t - from) / span + near * rate : 0;
    for (let i = 0; i < 3; i++) {
      o[i] = x[i] + dx[i] * near - samples.origin[i];
      line[i] = o[i] - moved[i] * fraction;
      line[3 + i] = dx[i] - moved[i] * rate;
    }
    const length = far - near;
    const cubic = isMoving ? samples.cubic : undefined;
    const noise = positionNoise(o, this.pieces.reach);
    const partAt = (s: number) => Math.min(parts - 1, Math.max(0, Math.floor((fraction + rate * s) * parts)));
    const step = rate < 0 ? -1 : 1;
    const last = parts === 1 || rate === 0 ? partAt(0) : partAt(length);
    for (let part = partAt(0); part * step <= last * step; part += step) {
      // Where the ray is in the part.
      const [one, other] =
        parts === 1 || rate === 0
          ? [0, length]
          : [(part / parts - fraction) / rate, ((part + 1) / parts - fraction) / rate];
      const begin = Math.max(0, Math.min(one, other));
      const end = Math.min(length, Math.max(one, other));
      traversal.start(samples.treeOf(k, part), line, begin);
      traversal.thicken(ZERO, noise + (cubic?.chordErrorIn(k) ?? 0));
      if (cubic) this.intersectCubicLeaves(cubic, dx, fraction, rate, near, end, noise, k, search);
      else this.intersectLeaves(dx, fraction, rate, near, end, noise, k, search);
    }
  }

  /** Intersects the triangles of the leaves before s = begin + `length`. */
  private intersectLeaves(
    d: Vec3,
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
    const { a, b } = triangle;
    const before = this.samples.pointsBefore(piece);
    const after = this.samples.pointsAfter(piece);
    for (;;) {
      const end = Math.min(length, search.end - begin);
      const leaf = traversal.next(end);
      if (leaf < 0) return;
      traversal.clip(leaf, end);
      const { near, far } = traversal;
      const from = bvh.link[leaf];
      for (let i = from; i < from + bvh.count[leaf]; i++) {
        for (let corner = 0; corner < 3; corner++)
          for (let axis = 0; axis < 3; axis++) {
            const at = 3 * indices[first[i] + corner] + axis;
            const moved = after[at] - before[at];
            a[3 * corner + axis] = before[at] - o[axis] + (moved * (fraction + rate * near) - d[axis] * near);
            b[3 * corner + axis] = moved * rate - d[axis];
          }
        offerCrossings(search, this, triangle, begin + near, far - near, noise, first[i], piece);
      }
    }
  }

  /** As `intersectLeaves`, for each chord that the ray passes while it is inside a leaf. */
  private intersectCubicLeaves(
    cubic: CubicChords,
    d: Vec3,
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
          this.setTriangleFromChord(d, chordFraction, chordRate, enters);
          offerCrossings(search, this, triangle, begin + enters, leaves - enters, noise, first[i], piece);
        }
    }
  }

  /** Sets the triangle's corners relative to the ray, with σ = 0 at s = `enters`. */
  private setTriangleFromChord(d: Vec3, fraction: number, rate: number, enters: number): void {
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
