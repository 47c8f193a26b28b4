import { clamp, Fn, float, floor, int, log2, max, min, mix, select, uniform, vec3, vec4 } from 'three/tsl';
import type { Texture } from 'three/webgpu';
import type { RenderSettings } from '../scene/view.ts';
import { observerDoppler } from '../shaders/observerDoppler.ts';
import { toneMaps } from '../shaders/toneMap.ts';
import type { Float, Vec3, Vec4 } from '../shaders/types.ts';
import { unaberrate } from '../shaders/unaberrate.ts';
import {
  colorRow,
  type FalseColor,
  type FalseColors,
  isLogarithmic,
  LEAST_SHADE,
  NOTHING,
  stepped,
} from '../spectrum/falseColor.ts';
import { MIDDLE } from '../spectrum/spectralBands.ts';
import { encode } from './display.ts';
import { FloatTable } from './floatTable.ts';
import { pixelDirection, texelHere } from './fullScreen.ts';
import { gridOver } from './grid.ts';
import { luminance } from './luminance.ts';
import { depthHere } from './passes.ts';
import type { GBuffer } from './targets.ts';
import type { Uniforms } from './uniforms.ts';

const STEPS = 256;

/** The colours of one scale on the GPU: what a pixel's number is looked up in. */
export class FalseColorTable {
  private readonly table = new FloatTable(STEPS);
  private readonly start = uniform(0);
  private readonly perStep = uniform(1);
  private made = '';

  use({ kind, ...scale }: FalseColors): void {
    const wanted = JSON.stringify([kind, scale]);
    if (wanted === this.made) return;
    this.made = wanted;
    const [start, end] = [stepped(kind, scale.from), stepped(kind, scale.to)];
    this.start.value = start;
    this.perStep.value = (STEPS - 1) / (end - start);
    for (const [i, [r, g, b]] of colorRow(kind, scale, STEPS).entries())
      this.table.values.set([r / 255, g / 255, b / 255, 1], 4 * i);
    this.table.upload();
  }

  /** Of a number in the scale's steps. */
  color(value: Float): Vec3 {
    const at = clamp(value.sub(this.start).mul(this.perStep), 0, STEPS - 1).toVar();
    const low = min(floor(at), STEPS - 2).toVar();
    return mix(this.table.texel(int(low)).xyz, this.table.texel(int(low.add(1))).xyz, at.sub(low));
  }

  dispose(): void {
    this.table.dispose();
  }
}

/** The picture's numbers as colours, sRGB: each of what is at the pixel's centre, with nothing smoothed between. */
export const falseColored = (
  kind: FalseColor,
  light: Texture,
  buffer: GBuffer,
  uniforms: Uniforms,
  table: FalseColorTable,
  { tone, grid }: Pick<RenderSettings, 'tone' | 'grid'>,
): Vec4 =>
  Fn(() => {
    const there = texelHere(buffer.texture('object')).x.greaterThan(0.5).toVar();
    const value = VALUES[kind]({ light, buffer, uniforms, there });
    const color = table.color(isLogarithmic(kind) ? log2(max(value, 1e-38)) : value).toVar();
    if (kind === 'emission-time') color.assign(select(there, color, vec3(...NOTHING).div(255)));
    if (kind === 'band') {
      const shown = toneMaps[tone](texelHere(light).rgb, uniforms.exposure);
      const grey = encode(vec3(luminance(shown))).x;
      color.mulAssign(mix(float(LEAST_SHADE), float(1), grey));
    }
    if (!grid) return vec4(color, 1);
    const lines = gridOver(pixelDirection(uniforms), depthHere(buffer), uniforms).toVar();
    return vec4(mix(color, encode(lines.xyz), lines.w), 1);
  })();

interface Sources {
  readonly light: Texture;
  readonly buffer: GBuffer;
  readonly uniforms: Uniforms;
  /** Whether a surface is at the pixel. */
  readonly there: ReturnType<Float['greaterThan']>;
}

const VALUES: Readonly<Record<FalseColor, (sources: Sources) => Float>> = {
  doppler: dopplerHere,
  'emission-time': ({ buffer, uniforms }) => texelHere(buffer.texture('event')).w.mul(uniforms.secondsPerMetre),
  radiance: ({ light }) => luminance(texelHere(light).rgb),
  band: (sources) => dopplerHere(sources).mul(MIDDLE),
};

/** D of the surface; of the sky, which rests in the world, where there is none. */
function dopplerHere({ buffer, uniforms, there }: Sources): Float {
  return select(there, texelHere(buffer.texture('motion')).w, skyDoppler(uniforms));
}

export function skyDoppler(uniforms: Uniforms): Float {
  const { u, gamma, boosted, boostLight } = uniforms;
  const nPrime = pixelDirection(uniforms).toVar();
  const n = mix(nPrime, unaberrate(nPrime, u, gamma), boosted).normalize();
  return mix(float(1), observerDoppler(n, u, gamma), boostLight);
}
