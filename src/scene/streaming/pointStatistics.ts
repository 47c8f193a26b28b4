import { boundingBox, boundingSphere, finiteBox } from '../bounds/bounds.ts';
import type { PointRecipe, PointStatistics } from './storedPoints.ts';
import { makePoints } from './streamedPoints.ts';

/** The vertex with the longest displacement between two samples, and its length [m]; vertex 0 if all rest. */
export function longestDisplacement(
  a: Float32Array,
  b: Float32Array,
): { readonly length: number; readonly vertex: number } {
  let square = 0;
  let vertex = 0;
  for (let i = 0; i < a.length; i += 3) {
    const x = b[i] - a[i];
    const y = b[i + 1] - a[i + 1];
    const z = b[i + 2] - a[i + 2];
    const s = x * x + y * y + z * z;
    if (s > square && s < Number.POSITIVE_INFINITY) {
      square = s;
      vertex = i / 3;
    }
  }
  return { length: Math.sqrt(square), vertex };
}

/** Reads every sample once and computes the statistics; `onProgress` is called with the fraction that is read. */
export function computePointStatistics(
  recipe: PointRecipe,
  onProgress: (part: number) => void = () => {},
): PointStatistics {
  const n = recipe.samples.length;
  const statistics = {
    boxes: new Float64Array(6 * n),
    radii: new Float64Array(n),
    displacements: new Float64Array(n - 1),
    fastest: new Uint32Array(n - 1),
    firstNonFinite: -1,
  };
  let previous: Float32Array | undefined;
  let nonFinite: Uint8Array | undefined;
  for (let k = 0; k < n; k++) {
    const points = makePoints(recipe, k);
    const finite = finiteBox(points);
    const box = finite ?? boundingBox(points);
    statistics.boxes.set(box ? [...box.min, ...box.max] : [1, 1, 1, -1, -1, -1], 6 * k);
    statistics.radii[k] = boundingSphere(points, box).radius;
    if (!finite) {
      if (statistics.firstNonFinite < 0) statistics.firstNonFinite = k;
      nonFinite = markNonFinite(points, nonFinite);
    }
    if (previous) {
      const { length, vertex } = longestDisplacement(previous, points);
      statistics.displacements[k - 1] = length;
      statistics.fastest[k - 1] = vertex;
    }
    previous = points;
    onProgress((k + 1) / n);
  }
  return nonFinite ? { ...statistics, nonFiniteVertices: nonFinite } : statistics;
}

/** Marks the vertices with coordinates that are not finite. */
function markNonFinite(points: Float32Array, marks: Uint8Array = new Uint8Array(points.length / 3)): Uint8Array {
  for (let i = 0; i < points.length; i++) if (!Number.isFinite(points[i])) marks[Math.floor(i / 3)] = 1;
  return marks;
}
