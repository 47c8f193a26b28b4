import { radians } from '../../../math/angle.ts';
import { cross, dot, type Vec3 } from '../../../math/vec3.ts';
import { relativeLuminance } from '../../../scene/view/metering.ts';
import type { FloatImage, GBufferReader } from './effectInput.ts';

/**
 * Turns colours about the grey axis and moves them along it, so that their luminance Y stays; then multiplies their
 * distance from the grey of this luminance, but at most until a component is 0.
 */
export const hueShift = ({ image }: GBufferReader, [angle = 0, saturation = 1]: readonly number[]): FloatImage =>
  image.map((x, y) => shifted(image.at(x, y) as unknown as Vec3, radians(angle), saturation));

function shifted(color: Vec3, angle: number, saturation: number): Vec3 {
  const gray = 1 / Math.sqrt(3);
  const axis: Vec3 = [gray, gray, gray];
  const along = gray * dot(axis, color) * (1 - Math.cos(angle));
  const across = cross(axis, color);
  const turned = color.map((c, k) => c * Math.cos(angle) + across[k]! * Math.sin(angle) + along) as unknown as Vec3;
  const [light, lightOfTurned] = [relativeLuminance(...color), relativeLuminance(...turned)];
  const chroma = turned.map((c) => saturation * (c - lightOfTurned));
  const least = Math.min(...chroma);
  const share = light + least < 0 ? Math.max(light, 0) / -least : 1;
  return chroma.map((c) => light + share * c) as unknown as Vec3;
}
