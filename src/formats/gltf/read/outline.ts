import type { Mat4 } from '../../../math/mat4.ts';
import type { Deformer } from './deform.ts';
import type { Geometry } from './primitives.ts';

/** A mesh with how its joints are bound to it. */
export interface BoundGeometry extends Pick<Deformer, 'binds' | 'isSkinned' | 'pointsAt'> {
  readonly geometry: Geometry;
}

/** Number of vertices of a mesh with morph targets whose paths are followed too. */
const MAX_PROBED_POINTS = 256;

/**
 * The points by whose paths the times of a deforming mesh are chosen: the corners of the box of what follows each joint, from whose chords no vertex is farther
 * than the farthest of them, since its place is a mean of places in these boxes; and some vertices if there are morph targets. `peers`: all meshes
 * with the same joints.
 */
export function deformingOutline(
  geometry: Geometry,
  deformer: Deformer,
  peers: readonly BoundGeometry[],
): (t: number) => Float64Array {
  const corners = jointCorners(peers);
  const vertices = geometry.mesh.positions.length / 3;
  const probed = geometry.morphs.length > 0 ? Math.min(MAX_PROBED_POINTS, vertices) : 0;
  const probes = Array.from({ length: probed }, (_, i) => Math.floor((i * vertices) / probed));
  const count = corners.reduce((sum, each) => sum + each.length, 0);
  const out = new Float64Array(count + 3 * probed);
  return (t) => {
    let at = 0;
    const frames = deformer.framesAt(t);
    for (const [j, own] of corners.entries()) {
      const m = frames[j];
      for (let i = 0; i < own.length; i += 3)
        for (let row = 0; row < 12; row += 4)
          out[at++] = m[row] * own[i] + m[row + 1] * own[i + 1] + m[row + 2] * own[i + 2] + m[row + 3];
    }
    if (probed > 0) out.set(deformer.pointsAt(t, probes), at);
    return out;
  };
}

/** By joint the corners of the box of the vertices that follow it, in its axes, 3 numbers each; none for joints without any. */
function jointCorners(peers: readonly BoundGeometry[]): number[][] {
  const boxes: number[][] = [];
  for (const { geometry, binds, isSkinned } of peers) {
    const { mesh, skin } = geometry;
    for (let v = 0; v < mesh.positions.length / 3; v++) {
      if (isSkinned && skin)
        for (let i = skin.perPoint * v; i < skin.perPoint * (v + 1); i++)
          if (skin.weights[i] !== 0) extendBox(boxes, skin.joints[i], binds, mesh.positions, v);
      if (!isSkinned) extendBox(boxes, 0, binds, mesh.positions, v);
    }
  }
  return Array.from(boxes, cornersOf);
}

/** Extends a joint's box by a vertex. */
function extendBox(boxes: number[][], joint: number, binds: readonly Mat4[], positions: Float32Array, v: number): void {
  boxes[joint] ??= [...EMPTY];
  const [box, m] = [boxes[joint], binds[joint]];
  for (let axis = 0; axis < 3; axis++) {
    const row = 4 * axis;
    const x =
      m[row] * positions[3 * v] + m[row + 1] * positions[3 * v + 1] + m[row + 2] * positions[3 * v + 2] + m[row + 3];
    if (x < box[axis]) box[axis] = x;
    if (x > box[3 + axis]) box[3 + axis] = x;
  }
}

const EMPTY = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];

function cornersOf(box: readonly number[] | undefined): number[] {
  if (!box || !(box[0] <= box[3])) return [];
  return [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [
    box[3 * (i & 1)],
    box[3 * ((i >> 1) & 1) + 1],
    box[3 * (i >> 2) + 2],
  ]);
}
