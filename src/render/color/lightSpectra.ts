import { distance, scale, type Vec3 } from '../../math/vec3.ts';
import { directLights } from '../../scene/lights/sceneLights.ts';
import type { ColorMode } from '../../scene/settings/settings.ts';
import type { DomeLight, Scene, SpectrumLight } from '../../scene/types.ts';
import type * as gpu from '../../shaders/types.ts';
import { lightFilter } from '../../spectrum/color/lightFilter.ts';
import type { FilteredBlackbody } from '../../spectrum/doppler/filterPairs.ts';
import { DAYLIGHT, type LightSpectrum } from '../../spectrum/sources/lightSpectrum.ts';
import { logLuminance } from '../../spectrum/sources/planck.ts';
import type { LineTable } from './lineTable.ts';
import type { SpectralSource } from './radiance.ts';

/** What tells shaders apart by which light is turned: all blackbodies of 6504 K together, others one by one. */
export type SpectrumKind = 'daylight' | 'thermal' | 'lines';

export const spectrumKindOf = ({ spectrum = DAYLIGHT }: { readonly spectrum?: LightSpectrum }): SpectrumKind =>
  spectrum.kind !== 'thermal' ? 'lines' : spectrum.temperature === DAYLIGHT.temperature ? 'daylight' : 'thermal';

/** Of a dome: where it names no spectrum its colour tells what air made of daylight, and that is apart; where it names daylight, that is a light like others. */
export function domeSpectrumKind(dome: DomeLight): SpectrumKind {
  const kind = spectrumKindOf(dome);
  return dome.spectrum && kind === 'daylight' ? 'thermal' : kind;
}

/** What light is multiplied with before its spectrum, for each way to show colours; of approximate ones what is seen of it at rest. */
export type LightColors = Readonly<Record<ColorMode, Vec3>>;

export const lightColorsOf = ({ color, spectrum = DAYLIGHT }: SpectrumLight): LightColors => ({
  approximate: color,
  spectral: spectrum === DAYLIGHT ? color : lightFilter(color, spectrum).rgb,
});

/** Light whose filter is nearer to grey than this counts as neutral. */
const NEUTRAL = 1e-3;
/** More lights than this share tables. */
const MAX_COLORED_LIGHTS = 20;

/** Blackbodies that shine through filters with a colour, each once, however bright it is. */
export function coloredLights(scene: Scene): readonly FilteredBlackbody[] {
  const known = new Map<string, FilteredBlackbody>();
  for (const light of directLights(scene)) {
    const found = coloredLight(light);
    if (found) known.set([found.temperature, ...found.filter.map((k) => k.toFixed(3))].join(' '), found);
  }
  return [...known.values()].slice(0, MAX_COLORED_LIGHTS);
}

/** `filter`: its greatest coefficient is 1. undefined of neutral light, and of lines. */
function coloredLight(light: SpectrumLight): FilteredBlackbody | undefined {
  const { spectrum = DAYLIGHT } = light;
  const filter = lightColorsOf(light).spectral;
  const most = Math.max(...filter);
  if (spectrum.kind !== 'thermal' || most - Math.min(...filter) <= NEUTRAL * most) return undefined;
  return { temperature: spectrum.temperature, filter: scale(filter, 1 / most) };
}

/** Which of these is a light's, or most like it; undefined of neutral light. */
export function coloredLightIndex(light: SpectrumLight, known: readonly FilteredBlackbody[]): number | undefined {
  const own = coloredLight(light);
  if (!own) return undefined;
  const unlike = known.map(
    ({ temperature, filter }) => Math.abs(Math.log(temperature / own.temperature)) + distance(filter, own.filter),
  );
  return unlike.indexOf(Math.min(...unlike));
}

/**
 * What tells shaders of its spectrum: the temperature [K] and the luminance of such a blackbody over that of daylight's, or where its lines are.
 */
export function spectrumParametersOf(
  { spectrum = DAYLIGHT }: SpectrumLight,
  lines: LineTable,
): readonly [number, number] {
  if (spectrum.kind !== 'thermal') return lines.add(spectrum);
  const T = spectrum.temperature;
  return [T, Math.exp(logLuminance(T) - logLuminance(DAYLIGHT.temperature))];
}

/** The same on the GPU. */
export function spectralSourceOf(
  kind: SpectrumKind,
  [a, b]: readonly [gpu.Float, gpu.Float],
  lines: LineTable,
): SpectralSource | undefined {
  if (kind === 'daylight') return undefined;
  return kind === 'thermal' ? { temperature: a, luminance: b } : lines.source(a, b);
}
