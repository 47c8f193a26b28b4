import { transformPoint } from '../../../../math/mat4.ts';
import { type BoundingBox, boundingBox } from '../../../../scene/bounds/bounds.ts';
import { numbersAt, textAt } from '../../layer/attributes.ts';
import type { NumberArray, PrimSpec } from '../../layer/layer.ts';
import { isActive } from '../../layer/query.ts';
import type { StageContext } from '../context.ts';
import { gprimMesh, isGprim } from '../geometry/gprims.ts';
import { childTransform, ROOT_TRANSFORM, type StageTransform } from '../transforms/stageTransform.ts';
import { transformOf } from '../transforms/xformOps.ts';

/** Of the purposes in `extentsHint`, in its order, those that count: default, render and proxy, but not guide. */
const HINTED_PURPOSES = 3;

/**
 * The box of a model in its own axes at the stage's start [stage units], of what its `extentsHint` says, else of the authored extents, points and sizes below it, as
 * UsdGeomBBoxCache::ComputeUntransformedBound; undefined if there are none.
 */
export function modelBox(context: StageContext, prim: PrimSpec): BoundingBox | undefined {
  return boundingBox([...corners(context, prim, ROOT_TRANSFORM, 'default')]);
}

/** Coordinates of opposite corners of all boxes below a prim, in the model's axes. */
function* corners(context: StageContext, prim: PrimSpec, frame: StageTransform, purpose: string): Generator<number> {
  const points = ownPoints(context, prim, purpose);
  if (points) {
    const matrix = frame.matrixAt(context.startCode);
    const placed = Float64Array.from(points);
    for (let i = 0; i + 2 < placed.length; i += 3)
      placed.set(transformPoint(matrix, [placed[i], placed[i + 1], placed[i + 2]]), i);
    const box = boundingBox(placed);
    if (box) yield* [...box.min, ...box.max];
    // What has a size of its own stands for all below it.
    return;
  }
  for (const child of prim.children.values()) {
    if (child.specifier !== 'def' || !isActive(child)) continue;
    if (textAt(child, 'visibility', context.startCode) === 'invisible') continue;
    const within = childTransform(frame, transformOf(child, context.cubic).ops);
    yield* corners(context, child, within, textAt(child, 'purpose', undefined) ?? purpose);
  }
}

/** Points whose box is that of a prim: corners of a written box, or the points themselves. */
function ownPoints(context: StageContext, prim: PrimSpec, purpose: string): ArrayLike<number> | undefined {
  if (purpose === 'guide') return undefined;
  const hint = numbersAt(prim, 'extentsHint', context.startCode);
  if (hint) return hintedCorners(hint);
  const extent = numbersAt(prim, 'extent', context.startCode);
  if (extent?.length === 6) return cornersOf(extent, 0);
  if (isGprim(prim.typeName)) return gprimMesh(context, prim).positions;
  return numbersAt(prim, 'points', context.startCode);
}

function hintedCorners(hint: NumberArray): number[] {
  const boxes = Math.min(HINTED_PURPOSES, Math.floor(hint.length / 6));
  return Array.from({ length: boxes }, (_, k) => cornersOf(hint, 6 * k)).flat();
}

/** The corners of a box, least coordinates first; none of an empty one, whose least are above the greatest. */
function cornersOf(numbers: NumberArray, at: number): number[] {
  const side = (greatest: number, k: number): number => numbers[at + 3 * greatest + k];
  if ([0, 1, 2].some((k) => side(0, k) > side(1, k))) return [];
  return Array.from({ length: 8 }, (_, i) => [0, 1, 2].map((k) => side((i >> k) & 1, k))).flat();
}
