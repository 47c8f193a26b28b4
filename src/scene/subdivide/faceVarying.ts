import { cornersAround, type PolygonValues } from '../mesh/polygons.ts';
import { INFINITELY_SHARP, makeTopology, type SubdivisionTopology } from './topology.ts';

/** Where face-varying values are interpolated linearly: at boundaries of their islands, e.g. texture seams (OpenSubdiv's names, as in USD). */
export type FaceVaryingRule = 'none' | 'cornersOnly' | 'cornersPlus1' | 'cornersPlus2' | 'boundaries' | 'all';

/** A face-varying channel with its own topology: corners at one point that have equal values share a value. */
export interface FaceVaryingChannel {
  readonly topology: SubdivisionTopology;
  /** `width` numbers for each of its points. */
  readonly values: Float64Array;
}

/** Maximum number of distinct values compared at one point; further ones count as distinct. */
const MAX_COMPARED_VALUES = 64;

export function makeFaceVaryingChannel(
  mesh: SubdivisionTopology,
  given: PolygonValues,
  width: number,
  rule: FaceVaryingRule,
): FaceVaryingChannel {
  const { ids, count, values } = weldValues(mesh, given, width);
  const faceCounts = Array.from(
    { length: mesh.faceStarts.length - 1 },
    (_, f) => mesh.faceStarts[f + 1] - mesh.faceStarts[f],
  );
  const plain = makeTopology({ points: count, faceCounts, faceIndices: ids, sharpCorners: false });
  const edgeSharpness = plain.edgeSharpness.slice();
  ids.forEach((_, c) => {
    if (plain.twins[c] >= 0) edgeSharpness[plain.cornerEdges[c]] = mesh.edgeSharpness[mesh.cornerEdges[c]];
  });
  const topology = { ...plain, edgeSharpness, pointSharpness: pointSharpness(mesh, plain, rule) };
  return { topology, values };
}

function weldValues({ points, corners }: SubdivisionTopology, { values, indices }: PolygonValues, width: number) {
  const first = new Int32Array(points).fill(-1);
  const next = new Int32Array(corners.length).fill(-1);
  const ids = new Uint32Array(corners.length);
  const out = new Float64Array(corners.length * width);
  let count = 0;
  const isSame = (id: number, from: number): boolean => {
    for (let k = 0; k < width; k++) if (out[id * width + k] !== (values[from + k] ?? 0)) return false;
    return true;
  };
  for (let c = 0; c < corners.length; c++) {
    const from = (indices ? indices[c] : c) * width;
    let [id, compared] = [first[corners[c]], 0];
    while (id >= 0 && compared++ < MAX_COMPARED_VALUES && !isSame(id, from)) id = next[id];
    if (id < 0 || compared > MAX_COMPARED_VALUES) {
      id = count++;
      for (let k = 0; k < width; k++) out[id * width + k] = values[from + k] ?? 0;
      next[id] = first[corners[c]];
      first[corners[c]] = id;
    }
    ids[c] = id;
  }
  return { ids, count, values: out.slice(0, count * width) };
}

/** Sharpness of each value: the mesh's own at inner points; at boundaries what the rule pins. */
function pointSharpness(mesh: SubdivisionTopology, channel: SubdivisionTopology, rule: FaceVaryingRule): Float64Array {
  const isBorder = new Uint8Array(channel.points);
  channel.twins.forEach((twin, c) => {
    if (twin < 0) for (const end of [0, 1]) isBorder[channel.edgePoints[2 * channel.cornerEdges[c] + end]] = 1;
  });
  const around = cornersAround(mesh.corners, mesh.points);
  const faces = new Uint32Array(channel.points);
  for (const id of channel.corners) faces[id]++;
  const out = channel.pointSharpness.slice();
  for (let p = 0; p < mesh.points; p++) {
    const ids = new Set(Array.from(around(p), (c) => channel.corners[c]));
    const isInside = Array.from(around(p)).every((c) => mesh.twins[c] >= 0);
    for (const id of ids) {
      if (!isBorder[id]) out[id] = mesh.pointSharpness[p];
      else if (
        isPinned(
          rule,
          [...ids].map((i) => faces[i]),
          faces[id],
          isInside,
        )
      )
        out[id] = INFINITELY_SHARP;
    }
  }
  return out;
}

/** `all`: how many faces each value at the point has, `own` of them this one. */
function isPinned(rule: FaceVaryingRule, all: readonly number[], own: number, isInside: boolean): boolean {
  if (rule === 'none') return false;
  if (rule === 'boundaries' || own === 1) return true;
  if (rule === 'cornersOnly') return false;
  if (all.length > 2) return true;
  if (rule === 'cornersPlus1') return false;
  // A dart of a seam, and the other side of a corner.
  return all.length === 1 ? isInside : all.includes(1);
}
