import { cross, dot, length, normalize, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { pointAt } from '../mesh/polygons.ts';
import { creasesAt } from './rules.ts';
import { INFINITELY_SHARP, type SubdivisionTopology } from './topology.ts';

/**
 * How far a mesh that has the faces of a control cage, with its points on the limit surface, is from that surface: an
 * estimate from second differences, in the units of the points. Each level of subdivision divides it by 4.
 *
 * Of each face it adds the heights of the arcs from its middle to those of its neighbours, in both directions across it;
 * it takes the greatest, or the height of an arc along a crease or boundary, or how far a face is from flat.
 */
export function distanceFromLimit(topology: SubdivisionTopology, points: ArrayLike<number>): number {
  const planes = facePlanes(topology, points);
  return Math.max(
    greatestBend(topology, planes),
    greatestCreaseBend(topology, points),
    greatestTwist(topology, points, planes),
  );
}

/** 3 numbers per face; normals of unit length, 0 for faces without area. */
interface FacePlanes {
  readonly centers: Float64Array;
  readonly normals: Float64Array;
}

function facePlanes({ faceStarts, corners }: SubdivisionTopology, points: ArrayLike<number>): FacePlanes {
  const faces = faceStarts.length - 1;
  const [centers, normals] = [new Float64Array(3 * faces), new Float64Array(3 * faces)];
  for (let f = 0; f < faces; f++) {
    const [first, end] = [faceStarts[f], faceStarts[f + 1]];
    const origin = 3 * corners[first];
    const area: [number, number, number] = [0, 0, 0];
    for (let c = first; c < end; c++) {
      const [p, q] = [3 * corners[c], 3 * corners[c + 1 < end ? c + 1 : first]];
      for (let k = 0; k < 3; k++) {
        const [i, j] = [(k + 1) % 3, (k + 2) % 3];
        centers[3 * f + k] += points[p + k] / (end - first);
        // Newell's sum, which is exact for planes and a mean for other polygons.
        area[k] += (points[p + i] - points[q + i]) * (points[p + j] + points[q + j] - 2 * points[origin + j]);
      }
    }
    normals.set(normalize(area, ZERO), 3 * f);
  }
  return { centers, normals };
}

/** Of arcs from the middle of a face to that of the next: distance times turn, over 8. */
function greatestBend(topology: SubdivisionTopology, { centers, normals }: FacePlanes): number {
  const { faceStarts, faceOfCorner, twins, cornerEdges, edgeSharpness } = topology;
  let most = 0;
  for (let f = 0; f + 1 < faceStarts.length; f++) {
    // Edges of a quad lie in two directions; those of other faces are near enough to it.
    const across = [0, 0];
    for (let c = faceStarts[f]; c < faceStarts[f + 1]; c++) {
      if (twins[c] < 0 || edgeSharpness[cornerEdges[c]] >= INFINITELY_SHARP) continue;
      const other = faceOfCorner[twins[c]];
      const turn = sub(pointAt(normals, other), pointAt(normals, f));
      const height = Math.abs(dot(sub(pointAt(centers, other), pointAt(centers, f)), turn)) / 8;
      const direction = (c - faceStarts[f]) % 2;
      across[direction] = Math.max(across[direction], height);
    }
    most = Math.max(most, across[0] + across[1]);
  }
  return most;
}

/** The same along creases and boundaries, whose points are a quarter of a second difference from their chords. */
function greatestCreaseBend(topology: SubdivisionTopology, points: ArrayLike<number>): number {
  const { counts, ends } = creasesAt(topology, topology.edgeSharpness);
  let most = 0;
  for (let p = 0; p < topology.points; p++) {
    if (counts[p] !== 2 || topology.pointSharpness[p] > 0) continue;
    const [from, at, to] = [ends[2 * p], p, ends[2 * p + 1]].map((i): Vec3 => pointAt(points, i));
    const chord = sub(to, from);
    const across = length(cross(chord, sub(at, from)));
    if (across > 0) most = Math.max(most, across / length(chord) / 4);
  }
  return most;
}

/** Distances of corners from the planes of their faces. */
function greatestTwist(
  { corners, faceOfCorner }: SubdivisionTopology,
  points: ArrayLike<number>,
  { centers, normals }: FacePlanes,
): number {
  let most = 0;
  for (let c = 0; c < corners.length; c++) {
    const f = faceOfCorner[c];
    const out = sub(pointAt(points, corners[c]), pointAt(centers, f));
    most = Math.max(most, Math.abs(dot(out, pointAt(normals, f))));
  }
  return most;
}
