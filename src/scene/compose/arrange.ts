import { fromAxisAngle, IDENTITY, type Quat, rotate } from '../../math/quat.ts';
import { scale, type Vec3 } from '../../math/vec3.ts';
import type { Scene, SceneObject } from '../types.ts';
import { transformObject } from './transformScene.ts';

/** Pose of one copy: rotated, then translated [m]. */
export interface InstancePose {
  readonly position: Vec3;
  readonly orientation: Quat;
}

/** Most copies of a scene. */
export const MAX_COPIES = 10_000;

/** Copies of the scene's objects at the given poses, with shared meshes. The first keeps its paths; others are named `/Ball/copy2` and so on, skipping existing paths. */
export function arrangeCopies(scene: Scene, poses: readonly InstancePose[]): Scene {
  const taken = new Set(scene.objects.map(({ path }) => path));
  const latest = new Map<string, number>();
  const copyOf = (path: string): string => {
    let n = latest.get(path) ?? 1;
    do n++;
    while (taken.has(`${path}/copy${n}`));
    latest.set(path, n);
    return `${path}/copy${n}`;
  };
  const objects = poses.flatMap((pose, i) => {
    const wholes = new Map<string, string>();
    return scene.objects.map((object): SceneObject => {
      const copy = transformObject(object, { ...pose, scale: 1 });
      const { path, pieceOf } = object;
      if (i === 0) return copy;
      if (pieceOf === undefined) return { ...copy, path: copyOf(path) };
      const whole = wholes.get(pieceOf) ?? copyOf(pieceOf);
      wholes.set(pieceOf, whole);
      return { ...copy, path: whole + path.slice(pieceOf.length), pieceOf: whole };
    });
  });
  return { ...scene, objects };
}

/** nx × ny × nz positions `step` apart [m], centred on the origin. */
export function gridPoses(counts: readonly [number, number, number], step: Vec3): InstancePose[] {
  const poses: InstancePose[] = [];
  const at = (i: number, axis: number): number => (i - (counts[axis] - 1) / 2) * step[axis];
  for (let i = 0; i < counts[0]; i++)
    for (let j = 0; j < counts[1]; j++)
      for (let k = 0; k < counts[2]; k++)
        poses.push({ position: [at(i, 0), at(j, 1), at(k, 2)], orientation: IDENTITY });
  return poses;
}

/** `count` poses on a circle about a unit axis, each rotated by its angle on the circle. */
export const ringPoses = (count: number, radius: number, axis: Vec3): InstancePose[] =>
  Array.from({ length: count }, (_, k) => {
    const orientation = fromAxisAngle(axis, (2 * Math.PI * k) / count);
    return { position: rotate(orientation, scale(perpendicularTo(axis), radius)), orientation };
  });

/** A unit vector perpendicular to a unit axis, in the plane of that and the X axis, or the Y axis if the axis is near X. */
export function perpendicularTo(axis: Vec3): Vec3 {
  const other: Vec3 = Math.abs(axis[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
  const along = axis[0] * other[0] + axis[1] * other[1] + axis[2] * other[2];
  const v: Vec3 = [other[0] - along * axis[0], other[1] - along * axis[1], other[2] - along * axis[2]];
  return scale(v, 1 / Math.hypot(...v));
}
