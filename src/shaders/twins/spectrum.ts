import { select, vec4 } from 'three/tsl';
import { dot, scale } from '../../math/vec3.ts';
import { LUMINANCE_WEIGHTS, observedColor, toLinearSrgb } from '../../spectrum/color/observerColor.ts';
import { skyParts as cpuSkyParts } from '../../spectrum/color/scatteredLight.ts';
import type { DopplerTable } from '../../spectrum/doppler/dopplerTable.ts';
import { filteredBlackbodyTable } from '../../spectrum/doppler/filterPairs.ts';
import { thermalTable } from '../../spectrum/doppler/thermalTable.ts';
import { colorMatching, VISIBLE } from '../../spectrum/observer/standardObserver.ts';
import {
  filterFromRgb,
  reflectanceAt,
  type SpectralFilter,
  WHITE_FILTER,
} from '../../spectrum/reflectance/spectralFilter.ts';
import { DAYLIGHT } from '../../spectrum/sources/lightSpectrum.ts';
import { logLuminance } from '../../spectrum/sources/planck.ts';
import { lineColor } from '../color/lineColor.ts';
import { skyParts } from '../color/skyParts.ts';
import { HalfAtlas } from '../tables/halfAtlas.ts';
import { observerTexels } from '../tables/observerTable.ts';
import { coloredColors, filteredColor, luminanceOf, spectrumTable, thermalColors } from '../tables/spectrumTable.ts';
import { absolute, always, within } from './checks.ts';
import { casesOf, logUniform, vec3At } from './inputs.ts';
import type { Twin } from './twin.ts';

/** One atlas for all tables here, so that each is read beside others. */
const atlas = new HalfAtlas();
const tables = new Map<3 | 4, DopplerTable>();
function blackbodies(layers: 3 | 4) {
  const made = tables.get(layers) ?? thermalTable(layers);
  tables.set(layers, made);
  return spectrumTable(atlas, `blackbodies ${layers}`, made);
}

/** (r, g, b, uv) · (T of the source, D_in, D_out, ir) · (Y(T)/Y(6504 K) of the source, 0, 0, 0) */
function texelsOf(bands: SpectralFilter, T: number, Din: number, Dout: number): readonly number[] {
  const luminance = Math.exp(logLuminance(T) - logLuminance(DAYLIGHT.temperature));
  return [...bands.rgb, bands.uv, T, Din, Dout, bands.ir, luminance, 0, 0, 0];
}

const bandsAt = (input: readonly number[]): SpectralFilter => ({ rgb: vec3At(input, 0), uv: input[3], ir: input[7] });
const whiteAt = ([, , , , temperature, Din, Dout]: readonly number[]) =>
  observedColor(WHITE_FILTER, WHITE_FILTER, { kind: 'thermal', temperature }, Din, Dout);

/** Compared with sums over every nanometre, so the table's error is included. `own`: filters have their own ultraviolet and infrared. */
const thermal = (own: boolean): Twin => ({
  name: own ? 'thermalColors, four layers' : 'thermalColors',
  parts: ['thermalColors', 'filteredColor', 'luminanceOf', 'spectrumTable', 'HalfAtlas'],
  texels: 3,
  outputs: 1,
  cases: (random) => {
    const filter = (): SpectralFilter => {
      const rgb = [random(), random(), random()] as const;
      return own ? filterFromRgb(rgb, random(), random()) : filterFromRgb(rgb);
    };
    return [
      ...casesOf([{ name: 'D 1/8 … 8, daylight', gamma: 1 }], 300, () => {
        const [D, Dout] = [logUniform(random, 1 / 8, 8), logUniform(random, 1 / 8, 8)];
        return texelsOf(filter(), DAYLIGHT.temperature, D / Dout, Dout);
      }),
      ...casesOf([{ name: 'D near 1, T 2000 … 20,000 K', gamma: 1 }], 300, () => {
        const shift = () => logUniform(random, 0.7, 1.4);
        return texelsOf(filter(), logUniform(random, 2000, 20_000), shift(), shift());
      }),
      ...casesOf([{ name: 'embers, T D 400 … 1200 K', gamma: 1 }], 300, () => {
        const [T, seen] = [logUniform(random, 600, 3000), logUniform(random, 400, 1200)];
        const Dout = logUniform(random, 0.4, 2.5);
        return texelsOf(filter(), T, seen / T / Dout, Dout);
      }),
      ...casesOf([{ name: 'D = 1', gamma: 1 }], 30, () => texelsOf(filter(), DAYLIGHT.temperature, 1, 1)),
    ];
  },
  cpu: (input) => {
    const [T, Din, Dout] = input.slice(4);
    return [...observedColor(bandsAt(input), WHITE_FILTER, { kind: 'thermal', temperature: T }, Din, Dout), 0];
  },
  gpu: (texel) => {
    const [band, light, source] = [texel(0), texel(1), texel(2)];
    const D = light.y.mul(light.z).toVar();
    const T = light.x.mul(D).toVar();
    const colors = thermalColors(blackbodies(own ? 4 : 3), T, light.z);
    const gain = luminanceOf(colors.G, T).div(D.mul(D).mul(D.mul(D)).mul(source.x));
    const filter = vec4(band.xyz, select(light.z.lessThan(1), band.w, light.w));
    return [vec4(filteredColor(colors, filter).mul(gain), 0)];
  },
  checks: [within('color, over white', 0, (_, input) => Math.max(...whiteAt(input).map(Math.abs)), always(1e-3))],
});

