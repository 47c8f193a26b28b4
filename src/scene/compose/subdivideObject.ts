import { gatherPoints, makeMesh } from '../mesh/makeMesh.ts';
import { withoutQuadric } from '../mesh/quadric.ts';
import { normalizeInPlace } from '../mesh/transformPoints.ts';
import { pointSamples } from '../motion/motion.ts';
import { isBlended, isListed, isStreamed, withListedPoints } from '../streaming/samplePoints.ts';
import { subdividePolygons } from '../subdivide/subdividePolygons.ts';
import { makeTopology } from '../subdivide/topology.ts';
import type { Mesh, SampledPointsMotion, SceneObject } from '../types.ts';
import { weld } from './weld.ts';

/** Most triangles of a subdivided mesh. */
export const MAX_TRIANGLES = 4_000_000;

/** Number of triangles after subdivision; each level splits a triangle into four. */
export const trianglesAfter = ({ indices }: Mesh, levels: number): number => (indices.length / 3) * 4 ** levels;

/** Most numbers of the points and normals of a skin that is subdivided, since then all its samples are in memory. */
const MAX_LISTED_NUMBERS = 2 ** 26;

/** Whether its samples can be subdivided: streamed samples cannot, nor can those of a skin that are too many for memory. */
export function canSubdivide({ mesh, motion }: SceneObject): boolean {
  const samples = pointSamples(motion);
  if (!samples || isListed(samples.points)) return true;
  return isBlended(samples.points) && 2 * samples.times.length * mesh.positions.length <= MAX_LISTED_NUMBERS;
}

/** Splits all triangles `levels` times at the midpoints of their edges, without changing the shape. */
export function midpointSubdivide(object: SceneObject, levels: number): SceneObject {
  let { mesh, motion } = object;
  for (let level = 0; level < levels; level++) {
    const middles = new MidpointMesh(mesh);
    mesh = middles.mesh;
    const samples = pointSamples(motion);
    if (samples) motion = splitSamples(samples, middles);
  }
  return { ...object, mesh, motion };
}

/** A mesh split once. Its first vertices are those of the original; the others are midpoints of two of them. */
class MidpointMesh {
  readonly mesh: Mesh;
  private readonly ends: number[] = [];
  private readonly midpoints = new Map<number, number>();
  private readonly vertices: number;

  constructor(mesh: Mesh) {
    this.vertices = mesh.positions.length / 3;
    const { indices } = mesh;
    const split = new Uint32Array(4 * indices.length);
    for (let t = 0; t < indices.length; t += 3) {
      const [a, b, c] = [indices[t], indices[t + 1], indices[t + 2]];
      const [ab, bc, ca] = [this.middle(a, b), this.middle(b, c), this.middle(c, a)];
      split.set([a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca], 4 * t);
    }
    this.mesh = {
      ...withoutQuadric(mesh),
      positions: this.mean(mesh.positions, 3),
      normals: normalizeInPlace(this.mean(mesh.normals, 3)),
      uvs: this.mean(mesh.uvs, 2),
      ...(mesh.colors && { colors: this.mean(mesh.colors, 3) }),
      indices: split,
      groups: mesh.groups.map(({ start, count, material }) => ({ start: 4 * start, count: 4 * count, material })),
    };
  }

  private middle(a: number, b: number): number {
    const key = Math.min(a, b) * this.vertices + Math.max(a, b);
    const existing = this.midpoints.get(key);
    if (existing !== undefined) return existing;
    const vertex = this.vertices + this.ends.length / 2;
    this.ends.push(a, b);
    this.midpoints.set(key, vertex);
    return vertex;
  }

  /** Values of the original vertices, `width` numbers each, followed by those of the midpoints. */
  mean(values: Float32Array, width: number): Float32Array {
    const out = new Float32Array(values.length + (this.ends.length / 2) * width);
    out.set(values);
    for (let i = 0, at = values.length; i < this.ends.length; i += 2)
      for (let k = 0; k < width; k++, at++)
        out[at] = (values[width * this.ends[i] + k] + values[width * this.ends[i + 1] + k]) / 2;
    return out;
  }
}

function splitSamples(motion: SampledPointsMotion, middles: MidpointMesh): SampledPointsMotion {
  if (isStreamed(motion.points)) return motion;
  const { points, velocities, normals } = withListedPoints(motion);
  return {
    ...motion,
    points: points.map((each) => middles.mean(each, 3)),
    ...(velocities && { velocities: velocities.map((each) => middles.mean(each, 3)) }),
    ...(normals && { normals: normals.map((each) => normalizeInPlace(middles.mean(each, 3))) }),
  };
}

/** Loop subdivision (1987) with `levels` levels; the points are on the limit surface. */
export function loopSubdivide(object: SceneObject, levels: number): SceneObject {
  const { mesh, motion } = object;
  const { pointOfVertex: welded, vertexOfPoint } = weld(mesh.positions);
  const cage = cageOf(mesh, welded, vertexOfPoint);
  const topology = makeTopology({
    points: vertexOfPoint.length,
    faceCounts: cage.faceCounts,
    faceIndices: cage.faceIndices,
    sharpCorners: true,
  });
  const { polygons, surface } = subdividePolygons(cage, topology, {
    scheme: 'loop',
    levels,
    faceVarying: 'cornersPlus1',
    smoothTriangles: false,
    hidden: () => false,
  });
  const { mesh: refined, pointOfVertex } = makeMesh(polygons);
  const moving = pointSamples(motion);
  if (!moving || isStreamed(moving.points)) return { ...object, mesh: refined };
  const deforming = withListedPoints(moving);
  const at = (values: Float32Array) => surface.at(gatherPoints(values, vertexOfPoint));
  const samples = deforming.points.map(at);
  const gathered = (values: Float32Array) => gatherPoints(values, pointOfVertex);
  const { velocities } = deforming;
  return {
    ...object,
    mesh: refined,
    motion: {
      ...deforming,
      points: samples.map(({ positions }) => gathered(positions)),
      normals: samples.map(({ normals }) => gathered(normals)),
      ...(velocities && { velocities: velocities.map((each) => gathered(at(each).positions)) }),
    },
  };
}

/** The control mesh; triangles without three different points are omitted. */
function cageOf(mesh: Mesh, welded: Uint32Array, vertexOfPoint: Uint32Array) {
  const corners: number[] = [];
  const faceMaterials: number[] = [];
  for (const { start, count, material } of mesh.groups)
    for (let i = start; i < start + count; i += 3) {
      const face = mesh.indices.subarray(i, i + 3);
      if (new Set(Array.from(face, (v) => welded[v])).size < 3) continue;
      corners.push(...face);
      faceMaterials.push(material);
    }
  const perCorner = (values: Float32Array) => ({ per: 'corner' as const, values, indices: corners });
  return {
    points: gatherPoints(mesh.positions, vertexOfPoint),
    faceCounts: new Uint8Array(faceMaterials.length).fill(3),
    faceIndices: corners.map((v) => welded[v]),
    uvs: perCorner(mesh.uvs),
    ...(mesh.colors && { colors: perCorner(mesh.colors) }),
    faceMaterials,
    doubleSided: mesh.doubleSided,
  };
}
