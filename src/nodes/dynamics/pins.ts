import { length, sub, type Vec3 } from '../../math/vec3.ts';
import { boundingBox } from '../../scene/bounds.ts';
import { pointAt } from '../../scene/polygons.ts';
import { refusal } from '../geometry/shared.ts';
import type { NetMatter } from './matter.ts';
import { FLAT } from './things.ts';

/** The points of a thing that are held. */
export function pinnedIn(
  points: Float64Array,
  pointOfVertex: Uint32Array,
  { pins, node }: NetMatter,
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
      const message = `${path} has no point ${odd}: they are numbered from 0 to ${pointOfVertex.length - 1}`;
      throw refusal('pins.numbers', `${node}.pinned`, message, { node, param: 'pinned', value: '0' });
    }
    case 'box': {
      const isIn = (i: number): boolean =>
        [0, 1, 2].every((k) => Math.abs(points[3 * i + k] - pins.center[k]) <= pins.size[k] / 2);
      return new Set(all.filter(isIn));
    }
    case 'top': {
      const { min, max } = boundingBox(points)!;
      const least = max[up] - FLAT * length(sub(max, min));
      return new Set(all.filter((i) => points[3 * i + up] >= least));
    }
    case 'corners':
      return new Set(cornersOf(points, up).map((corner) => nearestTo(points, corner)));
  }
}

/** The four upper corners of the box round points. */
function cornersOf(points: Float64Array, up: number): Vec3[] {
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

function nearestTo(points: Float64Array, place: Vec3): number {
  let [nearest, least] = [0, Number.POSITIVE_INFINITY];
  for (let i = 0; 3 * i < points.length; i++) {
    const away = length(sub(pointAt(points, i), place));
    if (away < least) [nearest, least] = [i, away];
  }
  return nearest;
}
