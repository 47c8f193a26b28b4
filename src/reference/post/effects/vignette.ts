import { radians } from '../../../math/angle.ts';
import { farthestCorner } from '../../../scene/view/lenses/perspectiveLens.ts';
import type { FloatImage, GBufferReader } from './effectInput.ts';

/**
 * Darkening by cosⁿ θ of the angle from the axis; n = 4 holds for a thin lens. arg1: strength; arg2: n; arg3: θ of the corners [°], 0: that of the
 * camera. docs/physics.md §8.4.
 */
export function vignette(frame: GBufferReader, [strength = 0, power = 4, corner = 0]: readonly number[]): FloatImage {
  const [across, up] = farthestCorner(frame.frustum);
  const stretch = corner > 0 ? Math.tan(radians(corner)) ** 2 / (across * across + up * up) : 1;
  return frame.image.map((x, y) => {
    const [tx, ty] = frame.tangents(x, y);
    const transmitted = (1 + stretch * (tx * tx + ty * ty)) ** (-power / 2);
    return frame.image.at(x, y).map((value) => value * (1 + strength * (transmitted - 1)));
  });
}
