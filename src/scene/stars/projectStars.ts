import { conjugate, rotate } from '../../math/quat.ts';
import { scale, ZERO } from '../../math/vec3.ts';
import { aberrate } from '../../physics/optics/aberration.ts';
import { observerDoppler } from '../../physics/optics/doppler.ts';
import type { NightSky } from '../types.ts';
import { frustumOf } from '../view/lens.ts';
import type { RenderSettings, ViewPoint } from '../view/view.ts';
import { isLuminous, VIEWS } from '../views/views.ts';
import { MAX_SPREAD_RADIUS, spreadRadius } from './pointSpread.ts';
import { starlight } from './starlight.ts';

/** Buffers for all stars of a sky, 3 numbers each. */
export interface ProjectedStars {
  /** Position in the picture (NDC: −1 … 1, right and up), and half the side of the star's square [px]. */
  readonly positions: Float32Array;
  /** Linear sRGB radiance of a pixel that receives all of its light. */
  readonly radiances: Float32Array;
}

/** Projects the stars into a picture, brightest first as in the sky; returns how many are visible. Frames: equatorial → world → observer → camera. */
export function projectStars(
  { stars, orientation, gain }: NightSky,
  view: ViewPoint,
  settings: RenderSettings,
  width: number,
  height: number,
  out: ProjectedStars,
): number {
  const boosted = VIEWS[settings.view].placement(settings) === 'apparent';
  const u = isLuminous(settings) ? view.u : ZERO;
  const { tanX, tanY, center } = frustumOf(view.lens, width, height);
  const pixel = (4 * tanX * tanY) / (width * height);
  const toCamera = conjugate(view.orientation);
  let count = 0;
  for (let i = 0; i < stars.temperatures.length; i++) {
    const n = rotate(orientation, [stars.directions[3 * i], stars.directions[3 * i + 1], stars.directions[3 * i + 2]]);
    const [x, y, z] = rotate(toCamera, boosted ? aberrate(n, u) : n);
    if (z >= 0) continue;
    const place = [x / (-z * tanX) - center[0] / tanX, y / (-z * tanY) - center[1] / tanY];
    const outside = (pixels: number) =>
      Math.abs(place[0]) > 1 + (2 * pixels) / width || Math.abs(place[1]) > 1 + (2 * pixels) / height;
    // Most stars are outside, and the radiance is expensive.
    if (outside(MAX_SPREAD_RADIUS)) continue;
    const D = observerDoppler(n, u);
    // Solid angle of a pixel falls with cos³ of the angle from the view direction.
    const share = (gain * stars.illuminances[i]) / (pixel * (-z) ** 3);
    const light = scale(starlight(stars.temperatures[i], D, settings), share / (boosted ? D * D : 1));
    const brightest = Math.max(...light) * 2 ** settings.exposure;
    const half = spreadRadius(brightest);
    if (outside(half)) continue;
    out.positions.set([...place, half], 3 * count);
    out.radiances.set(light, 3 * count++);
  }
  return count;
}
