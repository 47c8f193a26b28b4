import { length, sub, type Vec3 } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { boundingBox } from '../../scene/bounds/bounds.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import { nodeRefusal } from '../common/params.ts';
import type { MassSpringMatter } from './matter.ts';
import { FLATNESS_TOLERANCE } from './objects.ts';

/** The pinned points of an object. */
export function pinnedPoints(
  points: Float64Array,
  pointOfVertex: Uint32Array,
  { pins, node }: MassSpringMatter,
  up: number,
  path: string,
): ReadonlySet<number> {
  const all = Array.from({ length: points.length / 3 }, (_, i) => i);
  switch (pins.kind) {
    case 'none':
      return new Set();
    case 'points': {
      const odd = pins.vertices.find((vertex) => vertex >= pointOfVertex.length);
      if (odd === undefined) return new Set(pins.vertices.map((vertex) => pointOfVertex[vertex]));
      const message = msg`${path} has no point ${odd}: they are numbered from 0 to ${pointOfVertex.length - 1}`;
      throw nodeRefusal('pins.numbers', `${node}.pinned`, message, { node, param: 'pinned', value: '0' });
    }
    case 'box': {
      const isIn = (i: number): boolean =>
        [0, 1, 2].every((k) => Math.abs(points[3 * i + k] - pins.center[k]) <= pins.size[k] / 2);
      return new Set(all.filter(isIn));
    }
    case 'top': {
      const { min, max } = boundingBox(points)!;
      const least = max[up] - FLATNESS_TOLERANCE * length(sub(max, min));
      return new Set(all.filter((i) => points[3 * i + up] >= least));
    }
    case 'corners':
      return new Set(upperCorners(points, up).map((corner) => nearestPoint(points, corner)));
  }
}

/** The four upper corners of the points' bounding box. */
function upperCorners(points: Float64Array, up: number): Vec3[] {
  const { min, max } = boundingBox(points)!;
  const [a, b] = [0, 1, 2].filter((k) => k !== up);
  return [min[a], max[a]].flatMap((p) =>
    [min[b], max[b]].map((q) => {
      const corner = [max[0], max[1], max[2]];
      corner[a] = p;
      corner[b] = q;
      return corner as unknown as Vec3;
    }),
  );
}

function nearestPoint(points: Float64Array, place: Vec3): number {
  let [nearest, least] = [0, Number.POSITIVE_INFINITY];
  for (let i = 0; 3 * i < points.length; i++) {
    const away = length(sub(pointAt(points, i), place));
    if (away < least) [nearest, least] = [i, away];
  }
  return nearest;
}
