import { sub } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { dopplerFactor } from '../../physics/optics/doppler.ts';
import { aovReader } from '../../reference/aov.ts';
import { cameraRay } from '../../reference/camera/cameraRay.ts';
import { visibleHit } from '../../reference/camera/visibleHit.ts';
import { createTracedScene } from '../../reference/intersection/tracedScene.ts';
import type { Scene } from '../../scene/types.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { VertexProbe } from '../../scene/view/probe.ts';
import { type DataAov, DEFAULT_SETTINGS, type ViewPoint } from '../../scene/view/view.ts';
import { isLuminous, placementIn, type ViewSettings } from '../../scene/views/views.ts';

/** The surface point and emission event that an observer sees at a pixel. */
export interface PixelProbe extends Omit<VertexProbe, 'vertex' | 'visible'> {
  readonly prim: string;
  /** Index in the scene plus one, as in the `object` channel. */
  readonly object: number;
  /** Unit, in the rest frame of the surface; with its normal map. */
  readonly normal: readonly number[];
  /** Linear sRGB of the base colour, with texture and vertex colour. */
  readonly albedo: readonly number[];
  /** The fraction of the sky that is visible there, 0 … 1. */
  readonly occlusion: number;
}

/** A view and, for the one from slice to cone, where it is. */
type ShownView = Pick<ViewSettings, 'view' | 'coneSlope'>;

/**
 * The nearest opaque surface on the ray through a pixel (0, 0: the centre of the first one), as in the data channels of a picture:
 * the ray runs along the past light cone and intersects each triangle where it was at that time.
 */
export function probePixel(
  scene: Scene,
  view: ViewPoint,
  c: number,
  how: ShownView,
  size: PictureSize,
  [x, y]: readonly [number, number],
): PixelProbe | undefined {
  const settings = { ...DEFAULT_SETTINGS, ...how, speedOfLight: c };
  const ray = cameraRay(view, settings, x + 0.5, y + 0.5, size.width, size.height);
  if (!ray) return undefined;
  const traced = createTracedScene(scene, c);
  const hit = visibleHit(traced, ray);
  if (!hit) return undefined;
  const read = (name: DataAov) => aovReader(name, traced, view.u, settings)(hit, ray);
  const { object, time, position, velocity, s: distance } = hit;
  const offset = sub(position, view.position);
  const apparent = placementIn(settings).position(offset, view.u);
  const doppler = isLuminous(settings) ? dopplerFactor(offset, view.u, properVelocity(velocity)) : 1;
  return {
    prim: scene.objects[object].path,
    object: object + 1,
    time,
    position,
    velocity,
    apparent,
    distance,
    doppler,
    normal: read('normal'),
    albedo: read('albedo'),
    occlusion: read('occlusion')[0]!,
  };
}
