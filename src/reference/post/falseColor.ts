import { ZERO } from '../../math/vec3.ts';
import { dopplerFactor } from '../../physics/optics/doppler.ts';
import { relativeLuminance } from '../../scene/view/metering.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import { type PictureViews, viewPixelAt } from '../../scene/view/pictureViews.ts';
import type { AovName, RenderSettings } from '../../scene/view/view.ts';
import { isLuminous } from '../../scene/views/views.ts';
import { encodeSrgb } from '../../spectrum/display/srgb.ts';
import { toneMap } from '../../spectrum/display/toneMap.ts';
import {
  type FalseColorQuantity,
  type FalseColorScale,
  falseColor,
  shadeFactor,
} from '../../spectrum/falseColor/falseColor.ts';
import { emittedWavelength } from '../../spectrum/falseColor/spectralBands.ts';
import { directionAt, rayToward } from '../camera/lensRay.ts';
import type { PixelCanvas } from '../figures/pixelCanvas.ts';

/** The AOVs required by each false-colour quantity. */
export const AOVS_OF_FALSE_COLOR: Readonly<Record<FalseColorQuantity, readonly AovName[]>> = {
  doppler: ['object', 'doppler'],
  'emission-time': ['object', 'emission_time'],
  radiance: ['beauty'],
  band: ['object', 'doppler', 'beauty'],
};

/** A picture's AOVs, views and settings. */
export interface FalseColorInput {
  readonly aovs: ReadonlyMap<AovName, Float32Array>;
  readonly views: PictureViews;
  readonly settings: RenderSettings;
  readonly width: number;
  readonly height: number;
}

/** The quantity per pixel; NaN where it is undefined. The sky, at rest in the world, has a D and a band. */
export function falseColorValues(kind: FalseColorQuantity, source: FalseColorInput): Float32Array {
  const { width, height } = source;
  const aov = (name: AovName) => source.aovs.get(name)!;
  const pixels = width * height;
  switch (kind) {
    case 'doppler':
      return Float32Array.from({ length: pixels }, (_, i) =>
        aov('object')[i] ? aov('doppler')[i]! : skyAt(source, i),
      );
    case 'band':
      return falseColorValues('doppler', source).map(emittedWavelength);
    case 'emission-time':
      return Float32Array.from({ length: pixels }, (_, i) =>
        aov('object')[i] ? aov('emission_time')[i]! - timeAt(source, i) : Number.NaN,
      );
    case 'radiance':
      return Float32Array.from({ length: pixels }, (_, i) => relativeLuminance(...rgbOf(aov('beauty'), i)));
  }
}

const skyAt = ({ views, settings, width, height }: FalseColorInput, i: number): number =>
  skyDoppler(views, { width, height }, settings, (i % width) + 0.5, Math.floor(i / width) + 0.5);

/** World time of a pixel's observer [s]; NaN outside of all views. */
const timeAt = ({ views, width, height }: FalseColorInput, i: number): number =>
  viewPixelAt(views, { width, height }, i % width, Math.floor(i / width))?.view.t ?? Number.NaN;

/**
 * D of light from objects at rest in the world, at the point (x, y) of a picture [px, from the top left]; 1 in views without light, NaN outside of
 * all views and where a lens shows nothing.
 */
export function skyDoppler(
  views: PictureViews,
  size: PictureSize,
  settings: RenderSettings,
  x: number,
  y: number,
): number {
  if (!isLuminous(settings)) return 1;
  const found = viewPixelAt(views, size, x, y);
  if (!found) return Number.NaN;
  const { view, width, height } = found;
  const n = directionAt(view, found.x, found.y, width, height);
  return n ? dopplerFactor(rayToward(view, settings, n).dx, view.u, ZERO) : Number.NaN;
}

/** The false-colour picture: RGBA, sRGB, opaque. */
export function falseColorPicture(colors: FalseColorScale, values: Float32Array, source: FalseColorInput): PixelCanvas {
  const { width, height } = source;
  const pixels = new Uint8Array(4 * width * height);
  for (let i = 0; i < width * height; i++) {
    const shade = colors.kind === 'band' ? shadeOf(source, i) : 1;
    const [r, g, b] = falseColor(colors, values[i]!);
    pixels.set([Math.round(r * shade), Math.round(g * shade), Math.round(b * shade), 255], 4 * i);
  }
  return { width, height, pixels };
}

/** Shade factor of band colours, by the displayed grey of the picture. */
function shadeOf({ aovs, settings }: FalseColorInput, i: number): number {
  const shown = toneMap(rgbOf(aovs.get('beauty')!, i), settings.exposure, settings.tone);
  return shadeFactor(encodeSrgb(relativeLuminance(...shown)));
}

const rgbOf = (image: Float32Array, i: number): [number, number, number] => [
  image[3 * i]!,
  image[3 * i + 1]!,
  image[3 * i + 2]!,
];
