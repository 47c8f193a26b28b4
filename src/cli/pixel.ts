import { sub, type Vec3 } from '../math/vec3.ts';
import type { Size } from '../nodes/drawing/painter.ts';
import { apparentPosition } from '../physics/apparent.ts';
import { properVelocity } from '../physics/boost.ts';
import { dopplerFactor } from '../physics/doppler.ts';
import { simultaneousPosition } from '../physics/simultaneity.ts';
import { cameraRay } from '../reference/camera.ts';
import { traceable } from '../reference/trace.ts';
import { visibleHit } from '../reference/visible.ts';
import type { VertexProbe } from '../scene/probe.ts';
import type { Scene } from '../scene/types.ts';
import { DEFAULT_SETTINGS, type View, type ViewPoint } from '../scene/view.ts';

/** What an observer sees at a pixel: a point of a surface, at the event where the light left it. */
export interface SeenPoint extends Omit<VertexProbe, 'vertex' | 'visible'> {
  readonly prim: string;
  /** Place in the scene plus one, as in the `object` channel. */
  readonly object: number;
}

/**
 * The nearest opaque surface on the ray through a pixel (0, 0: the centre of the first one), as the data channels of a picture have it:
 * the ray goes into the past, and meets each triangle where that was then.
 */
export function seenAtPixel(
  scene: Scene,
  view: ViewPoint,
  c: number,
  how: View,
  size: Size,
  [x, y]: readonly [number, number],
): SeenPoint | undefined {
  const settings = { ...DEFAULT_SETTINGS, view: how, speedOfLight: c };
  const ray = cameraRay(view, settings, x + 0.5, y + 0.5, size.width, size.height);
  const hit = visibleHit(traceable(scene, c), ray);
  if (!hit) return undefined;
  const { object, time, position, velocity, s: distance } = hit;
  const offset = sub(position, view.position);
  const apparent = APPARENT[how](offset, view.u);
  const doppler = how === 'light-cone' ? dopplerFactor(offset, view.u, properVelocity(velocity)) : 1;
  return {
    prim: scene.objects[object].path,
    object: object + 1,
    time,
    position,
    velocity,
    apparent,
    distance,
    doppler,
  };
}

/** Where an event is in the observer's frame, as each view has it; `offset` from the observer's event, world frame [m]. */
const APPARENT: Record<View, (offset: Vec3, u: Vec3) => Vec3> = {
  'light-cone': apparentPosition,
  simultaneity: simultaneousPosition,
  galilean: (offset) => offset,
};
