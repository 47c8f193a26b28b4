import { clamp, max, min } from 'three/tsl';
import { FloatType, HalfFloatType, type TextureDataType } from 'three/webgpu';
import type { Vec3 } from '../../shaders/types.ts';
import type { Gpu } from './device.ts';

/** The largest stored light, 14 decades above sunlit snow at γ = 1000. Its square is still a 32-bit float. */
const MAX_LIGHT = 1e18;
/** The same where targets hold halves. Half of the largest half, so that another such light can be added. */
const MAX_HALF_LIGHT = 32_752;

/** How targets of linear light store it. */
export interface LightRange {
  readonly type: TextureDataType;
  /** The largest channel. */
  readonly max: number;
}

/** Of images that nothing is blended into. */
export const IMAGE_RANGE: LightRange = { type: FloatType, max: MAX_LIGHT };

/** Of the light of a G-buffer, into which stars and transparent objects are blended: halves where a device cannot blend 32-bit floats. */
export const blendedRange = ({ floatBlending }: Pick<Gpu, 'floatBlending'>): LightRange =>
  floatBlending ? IMAGE_RANGE : { type: HalfFloatType, max: MAX_HALF_LIGHT };

/** Light with no channel above `most`: it is dimmed as a whole, so that it keeps its hue. Infinite channels count as the largest 32-bit numbers. */
export function limitLight(light: Vec3, most: number): Vec3 {
  const finite = clamp(light, -MAX_FLOAT, MAX_FLOAT).toVar();
  const peak = max(finite.x, max(finite.y, finite.z));
  return finite.mul(min(max(peak, most).reciprocal().mul(most), 1));
}

const MAX_FLOAT = 1e37;
