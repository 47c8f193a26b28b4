import { length, sub, type Vec3 } from '../../math/vec3.ts';
import type { BoundingBox } from '../../scene/bounds/bounds.ts';
import { sceneBounds } from '../../scene/bounds/sceneBounds.ts';
import { isStatic } from '../../scene/motion/motion.ts';
import type { Scene } from '../../scene/types.ts';

/** How far beyond the scene one is outside it: a part of its diagonal, … */
const MARGIN = 0.1;
/** … or where its start is outside, this many times as far as that. */
const MARGIN_OF_START = 2;

/** Where a scene ends: the box of what is at rest, or of all if nothing is, and how far outside it is too far [m]. */
export interface SceneLimits {
  readonly box: BoundingBox;
  readonly margin: number;
}

/** Undefined for scenes without objects. `start`: where the observer begins [m]; c [m/s]. */
export function sceneLimits(scene: Scene, start: Vec3, c: number): SceneLimits | undefined {
  const objects = scene.objects.filter(({ motion }) => isStatic(motion));
  const box = sceneBounds(objects.length > 0 ? { ...scene, objects } : scene, scene.startTime, c);
  if (!box) return undefined;
  return { box, margin: Math.max(MARGIN * length(sub(box.max, box.min)), MARGIN_OF_START * distanceTo(box, start)) };
}

/** Whether a place [m] is so far from the scene that hardly anything of it is ahead. */
export const isOutside = ({ box, margin }: SceneLimits, position: Vec3): boolean => distanceTo(box, position) > margin;

/** From a place to the nearest point of a box [m]; 0 within. */
export const distanceTo = ({ min, max }: BoundingBox, position: Vec3): number =>
  Math.hypot(...position.map((x, k) => Math.max(min[k] - x, 0, x - max[k])));
