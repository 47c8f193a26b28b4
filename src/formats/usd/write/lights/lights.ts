import type { Light, RadianceTexture, Texture } from '../../../../scene/types.ts';
import type { LightSpectrum } from '../../../../spectrum/sources/lightSpectrum.ts';
import type { PrimContent } from '../../layer/specs.ts';
import type { WriteContext } from '../motions.ts';
import { writeDistantLight } from './distantLight.ts';
import { writeDomeLight } from './domeLight.ts';
import type { LightFiles, LightWriter } from './lightWriter.ts';
import { localLightWriter } from './localLight.ts';
import { writeNightSky } from './nightSky.ts';

const LIGHTS: { readonly [K in Light['kind']]: LightWriter<Extract<Light, { readonly kind: K }>> } = {
  sphere: localLightWriter('SphereLight', ({ radius }) => ({ radius })),
  rect: localLightWriter('RectLight', ({ height, width }) => ({ height, width })),
  disk: localLightWriter('DiskLight', ({ radius }) => ({ radius })),
  cylinder: localLightWriter('CylinderLight', ({ length, radius }) => ({ length, radius })),
  distant: writeDistantLight,
  dome: writeDomeLight,
  stars: writeNightSky,
};

export function lightContent(light: Light, placement: WriteContext, files: LightFiles): PrimContent {
  const write = LIGHTS[light.kind] as LightWriter<Light>;
  return write(light, placement, files);
}

/** What of a light is written to files of its own. */
export const pictureOf = (light: Light): Texture | RadianceTexture | undefined =>
  'texture' in light ? light.texture : undefined;
export const spectrumOf = (light: Light): LightSpectrum | undefined =>
  'spectrum' in light ? light.spectrum : undefined;
