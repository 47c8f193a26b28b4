import { decaySharpness } from './rules.ts';
import { nextCorner, previousCorner, type SubdivisionTopology } from './topology.ts';

/**
 * The next level of quads: one face per corner (its point, the edge point, the face point, the previous edge point).
 * Point order: the old points, one per edge, one per face. Face k comes from corner k.
 */
export function splitIntoQuads(topology: SubdivisionTopology): SubdivisionTopology {
  const { points, corners, cornerEdges, twins, edgePoints, faceOfCorner } = topology;
  const edges = edgePoints.length / 2;
  const child = emptyLevel(topology, 4, corners.length, points + edges + topology.faceStarts.length - 1);
  for (let c = 0; c < corners.length; c++) {
    const [next, before] = [nextCorner(topology, c), previousCorner(topology, c)];
    const [out, back] = [cornerEdges[c], cornerEdges[before]];
    child.corners.set([corners[c], points + out, points + edges + faceOfCorner[c], points + back], 4 * c);
    const [inner, innerBefore] = [2 * edges + c, 2 * edges + before];
    child.cornerEdges.set([halfAt(topology, out, c), inner, innerBefore, halfAt(topology, back, c)], 4 * c);
    const across = twins[c] < 0 ? -1 : 4 * nextCorner(topology, twins[c]) + 3;
    const acrossBefore = twins[before] < 0 ? -1 : 4 * twins[before];
    child.twins.set([across, 4 * next + 2, 4 * before + 1, acrossBefore], 4 * c);
    child.edgePoints.set([points + out, points + edges + faceOfCorner[c]], 2 * inner);
  }
  return child;
}

/**
 * The next level of triangles: one at each corner and one in the middle. Point order: the old points, one per edge.
 * Face 4f + k comes from corner k of face f, 4f + 3 is the middle one.
 */
export function splitIntoTriangles(topology: SubdivisionTopology): SubdivisionTopology {
  const { points, corners, cornerEdges, twins, edgePoints } = topology;
  const edges = edgePoints.length / 2;
  const child = emptyLevel(topology, 3, (4 * corners.length) / 3, points + edges);
  /** First corner of a corner's triangle. */
  const at = (c: number): number => 12 * Math.floor(c / 3) + 3 * (c % 3);
  for (let c = 0; c < corners.length; c++) {
    const [next, before] = [nextCorner(topology, c), previousCorner(topology, c)];
    const [out, back] = [cornerEdges[c], cornerEdges[before]];
    const middle = 12 * Math.floor(c / 3) + 9;
    const inner = 2 * edges + c;
    child.corners.set([corners[c], points + out, points + back], at(c));
    child.cornerEdges.set([halfAt(topology, out, c), inner, halfAt(topology, back, c)], at(c));
    const across = twins[c] < 0 ? -1 : at(nextCorner(topology, twins[c])) + 2;
    const acrossBefore = twins[before] < 0 ? -1 : at(twins[before]);
    child.twins.set([across, middle + (before % 3), acrossBefore], at(c));
    child.corners[middle + (c % 3)] = points + out;
    child.cornerEdges[middle + (c % 3)] = 2 * edges + next;
    child.twins[middle + (c % 3)] = at(next) + 1;
    child.edgePoints.set([points + out, points + back], 2 * inner);
  }
  return child;
}

/** The next level with the old edges split, the rest to be filled in. */
function emptyLevel(parent: SubdivisionTopology, size: number, faces: number, points: number): SubdivisionTopology {
  const { edgePoints, corners } = parent;
  const edges = edgePoints.length / 2;
  const halves = new Uint32Array(4 * edges + 2 * corners.length);
  const edgeSharpness = new Float64Array(2 * edges + corners.length);
  const [edgeLeft, pointLeft] = [decaySharpness(parent.edgeSharpness), decaySharpness(parent.pointSharpness)];
  for (let e = 0; e < edges; e++) {
    halves.set([edgePoints[2 * e], parent.points + e, edgePoints[2 * e + 1], parent.points + e], 4 * e);
    edgeSharpness.fill(edgeLeft[e], 2 * e, 2 * e + 2);
  }
  const pointSharpness = new Float64Array(points);
  pointSharpness.set(pointLeft);
  return {
    points,
    faceStarts: new Uint32Array(faces + 1).map((_, f) => size * f),
    faceOfCorner: new Uint32Array(size * faces).map((_, c) => Math.floor(c / size)),
    corners: new Uint32Array(size * faces),
    cornerEdges: new Uint32Array(size * faces),
    twins: new Int32Array(size * faces),
    edgePoints: halves,
    edgeSharpness,
    pointSharpness,
  };
}

/** The half of an edge at a corner's point. */
const halfAt = ({ edgePoints, corners }: SubdivisionTopology, edge: number, corner: number): number =>
  2 * edge + (edgePoints[2 * edge] === corners[corner] ? 0 : 1);
