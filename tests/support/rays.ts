import { IDENTITY } from '../../src/math/quat.ts';
import { type Vec3, ZERO } from '../../src/math/vec3.ts';
import type { Hit } from '../../src/reference/acceleration/ray.ts';
import { createTracedScene, type TracedScene } from '../../src/reference/intersection/tracedScene.ts';
import { makeScene } from '../../src/scene/defaults.ts';
import { pointsAt } from '../../src/scene/streaming/samplePoints.ts';
import type { Motion, SampledPointsMotion, SceneObject } from '../../src/scene/types.ts';
import { perspective } from '../../src/scene/view/lenses/perspectiveLens.ts';
import { probeVertex, type VertexProbe } from '../../src/scene/view/probe.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../src/scene/view/view.ts';
import type { View } from '../../src/scene/views/views.ts';

export const tracedScene = (objects: readonly SceneObject[], c = 1): TracedScene =>
  createTracedScene(makeScene({ name: 'test', objects }), c);

/** At the origin at t = 0, at rest, looking along −Z, overridden by `given`. */
export const viewFrom = (given: Partial<ViewPoint> = {}): ViewPoint => ({
  t: 0,
  position: ZERO,
  u: ZERO,
  orientation: IDENTITY,
  lens: perspective(Math.PI / 2),
  ...given,
});

export const settingsFor = (view: View, c = 1): RenderSettings => ({ ...DEFAULT_SETTINGS, view, speedOfLight: c });

/** Observes the point with weights (1 − v − w, v, w) of a triangle by the formulas for single points. */
export function probePoint(
  object: SceneObject,
  { corner, v, w }: Pick<Hit, 'corner' | 'v' | 'w'>,
  observer: ViewPoint,
  c: number,
  view: View,
): VertexProbe | undefined {
  const { mesh } = object;
  const [i, j, k] = mesh.indices.subarray(corner, corner + 3);
  // Mesh positions are f32; f64 here avoids rounding the blended point.
  const blend = (p: ArrayLike<number>): Float32Array =>
    Float64Array.from(
      [0, 1, 2],
      (n) => (1 - v - w) * p[3 * i + n] + v * p[3 * j + n] + w * p[3 * k + n],
    ) as unknown as Float32Array;
  const point = {
    ...object,
    mesh: { ...mesh, positions: blend(mesh.positions) },
    motion: blended(object.motion, blend),
  };
  return probeVertex(point, 0, observer, c, view);
}

function blended(motion: Motion, blend: (points: Float32Array) => Float32Array): Motion {
  if (motion.kind !== 'sampled-points') return motion;
  const { velocities } = motion;
  return {
    ...motion,
    points: Array.from(motion.times, (_, k) => blend(pointsAt(motion, k))),
    ...(velocities && { velocities: velocities.map(blend) }),
  } satisfies SampledPointsMotion;
}

/** Vertex k of the triangle whose first corner is `corner`. */
export function cornerAt({ mesh }: SceneObject, corner: number, k: number): Vec3 {
  const i = 3 * mesh.indices[corner + k];
  return [mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]];
}
