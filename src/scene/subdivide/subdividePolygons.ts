import type { Polygons, PolygonValues } from '../mesh/polygons.ts';
import { type FaceVaryingRule, makeFaceVaryingChannel } from './faceVarying.ts';
import { LimitSurface, limitValues, parentFaces, type Refinement, refineTopology } from './limitSurface.ts';
import { type SubdivisionScheme, splitsTriangles } from './scheme.ts';
import { INFINITELY_SHARP, type SubdivisionTopology } from './topology.ts';

export interface SubdivisionOptions {
  readonly scheme: 'catmullClark' | 'loop' | 'bilinear';
  /** 0: the cage's own faces, with their points on the limit surface. */
  readonly levels: number;
  readonly faceVarying: FaceVaryingRule;
  /** Triangles are smoothed as Stam and Loop do (2003). */
  readonly smoothTriangles: boolean;
  /** Hidden faces influence their neighbours but are not rendered. */
  readonly hidden: (face: number) => boolean;
}

export interface SubdividedPolygons {
  /** On the limit surface; one point per slot. */
  readonly polygons: Polygons;
  readonly surface: LimitSurface;
}

/** The limit surface as polygons, with all primvars; authored normals are ignored. */
export function subdividePolygons(
  cage: Polygons,
  topology: SubdivisionTopology,
  how: SubdivisionOptions,
): SubdividedPolygons {
  const refinement = refineTopology(topology, how.scheme, refinedLevels(how), how.smoothTriangles);
  const surface = new LimitSurface(refinement);
  const { parents, faces, faceCounts, corners } = drawnFaces(cage, refinement, how);
  const carry = (values: PolygonValues, width: number): PolygonValues => {
    if (values.per === 'constant') return values;
    if (values.per === 'face') return onFaces(values, faces, parents);
    const { of, ids } = carried(values, width, topology, surface, how);
    return { per: 'corner', values: of, indices: corners.map((c) => ids[c]) };
  };
  const { positions, normals } = surface.at(cage.points);
  const polygons: Polygons = {
    points: positions,
    faceCounts,
    faceIndices: corners.map((c) => surface.slotOfCorner[c]),
    normals: { per: 'point', values: cage.leftHanded ? normals.map((x) => -x) : normals },
    ...(cage.uvs ? { uvs: carry(cage.uvs, 2) } : {}),
    ...(cage.colors ? { colors: carry(cage.colors, 3) } : {}),
    ...(cage.faceMaterials ? { faceMaterials: faces.map((f) => cage.faceMaterials![parents[f]]) } : {}),
    leftHanded: cage.leftHanded,
    doubleSided: cage.doubleSided,
  };
  return { polygons, surface };
}

/** Limit masks are those of quads, or triangles: a cage of other faces is refined once to find its own points' places. */
const refinedLevels = ({ scheme, levels }: SubdivisionOptions): number =>
  splitsTriangles(scheme) ? levels : Math.max(1, levels);

interface DrawnFaces {
  /** The cage face that contains each face before hidden ones are left out. */
  readonly parents: Uint32Array;
  /** Faces that are not hidden. */
  readonly faces: Uint32Array;
  readonly faceCounts: ArrayLike<number>;
  /** The refined corner of each corner of these. */
  readonly corners: Uint32Array;
}

function drawnFaces(cage: Polygons, refinement: Refinement, how: SubdivisionOptions): DrawnFaces {
  if (refinement.steps.length > how.levels) return cageFaces(cage, how.hidden);
  const parents = parentFaces(refinement, cage.faceCounts);
  const faces = parents.map((_, f) => f).filter((f) => !how.hidden(parents[f]));
  const size = splitsTriangles(how.scheme) ? 3 : 4;
  const corners = new Uint32Array(size * faces.length).map((_, c) => size * faces[Math.floor(c / size)] + (c % size));
  return { parents, faces, faceCounts: new Uint8Array(faces.length).fill(size), corners };
}

/** Of a cage that was split into quads once: quad k has corner k's point first. */
function cageFaces({ faceCounts }: Polygons, hidden: (face: number) => boolean): DrawnFaces {
  const parents = Uint32Array.from(faceCounts, (_, f) => f);
  const faces = parents.filter((f) => !hidden(f));
  const counts = faces.map((f) => faceCounts[f]);
  const corners = new Uint32Array(counts.reduce((sum, n) => sum + n, 0));
  let [at, first] = [0, 0];
  for (const f of parents) {
    if (!hidden(f)) for (let k = 0; k < faceCounts[f]; k++) corners[at++] = 4 * (first + k);
    first += faceCounts[f];
  }
  return { parents, faces, faceCounts: counts, corners };
}

const onFaces = ({ values, indices }: PolygonValues, faces: Uint32Array, parents: Uint32Array): PolygonValues => ({
  per: 'face',
  values,
  indices: faces.map((f) => (indices ? indices[parents[f]] : parents[f])),
});

/** Refined point or corner values, and the index into them of each refined corner. */
function carried(
  given: PolygonValues,
  width: number,
  topology: SubdivisionTopology,
  { refinement }: LimitSurface,
  options: SubdivisionOptions,
): { of: Float64Array; ids: Uint32Array } {
  const { scheme, faceVarying, smoothTriangles } = options;
  const levels = refinedLevels(options);
  const linear: SubdivisionScheme = splitsTriangles(scheme) ? 'linear' : 'bilinear';
  if (given.per === 'corner') {
    const channel = makeFaceVaryingChannel(topology, given, width, faceVarying);
    const how = faceVarying === 'all' ? linear : scheme;
    const refined = refineTopology(channel.topology, how, levels, smoothTriangles);
    return { of: limitValues(refined, channel.values, width), ids: refined.topology.corners };
  }
  const onPoints = new Float64Array(topology.points * width);
  for (let p = 0; p < topology.points; p++)
    for (let k = 0; k < width; k++)
      onPoints[p * width + k] = given.values[(given.indices ? given.indices[p] : p) * width + k] ?? 0;
  const how = given.linear ? refineTopology(topology, linear, levels) : refinement;
  return { of: limitValues(how, onPoints, width), ids: refinement.topology.corners };
}

/** Faces at an open boundary, hidden where boundaries are not interpolated; boundaries authored as sharp are kept. */
export function boundaryFaces(topology: SubdivisionTopology, sharpness: (a: number, b: number) => number): Uint8Array {
  const { twins, corners, cornerEdges, edgePoints, faceOfCorner } = topology;
  const open = new Uint8Array(topology.points);
  for (let c = 0; c < corners.length; c++) {
    const [a, b] = [edgePoints[2 * cornerEdges[c]], edgePoints[2 * cornerEdges[c] + 1]];
    if (twins[c] < 0 && !(sharpness(a, b) >= INFINITELY_SHARP)) open[a] = open[b] = 1;
  }
  const faces = new Uint8Array(topology.faceStarts.length - 1);
  for (let c = 0; c < corners.length; c++) if (open[corners[c]]) faces[faceOfCorner[c]] = 1;
  return faces;
}