const COLORED = [
  { temperature: DAYLIGHT.temperature, filter: [1, 0.4, 0.1] },
  { temperature: 3000, filter: [0.2, 0.5, 1] },
] as const;

/** (r, g, b, 0) · (light, D_in, D_out, 0), compared with sums over every nanometre. */
const colored: Twin = {
  name: 'coloredColors',
  texels: 2,
  outputs: 1,
  cases: (random) =>
    casesOf([{ name: 'D 0.7 … 1.4', gamma: 1 }], 300, () => {
      const shift = () => logUniform(random, 0.7, 1.4);
      return [random(), random(), random(), 0, random() < 0.5 ? 0 : 1, shift(), shift(), 0];
    }),
  cpu: (input) => {
    const [light, Din, Dout] = input.slice(4);
    const { temperature, filter } = COLORED[light];
    const seen = (a: SpectralFilter, k: SpectralFilter) =>
      observedColor(a, k, { kind: 'thermal', temperature }, Din, Dout);
    const level = dot(LUMINANCE_WEIGHTS, seen(WHITE_FILTER, WHITE_FILTER));
    return [...scale(seen(filterFromRgb(vec3At(input, 0)), filterFromRgb(filter)), 1 / level), 0];
  },
  gpu: (texel) => {
    const [filter, { x, y, z }] = [vec4(texel(0).xyz, 0), texel(1)];
    const [first, second] = COLORED.map((light, i) => {
      const table = spectrumTable(atlas, `colored ${i}`, filteredBlackbodyTable(light, 3));
      return filteredColor(coloredColors(table, y.mul(z), z), filter);
    });
    return [vec4(select(x.lessThan(0.5), first, second), 0)];
  },
  checks: [absolute('color, over white', 0, 3, always(1e-2))],
};

/** (r, g, b, uv) · (wavelength at the filter and at the observer [nm], ir, 0) */
const lines = (own: boolean): Twin => ({
  name: own ? 'lineColor, own ends' : 'lineColor',
  parts: ['lineColor', 'observerTexels'],
  texels: 2,
  outputs: 1,
  cases: (random) =>
    casesOf([{ name: '300 … 1000 nm', gamma: 1 }], 600, () => {
      const rgb = [random(), random(), random()] as const;
      const { uv, ir } = own ? filterFromRgb(rgb, random(), random()) : filterFromRgb(rgb);
      return [...rgb, uv, 300 + 700 * random(), 340 + 500 * random(), ir, 0];
    }),
  cpu: (input) => {
    const [surface, seen, ir] = input.slice(4);
    const visible = surface * 1e-9 >= VISIBLE[0] && surface * 1e-9 <= VISIBLE[1];
    // The filter's value outside the visible that this observer would see.
    const beyond = seen > surface ? input[3] : ir;
    const share = visible ? reflectanceAt({ rgb: vec3At(input, 0), uv: 0, ir: 0 }, surface * 1e-9) : beyond;
    return [...scale(toLinearSrgb(colorMatching(seen * 1e-9)), share), 0];
  },
  gpu: (texel) => {
    const observer = atlas.table('observer', observerTexels);
    const [band, line] = [texel(0), texel(1)];
    const filter = vec4(band.xyz, select(line.y.greaterThan(line.x), band.w, line.z));
    return [vec4(lineColor(observer, line.x.mul(1e-9), line.y.mul(1e-9), filter, own), 0)];
  },
  checks: [absolute('color', 0, 3, always(3e-3))],
});

/** (r, g, b, 0) */
const sky: Twin = {
  name: 'skyParts',
  texels: 1,
  outputs: 2,
  cases: (random) => casesOf([{ name: 'any', gamma: 1 }], 300, () => [random(), random(), random(), 0]),
  cpu: (input) => {
    const { scattered, reddened, rest } = cpuSkyParts(vec3At(input, 0));
    return [scattered, ...reddened, ...rest, 0];
  },
  gpu: (texel) => {
    const { luminances, rest } = skyParts(texel(0).xyz);
    return [vec4(luminances[0], luminances[1], luminances[2], luminances[3]), vec4(rest, 0)];
  },
  checks: [absolute('luminances', 0, 4, always(2e-6)), absolute('rest', 4, 3, always(2e-6))],
};

export const spectrumTwins: readonly Twin[] = [thermal(false), thermal(true), colored, sky, lines(false), lines(true)];
