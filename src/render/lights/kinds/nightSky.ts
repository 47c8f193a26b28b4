import { float } from 'three/tsl';
import { COSMIC_TEMPERATURE, DAYLIGHT_LUMINANCE } from '../../../scene/stars/cosmicBackground.ts';
import type { NightSky } from '../../../scene/types.ts';
import type { RadianceAccumulator } from '../../color/radiance.ts';
import type { FrameUniforms } from '../../gpu/frameUniforms.ts';
import type { LightSet, SkyPixel } from '../lightSet.ts';

/** The cosmic background between the stars of a night sky; the stars are drawn as points (shading/starPoints.ts). */
export class CosmicBackground implements LightSet {
  private readonly sky: NightSky | undefined;

  constructor(sky: NightSky | undefined) {
    this.sky = sky;
  }

  /** Nothing of it depends on the observer. */
  update(): void {}

  /** It is too faint to light anything. */
  addReflected(): void {}

  addBackground(_pixel: SkyPixel, _uniforms: FrameUniforms, accumulator: RadianceAccumulator): void {
    if (this.sky) accumulator.addBlackbody(COSMIC_TEMPERATURE, float(this.sky.gain * DAYLIGHT_LUMINANCE));
  }
}
