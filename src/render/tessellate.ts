import type { Vec3 } from '../math/vec3.ts';
import { boundingBox } from '../scene/bounds.ts';
import { restToWorld } from '../scene/resample.ts';
import { objectEdges, subdivideObject, trianglesWhenCut } from '../scene/subdivide.ts';
import type { Scene, SceneObject } from '../scene/types.ts';
import { type Body, makeBody } from './bodies.ts';

/** Edges longer than this share of the scene's diameter are cut, or only longer ones where that would add more triangles than this. */
const LONGEST_EDGE = 1 / 300;
/** Of a deforming object every vertex costs memory for every sample. */
const LONGEST_DEFORMING_EDGE = 1 / 100;
const ADDED_TRIANGLES = 120_000;

export interface Tessellated {
  /** As they are drawn, in the scene's order. */
  readonly objects: readonly SceneObject[];
  /** Half the diagonal of the scene [m]. */
  readonly radius: number;
}

/** The scene's objects with long edges cut, and what is sampled in its rest frame brought into the world. c [m/s]. */
export function tessellate(scene: Scene, c: number): Tessellated {
  const inWorld = scene.objects.map((o) => (isSampledAtRest(o) ? restToWorld(o, c) : o));
  const radius = sceneRadius(inWorld.map((object, i) => makeBody(object, i + 1)));
  return { objects: cutLongEdges(inWorld, radius), radius };
}

/** Its samples in the world depend on the speed of light. */
export const isSampledAtRest = ({ motion, authoredIn }: SceneObject): boolean =>
  authoredIn === 'rest' && (motion.kind === 'sampled' || motion.kind === 'sampled-points');

/** Half the diagonal of the box of all objects where they are at time 0, or at their first sample. */
function sceneRadius(bodies: readonly Body[]): number {
  const corners: number[] = [];
  for (const { line, radius } of bodies) {
    const at: Vec3 =
      line.kind === 'polyline' ? [line.positions[0], line.positions[1], line.positions[2]] : startOf(line);
    for (const side of [-radius, radius]) corners.push(at[0] + side, at[1] + side, at[2] + side);
  }
  const box = boundingBox(corners);
  return box ? Math.hypot(box.max[0] - box.min[0], box.max[1] - box.min[1], box.max[2] - box.min[2]) / 2 : 1;
}

const startOf = (line: Body['line']): Vec3 => ('position' in line ? line.position : [0, 0, 0]);

/** One length for all objects of a kind, so that edges which two of them share are cut alike. */
function cutLongEdges(objects: readonly SceneObject[], radius: number): readonly SceneObject[] {
  const edges = objects.map(objectEdges);
  const least = objects.map(({ motion }) =>
    Math.max(2 * radius * (motion.kind === 'sampled-points' ? LONGEST_DEFORMING_EDGE : LONGEST_EDGE), 1e-9),
  );
  const count = (k: number) => edges.reduce((n, lengths, i) => n + trianglesWhenCut(lengths, k * least[i]), 0);
  const budget = count(Infinity) + ADDED_TRIANGLES;
  let k = 1;
  while (count(k) > budget) k *= 1.15;
  return objects.map((object, i) => subdivideObject(object, k * least[i], budget).result);
}
