import { addScaled, dot, sub, type Vec3 } from '../../math/vec3.ts';
import { boundingBox } from '../../scene/bounds.ts';
import { placed } from '../../scene/motion.ts';
import type { Body } from '../bodies.ts';
import type { Layer, LightAxes, Tile } from './layer.ts';

/** What a sun's maps of all that rests have to hold: a box along the light's axes, in the world. */
export interface LitBox {
  readonly axes: LightAxes;
  readonly centre: Vec3;
  /** Half of its greater side across the light, and along it [m]. */
  readonly half: number;
  readonly depth: number;
}

/** A map of 2048² has texels of 1.2 cm in it [m]. */
const NEAREST = 12;
/** Each cascade is so much wider than the one before. */
const WIDER = 6;
const MOST = 3;
/** A cascade follows the observer in steps of this part of its half side. */
const STEP = 0.25;

/** undefined where nothing rests. */
export function litBox(bodies: readonly Body[], axes: LightAxes): LitBox | undefined {
  const min = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY];
  const max = min.map((x) => -x);
  for (const body of bodies)
    for (const corner of cornersOf(body))
      [axes.across, axes.up, axes.towards].forEach((axis, k) => {
        const at = dot(axis, corner);
        min[k] = Math.min(min[k], at);
        max[k] = Math.max(max[k], at);
      });
  if (!(min[0] <= max[0])) return undefined;
  const middle = (k: number) => (min[k] + max[k]) / 2;
  const side = (k: number) => Math.max((max[k] - min[k]) / 2, 1e-6);
  const centre = [axes.across, axes.up, axes.towards].reduce<Vec3>(
    (sum, axis, k) => addScaled(sum, axis, middle(k)),
    [0, 0, 0],
  );
  return { axes, centre, half: 1.01 * Math.max(side(0), side(1)), depth: 1.01 * side(2) };
}

const boxes = new WeakMap<Float32Array, ReturnType<typeof boundingBox>>();

function cornersOf({ object: { mesh, motion } }: Body): readonly Vec3[] {
  if (motion.kind !== 'static') return [];
  if (!boxes.has(mesh.positions)) boxes.set(mesh.positions, boundingBox(mesh.positions));
  const box = boxes.get(mesh.positions);
  if (!box) return [];
  const ends = [box.min, box.max];
  return [0, 1, 2, 3, 4, 5, 6, 7].map((k) =>
    placed(motion.pose, [ends[k & 1][0], ends[(k >> 1) & 1][1], ends[k >> 2][2]]),
  );
}

/** Half sides of the cascades, the least first [m]; the last holds the whole box. */
export function cascadeSizes({ half }: LitBox): readonly number[] {
  const count = Math.max(1, Math.min(MOST, Math.ceil(Math.log(half / NEAREST) / Math.log(WIDER)) + 1));
  const ratio = count === MOST ? Math.max(WIDER, Math.sqrt(half / NEAREST)) : WIDER;
  return Array.from({ length: count }, (_, k) =>
    k === count - 1 ? half : Math.max(NEAREST * ratio ** k, half / ratio ** (count - 1 - k)),
  );
}

/** Cascades round the observer, in steps, but not beyond the box. */
export function cascades(
  box: LitBox,
  observer: Vec3,
  { tiles, spread }: { readonly tiles: readonly Tile[]; readonly spread: number },
): readonly Layer[] {
  const { axes, depth } = box;
  const off = sub(observer, box.centre);
  return cascadeSizes(box).map((half, k) => {
    const reach = Math.max(0, box.half - half);
    const step = STEP * half;
    const place = (axis: Vec3) => Math.max(-reach, Math.min(reach, step * Math.round(dot(off, axis) / step)));
    const centre = addScaled(addScaled(box.centre, axes.across, place(axes.across)), axes.up, place(axes.up));
    return { axes, beta: [0, 0, 0], centre, half, depth, spread, tile: tiles[k] };
  });
}
