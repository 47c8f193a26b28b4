import { select, vec4 } from 'three/tsl';
import { type Bands, bandsOf, WHITE } from '../../spectrum/bands.ts';
import { DAYLIGHT } from '../../spectrum/lightSpectrum.ts';
import { seenColor } from '../../spectrum/observerColor.ts';
import { logLuminance } from '../../spectrum/planck.ts';
import { thermalTable } from '../../spectrum/thermalTable.ts';
import { filteredColor, luminanceOf, type SpectrumTable, thermalColors } from '../spectrumTable.ts';
import { spectrumTexture } from '../spectrumTexture.ts';
import { always, within } from './checks.ts';
import { draw, logUniform, vec3At } from './domain.ts';
import type { Twin } from './twin.ts';

const kept = new Map<3 | 4, SpectrumTable>();
function table(layers: 3 | 4): SpectrumTable {
  const made = kept.get(layers) ?? spectrumTexture(thermalTable(layers));
  kept.set(layers, made);
  return made;
}

/** (r, g, b, uv) · (T of the source, D_in, D_out, ir) · (Y(T)/Y(6504 K) of the source, 0, 0, 0) */
function texelsOf(bands: Bands, T: number, Din: number, Dout: number): readonly number[] {
  const luminance = Math.exp(logLuminance(T) - logLuminance(DAYLIGHT.temperature));
  return [...bands.rgb, bands.uv, T, Din, Dout, bands.ir, luminance, 0, 0, 0];
}

const bandsAt = (input: readonly number[]): Bands => ({ rgb: vec3At(input, 0), uv: input[3], ir: input[7] });
const whiteAt = ([, , , , temperature, Din, Dout]: readonly number[]) =>
  seenColor(WHITE, WHITE, { kind: 'thermal', temperature }, Din, Dout);

/** Against sums over every nanometre: the table's error is in it. `own`: filters tell of their ultraviolet and infrared. */
const thermal = (own: boolean): Twin => ({
  name: own ? 'thermalColors, four layers' : 'thermalColors',
  parts: ['thermalColors', 'filteredColor', 'luminanceOf', 'spectrumTexture'],
  texels: 3,
  outputs: 1,
  cases: (random) => {
    const filter = (): Bands => {
      const rgb = [random(), random(), random()] as const;
      return own ? bandsOf(rgb, random(), random()) : bandsOf(rgb);
    };
    return [
      ...draw([{ name: 'D 1/8 … 8, daylight', gamma: 1 }], 300, () => {
        const [D, Dout] = [logUniform(random, 1 / 8, 8), logUniform(random, 1 / 8, 8)];
        return texelsOf(filter(), DAYLIGHT.temperature, D / Dout, Dout);
      }),
      ...draw([{ name: 'D near 1, T 2000 … 20,000 K', gamma: 1 }], 300, () => {
        const shift = () => logUniform(random, 0.7, 1.4);
        return texelsOf(filter(), logUniform(random, 2000, 20_000), shift(), shift());
      }),
      ...draw([{ name: 'D = 1', gamma: 1 }], 30, () => texelsOf(filter(), DAYLIGHT.temperature, 1, 1)),
    ];
  },
  cpu: (input) => {
    const [T, Din, Dout] = input.slice(4);
    return [...seenColor(bandsAt(input), WHITE, { kind: 'thermal', temperature: T }, Din, Dout), 0];
  },
  gpu: (texel) => {
    const [band, light, source] = [texel(0), texel(1), texel(2)];
    const D = light.y.mul(light.z).toVar();
    const T = light.x.mul(D).toVar();
    const colors = thermalColors(table(own ? 4 : 3), T, light.z);
    const gain = luminanceOf(colors.H, T).div(D.mul(D).mul(D.mul(D)).mul(source.x));
    const filter = vec4(band.xyz, select(light.z.lessThan(1), band.w, light.w));
    return [vec4(filteredColor(colors, filter).mul(gain), 0)];
  },
  checks: [within('color, over white', 0, (_, input) => Math.max(...whiteAt(input).map(Math.abs)), always(2e-3))],
});

export const spectrumTwins: readonly Twin[] = [thermal(false), thermal(true)];
