import { IDENTITY, transform } from '../../../math/mat3.ts';
import { addScaled, dot, sub, type Vec3 } from '../../../math/vec3.ts';
import { boundingBox } from '../../../scene/bounds/bounds.ts';
import { restingPose } from '../../../scene/motion/motion.ts';
import { applyPose } from '../../../scene/motion/poses.ts';
import type { Body } from '../../geometry/bodies.ts';
import type { AtlasTile, LightAxes, ParallelLayer } from './parallelLayer.ts';

/** The box along a light's axes, in the world, that holds all bodies at rest; the cascades cover it. */
export interface LightSpaceBox {
  readonly axes: LightAxes;
  readonly center: Vec3;
  /** Half of its larger side across the light, and half of its depth along it [m]. */
  readonly halfSide: number;
  readonly depth: number;
}

/** Half side of the smallest cascade [m]: its texels are 1.2 cm in a tile of 2048². */
const MIN_HALF_SIDE = 12;
/** Ratio of the widths of successive cascades. */
const CASCADE_RATIO = 6;
const MAX_CASCADES = 3;
/** A cascade follows the observer in steps of this fraction of its half side. */
const SNAP_STEP = 0.25;

/** Returns undefined if nothing is at rest. */
export function lightSpaceBox(bodies: readonly Body[], axes: LightAxes): LightSpaceBox | undefined {
  const min = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY];
  const max = min.map((x) => -x);
  for (const body of bodies)
    for (const corner of cornersOf(body))
      [axes.right, axes.up, axes.toLight].forEach((axis, k) => {
        const at = dot(axis, corner);
        min[k] = Math.min(min[k], at);
        max[k] = Math.max(max[k], at);
      });
  if (!(min[0] <= max[0])) return undefined;
  const middle = (k: number) => (min[k] + max[k]) / 2;
  const side = (k: number) => Math.max((max[k] - min[k]) / 2, 1e-6);
  const center = [axes.right, axes.up, axes.toLight].reduce<Vec3>(
    (sum, axis, k) => addScaled(sum, axis, middle(k)),
    [0, 0, 0],
  );
  return { axes, center, halfSide: 1.01 * Math.max(side(0), side(1)), depth: 1.01 * side(2) };
}

const boxes = new WeakMap<Float32Array, ReturnType<typeof boundingBox>>();

function cornersOf({ object: { mesh, motion, stretch = IDENTITY } }: Body): readonly Vec3[] {
  const pose = restingPose(motion);
  if (!pose) return [];
  if (!boxes.has(mesh.positions)) boxes.set(mesh.positions, boundingBox(mesh.positions));
  const box = boxes.get(mesh.positions);
  if (!box) return [];
  const ends = [box.min, box.max];
  return [0, 1, 2, 3, 4, 5, 6, 7].map((k) =>
    applyPose(pose, transform(stretch, [ends[k & 1][0], ends[(k >> 1) & 1][1], ends[k >> 2][2]])),
  );
}

/** Half sides of the cascades, smallest first [m]; the last holds the whole box. */
export function cascadeSizes({ halfSide }: LightSpaceBox): readonly number[] {
  const count = Math.max(
    1,
    Math.min(MAX_CASCADES, Math.ceil(Math.log(halfSide / MIN_HALF_SIDE) / Math.log(CASCADE_RATIO)) + 1),
  );
  const ratio = count === MAX_CASCADES ? Math.max(CASCADE_RATIO, Math.sqrt(halfSide / MIN_HALF_SIDE)) : CASCADE_RATIO;
  return Array.from({ length: count }, (_, k) =>
    k === count - 1 ? halfSide : Math.max(MIN_HALF_SIDE * ratio ** k, halfSide / ratio ** (count - 1 - k)),
  );
}

/** Cascades centred on the observer, rounded to steps, but within the box. */
export function cascades(
  box: LightSpaceBox,
  observer: Vec3,
  { tiles, penumbraSlope }: { readonly tiles: readonly AtlasTile[]; readonly penumbraSlope: number },
): readonly ParallelLayer[] {
  const { axes, depth } = box;
  const offset = sub(observer, box.center);
  return cascadeSizes(box).map((half, k) => {
    const maxOffset = Math.max(0, box.halfSide - half);
    const step = SNAP_STEP * half;
    const place = (axis: Vec3) =>
      Math.max(-maxOffset, Math.min(maxOffset, step * Math.round(dot(offset, axis) / step)));
    const center = addScaled(addScaled(box.center, axes.right, place(axes.right)), axes.up, place(axes.up));
    return { axes, beta: [0, 0, 0], center, halfSide: half, halfDepth: depth, penumbraSlope, tile: tiles[k] };
  });
}
