import { conjugate, rotate } from '../../math/quat.ts';
import { scale, ZERO } from '../../math/vec3.ts';
import { aberrate } from '../../physics/optics/aberration.ts';
import { observerDoppler } from '../../physics/optics/doppler.ts';
import type { NightSky } from '../types.ts';
import { lensPixel, pixelSolidAngle } from '../view/lenses/lenses.ts';
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
  const size = { width, height };
  const toCamera = conjugate(view.orientation);
  let count = 0;
  for (let i = 0; i < stars.temperatures.length; i++) {
    const n = rotate(orientation, [stars.directions[3 * i], stars.directions[3 * i + 1], stars.directions[3 * i + 2]]);
    const pixel = lensPixel(view.lens, rotate(toCamera, boosted ? aberrate(n, u) : n), size);
    if (!pixel) continue;
    const [x, y] = pixel;
    const outside = (pixels: number) => x < -pixels || x > width + pixels || y < -pixels || y > height + pixels;
    // Most stars are outside, and the radiance is expensive.
    if (outside(MAX_SPREAD_RADIUS)) continue;
    const D = observerDoppler(n, u);
    const solidAngle = pixelSolidAngle(view.lens, x, y, size);
    if (solidAngle === 0) continue;
    const share = (gain * stars.illuminances[i]) / solidAngle;
    const light = scale(starlight(stars.temperatures[i], D, settings), share / (boosted ? D * D : 1));
    const brightest = Math.max(...light) * 2 ** settings.exposure;
    const half = spreadRadius(brightest);
    if (outside(half)) continue;
    out.positions.set([(2 * x) / width - 1, 1 - (2 * y) / height, half], 3 * count);
    out.radiances.set(light, 3 * count++);
  }
  return count;
}
