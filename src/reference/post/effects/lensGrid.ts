import { radians } from '../../../math/angle.ts';
import { saturate } from '../../../math/saturate.ts';
import { lerp, type Vec3 } from '../../../math/vec3.ts';
import { LENS_GRID } from '../../../scene/frameGraph/effects.ts';
import type { FloatImage, GBufferReader } from './effectInput.ts';

/** Height above the horizon and bearing from the direction ahead, to the right [rad]. */
type Angles = readonly [height: number, bearing: number];

/** Half the step of differences [px]. */
const STEP = 1e-3;

/**
 * Lines of equal height and bearing, about the axis of a fisheye (the zenith of a dome) or the camera's upper side. arg1: their distance [°]; arg2: the part of the
 * picture inside the border, of the radius of a fisheye; arg3: opacity; arg4: width [px]. A line is a band of that width, by |angle to it|/|gradient of the angle|.
 */
export function lensGrid(
  frame: GBufferReader,
  [spacing = 15, safe = 0, opacity = 1, width = 1]: readonly number[],
): FloatImage {
  const every = radians(spacing);
  return frame.image.map((x, y) => {
    const here = frame.image.at(x, y);
    const angles = anglesAt(frame, x, y);
    if (!angles) return here;
    const border = safe > 0 ? bandAt(Math.abs(frame.beyondPart(safe, x, y)), width) : 0;
    const lines = angles.map((angle, k) => {
      const gradient = gradientAt(frame, x, y, k as 0 | 1);
      const index = Math.round(angle / every);
      const apart = every / gradient;
      const [least, full] = LENS_GRID.gap;
      const shown = saturate((apart - least) / (full - least));
      return shown * bandAt(Math.abs(angle - index * every) / gradient, index === 0 ? 2 * width : width);
    });
    const lined = lerp(here as unknown as Vec3, LENS_GRID.line, opacity * Math.max(...lines));
    return lerp(lined, LENS_GRID.border, opacity * border);
  });
}

/** The part of a pixel that a band covers, whose middle is so far away [px]. */
const bandAt = (distance: number, width: number): number => saturate(width / 2 + 0.5 - distance);

function anglesAt(frame: GBufferReader, x: number, y: number): Angles | undefined {
  const direction = frame.gridDirection(x, y);
  if (!direction) return undefined;
  const [right, up, back] = direction;
  return [Math.atan2(up, Math.hypot(right, back)), Math.atan2(right, -back)];
}

/** How much one of the angles changes over a pixel [rad]. */
function gradientAt(frame: GBufferReader, x: number, y: number, k: 0 | 1): number {
  const along = (dx: number, dy: number): number => {
    const [before, after] = [-STEP, STEP].map((side) => anglesAt(frame, x + dx * side, y + dy * side)?.[k]);
    const middle = anglesAt(frame, x, y)![k];
    // At the rim of a fisheye one of them may be missing.
    const change = (after ?? middle) - (before ?? middle);
    const steps = (after === undefined ? 0 : 1) + (before === undefined ? 0 : 1);
    return steps === 0 ? 0 : (2 * Math.asin(Math.sin(change / 2))) / (steps * STEP);
  };
  return Math.max(1e-12, Math.hypot(along(1, 0), along(0, 1)));
}
