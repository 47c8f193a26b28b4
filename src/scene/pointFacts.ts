import { boundingBox, boundingSphere, finiteBox } from './bounds.ts';
import { makePoints, type PointFacts, type PointRecipe } from './streamedPoints.ts';

/** A piece of a motion between two samples, and its fastest vertex. */
export interface FastestOfPiece {
  /** [m/s] */
  readonly speed: number;
  readonly vertex: number;
}

/** The fastest vertex on the way from one sample to the next in `span` [s]; vertex 0 where all rest. */
export function fastestOfPiece(a: Float32Array, b: Float32Array, span: number): FastestOfPiece {
  let square = 0;
  let vertex = 0;
  for (let i = 0; i < a.length; i += 3) {
    const x = b[i] - a[i];
    const y = b[i + 1] - a[i + 1];
    const z = b[i + 2] - a[i + 2];
    const s = x * x + y * y + z * z;
    if (s > square) {
      square = s;
      vertex = i / 3;
    }
  }
  return { speed: Math.sqrt(square) / span, vertex };
}

/** Reads every sample once, and keeps what is asked of all of them. Times [s]; `progress` is told the part that is read. */
export function surveyPoints(
  recipe: PointRecipe,
  times: Float64Array,
  progress: (part: number) => void = () => {},
): PointFacts {
  const n = times.length;
  const facts = {
    boxes: new Float64Array(6 * n),
    radii: new Float64Array(n),
    speeds: new Float64Array(n - 1),
    fastest: new Uint32Array(n - 1),
    broken: -1,
  };
  let before: Float32Array | undefined;
  for (let k = 0; k < n; k++) {
    const points = makePoints(recipe, k);
    const finite = finiteBox(points);
    const box = finite ?? boundingBox(points);
    facts.boxes.set(box ? [...box.min, ...box.max] : [1, 1, 1, -1, -1, -1], 6 * k);
    facts.radii[k] = boundingSphere(points, box).radius;
    if (facts.broken < 0 && !finite) facts.broken = k;
    if (before) {
      const { speed, vertex } = fastestOfPiece(before, points, times[k] - times[k - 1]);
      facts.speeds[k - 1] = speed;
      facts.fastest[k - 1] = vertex;
    }
    before = points;
    progress((k + 1) / n);
  }
  return facts;
}
