import { normalize } from '../../../math/vec3.ts';
import type { LensModel } from './lensModel.ts';
import { frustumOf, type PerspectiveLens, pixelsPerTangent } from './perspectiveLens.ts';

/** n ∝ (x tanX + cx, y tanY + cy, −1). A pixel has the solid angle A cos³θ, A its area at distance 1 and θ the angle from the forward axis. */
export const perspectiveModel: LensModel<PerspectiveLens> = {
  directionAt(lens, [x, y], { width, height }) {
    const { tanX, tanY, center } = frustumOf(lens, width, height);
    return normalize([x * tanX + center[0], y * tanY + center[1], -1]);
  },
  placeOf(lens, [right, up, back], { width, height }) {
    if (back >= 0) return undefined;
    const { tanX, tanY, center } = frustumOf(lens, width, height);
    return [(right / -back - center[0]) / tanX, (up / -back - center[1]) / tanY];
  },
  pixelSolidAngle(lens, [x, y], { width, height }) {
    const { tanX, tanY, center } = frustumOf(lens, width, height);
    const [right, up] = [x * tanX + center[0], y * tanY + center[1]];
    return ((4 * tanX * tanY) / (width * height)) * (1 + right * right + up * up) ** -1.5;
  },
  pixelsPerRadian: (lens, { width, height }) => pixelsPerTangent(frustumOf(lens, width, height), width, height),
};
