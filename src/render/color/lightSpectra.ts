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

/** Kinds of spectra that shaders have different code for. Lights of a kind other than daylight are evaluated one by one. */
export type SpectrumKind = 'daylight' | 'thermal' | 'lines';

export const spectrumKindOf = ({ spectrum = DAYLIGHT }: { readonly spectrum?: LightSpectrum }): SpectrumKind =>
  spectrum.kind !== 'thermal' ? 'lines' : spectrum.temperature === DAYLIGHT.temperature ? 'daylight' : 'thermal';

/**
 * The kind of a dome: without a spectrum, its colour says how air scattered daylight, which is handled separately; with the spectrum of daylight, it is a
 * thermal light like others.
 */
export function domeSpectrumKind(dome: DomeLight): SpectrumKind {
  if (dome.blackbodies) return 'thermal';
  const kind = spectrumKindOf(dome);
  return dome.spectrum && kind === 'daylight' ? 'thermal' : kind;
}

/** The factor of a light's spectrum, for each colour mode; in those without spectra its colour at rest. */
export type LightColors = Readonly<Record<ColorMode, Vec3>>;

export const lightColorsOf = ({
  color,
  spectrum = DAYLIGHT,
}: Pick<SpectrumLight, 'color' | 'spectrum'>): LightColors => ({
  approximate: color,
  'two-wavelengths': color,
  'linear-spectrum': color,
  spectral: spectrum === DAYLIGHT ? color : lightFilter(color, spectrum).rgb,
});

/** A light whose filter is nearer to grey than this is neutral. */
const NEUTRAL = 1e-3;
/** Scenes with more coloured lights use the most similar table. */
const MAX_COLORED_LIGHTS = 20;

/** Blackbodies behind coloured filters, each once, whatever their brightness. */
export function coloredLights(scene: Scene): readonly FilteredBlackbody[] {
  const byKey = new Map<string, FilteredBlackbody>();
  for (const light of directLights(scene)) {
    const coloredBlackbody = coloredLight(light);
    if (coloredBlackbody)
      byKey.set(
        [coloredBlackbody.temperature, ...coloredBlackbody.filter.map((k) => k.toFixed(3))].join(' '),
        coloredBlackbody,
      );
  }
  return [...byKey.values()].slice(0, MAX_COLORED_LIGHTS);
}

/** `filter` is scaled to a largest coefficient of 1. Returns undefined for neutral lights and for lines. */
function coloredLight(light: SpectrumLight): FilteredBlackbody | undefined {
  const { spectrum = DAYLIGHT } = light;
  const filter = lightColorsOf(light).spectral;
  const max = Math.max(...filter);
  if (spectrum.kind !== 'thermal' || max - Math.min(...filter) <= NEUTRAL * max) return undefined;
  return { temperature: spectrum.temperature, filter: scale(filter, 1 / max) };
}

/** The index of a light's table among these, or of the most similar; undefined if the light is neutral. */
export function coloredLightIndex(light: SpectrumLight, lights: readonly FilteredBlackbody[]): number | undefined {
  const filtered = coloredLight(light);
  if (!filtered) return undefined;
  const differences = lights.map(
    ({ temperature, filter }) =>
      Math.abs(Math.log(temperature / filtered.temperature)) + distance(filter, filtered.filter),
  );
  return differences.indexOf(Math.min(...differences));
}

/**
 * A light's spectrum as shaders read it: the temperature [K] and the luminance of such a blackbody over that of daylight's, or where its lines are in the
 * table.
 */
export function spectrumParametersOf(
  { spectrum = DAYLIGHT }: Pick<SpectrumLight, 'spectrum'>,
  lines: LineTable,
): readonly [number, number] {
  if (spectrum.kind !== 'thermal') return lines.add(spectrum);
  const T = spectrum.temperature;
  return [T, Math.exp(logLuminance(T) - logLuminance(DAYLIGHT.temperature))];
}

/** `spectrumParametersOf` on the GPU. */
export function spectralSourceOf(
  kind: SpectrumKind,
  [a, b]: readonly [gpu.Float, gpu.Float],
  lines: LineTable,
): SpectralSource | undefined {
  if (kind === 'daylight') return undefined;
  return kind === 'thermal' ? { temperature: a, luminance: b } : lines.source(a, b);
}
