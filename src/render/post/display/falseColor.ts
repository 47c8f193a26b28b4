import { clamp, Fn, float, floor, int, log2, max, min, mix, select, uniform, vec3, vec4 } from 'three/tsl';
import type { Texture } from 'three/webgpu';
import { toneMaps } from '../../../shaders/color/toneMap.ts';
import type { Float, Vec3, Vec4 } from '../../../shaders/types.ts';
import {
  colorRamp,
  type FalseColorQuantity,
  type FalseColorScale,
  isLogarithmic,
  MIN_SHADE,
  NO_VALUE_COLOR,
  toScaleUnits,
} from '../../../spectrum/falseColor/falseColor.ts';
import { REFERENCE_WAVELENGTH } from '../../../spectrum/falseColor/spectralBands.ts';
import { relativeLuminance } from '../../color/luminance.ts';
import type { GBuffer } from '../../gbuffer/gbuffer.ts';
import { FloatTable } from '../../gpu/floatTable.ts';
import type { FrameUniforms } from '../../gpu/frameUniforms.ts';
import { texelHere } from '../../gpu/fullScreenPass.ts';
import { pixelDirection, shownHere } from '../../lenses/pixelDirection.ts';
import { depthHere } from '../../shading/passes.ts';
import { type DisplaySettings, encodeSrgb } from './display.ts';
import { gridOver } from './grid.ts';
import { skyDoppler } from './skyDoppler.ts';

const STEPS = 256;

/** The colours of one scale on the GPU, looked up by a pixel's value. */
export class FalseColorTable {
  private readonly table = new FloatTable(STEPS);
  private readonly start = uniform(0);
  private readonly perStep = uniform(1);
  private usedKey = '';

  use({ kind, ...scale }: FalseColorScale): void {
    const key = JSON.stringify([kind, scale]);
    if (key === this.usedKey) return;
    this.usedKey = key;
    const [start, end] = [toScaleUnits(kind, scale.from), toScaleUnits(kind, scale.to)];
    this.start.value = start;
    this.perStep.value = (STEPS - 1) / (end - start);
    for (const [i, [r, g, b]] of colorRamp(kind, scale, STEPS).entries())
      this.table.values.set([r / 255, g / 255, b / 255, 1], 4 * i);
    this.table.upload();
  }

  /** The colour of a value in the scale's units. */
  color(value: Float): Vec3 {
    const position = clamp(value.sub(this.start).mul(this.perStep), 0, STEPS - 1).toVar();
    const low = min(floor(position), STEPS - 2).toVar();
    return mix(this.table.texel(int(low)).xyz, this.table.texel(int(low.add(1))).xyz, position.sub(low));
  }

  dispose(): void {
    this.table.dispose();
  }
}

/** The picture's values as sRGB colours: each of what is at the pixel's centre, without smoothing between pixels. */
export const falseColored = (
  kind: FalseColorQuantity,
  light: Texture,
  buffer: GBuffer,
  uniforms: FrameUniforms,
  table: FalseColorTable,
  { tone, grid, overlay }: Pick<DisplaySettings, 'tone' | 'grid' | 'overlay'>,
): Vec4 =>
  Fn(() => {
    const hasSurface = texelHere(buffer.texture('object')).x.greaterThan(0.5).toVar();
    const value = VALUES[kind]({ light, buffer, uniforms, hasSurface });
    const color = table.color(isLogarithmic(kind) ? log2(max(value, 1e-38)) : value).toVar();
    if (kind === 'emission-time') color.assign(select(hasSurface, color, vec3(...NO_VALUE_COLOR).div(255)));
    if (kind === 'band') {
      const toneMapped = toneMaps[tone](texelHere(light).rgb, uniforms.exposure);
      const gray = encodeSrgb(vec3(relativeLuminance(toneMapped))).x;
      color.mulAssign(mix(float(MIN_SHADE), float(1), gray));
    }
    for (const layer of overlay?.contours() ?? []) color.assign(mix(color, encodeSrgb(layer.xyz), layer.w));
    if (grid) {
      const lines = gridOver(pixelDirection(uniforms), depthHere(buffer), uniforms).toVar();
      color.assign(mix(color, encodeSrgb(lines.xyz), lines.w));
    }
    return vec4(color.mul(shownHere(uniforms)), 1);
  })();

interface FalseColorInputs {
  readonly light: Texture;
  readonly buffer: GBuffer;
  readonly uniforms: FrameUniforms;
  /** Whether there is a surface at the pixel. */
  readonly hasSurface: ReturnType<Float['greaterThan']>;
}

const VALUES: Readonly<Record<FalseColorQuantity, (sources: FalseColorInputs) => Float>> = {
  doppler: dopplerHere,
  'emission-time': ({ buffer, uniforms }) => texelHere(buffer.texture('event')).w.mul(uniforms.secondsPerMetre),
  radiance: ({ light }) => relativeLuminance(texelHere(light).rgb),
  band: (sources) => dopplerHere(sources).mul(REFERENCE_WAVELENGTH),
};

/** D of the surface; without one D of the sky, which is at rest in the world. */
function dopplerHere({ buffer, uniforms, hasSurface }: FalseColorInputs): Float {
  return select(hasSurface, texelHere(buffer.texture('motion')).w, skyDoppler(uniforms));
}
