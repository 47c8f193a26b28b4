import { boundingBox, boundingSphere, finiteBox } from '../bounds/bounds.ts';
import type { PointRecipe, PointStatistics } from './storedPoints.ts';
import { makePoints } from './streamedPoints.ts';

/** The vertex that goes farthest from one sample to the next, and how far [m]; vertex 0 where all rest. */
export function longestDisplacement(
  a: Float32Array,
  b: Float32Array,
): { readonly way: number; readonly vertex: number } {
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
  return { way: Math.sqrt(square), vertex };
}

/** Reads every sample once, and keeps what is asked of all of them; `progress` is told the part that is read. */
export function computePointStatistics(
  recipe: PointRecipe,
  progress: (part: number) => void = () => {},
): PointStatistics {
  const n = recipe.samples.length;
  const facts = {
    boxes: new Float64Array(6 * n),
    radii: new Float64Array(n),
    displacements: new Float64Array(n - 1),
    fastest: new Uint32Array(n - 1),
    firstNonFinite: -1,
  };
  let before: Float32Array | undefined;
  let lost: Uint8Array | undefined;
  for (let k = 0; k < n; k++) {
    const points = makePoints(recipe, k);
    const finite = finiteBox(points);
    const box = finite ?? boundingBox(points);
    facts.boxes.set(box ? [...box.min, ...box.max] : [1, 1, 1, -1, -1, -1], 6 * k);
    facts.radii[k] = boundingSphere(points, box).radius;
    if (!finite) {
      if (facts.firstNonFinite < 0) facts.firstNonFinite = k;
      lost = markNonFinite(points, lost);
    }
    if (before) {
      const { way, vertex } = longestDisplacement(before, points);
      facts.displacements[k - 1] = way;
      facts.fastest[k - 1] = vertex;
    }
    before = points;
    progress((k + 1) / n);
  }
  return lost ? { ...facts, nonFiniteVertices: lost } : facts;
}

/** Marks the vertices that have a number which is not finite. */
function markNonFinite(points: Float32Array, lost: Uint8Array = new Uint8Array(points.length / 3)): Uint8Array {
  for (let i = 0; i < points.length; i++) if (!Number.isFinite(points[i])) lost[Math.floor(i / 3)] = 1;
  return lost;
}
