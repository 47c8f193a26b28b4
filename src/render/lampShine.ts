import { distance, scale, type Vec3 } from '../math/vec3.ts';
import { directLights } from '../scene/daylight.ts';
import type { DomeLight, Luminary, Scene } from '../scene/types.ts';
import type { ColorMode } from '../scene/view.ts';
import type * as gpu from '../shaders/types.ts';
import type { ColoredLight } from '../spectrum/filterPairs.ts';
import { lightFilter } from '../spectrum/lightFilter.ts';
import { DAYLIGHT, type LightSpectrum } from '../spectrum/lightSpectrum.ts';
import { logLuminance } from '../spectrum/planck.ts';
import type { LineTable } from './lineTable.ts';
import type { Source } from './radiance.ts';

/** What tells shaders apart by which light is turned: all blackbodies of 6504 K together, others one by one. */
export type ShineKind = 'daylight' | 'thermal' | 'lines';

export const shineKind = ({ spectrum = DAYLIGHT }: { readonly spectrum?: LightSpectrum }): ShineKind =>
  spectrum.kind !== 'thermal' ? 'lines' : spectrum.temperature === DAYLIGHT.temperature ? 'daylight' : 'thermal';

/** Of a dome: where it names no spectrum its colour tells what air made of daylight, and that is apart; where it names daylight, that is a light like others. */
export function domeKind(dome: DomeLight): ShineKind {
  const kind = shineKind(dome);
  return dome.spectrum && kind === 'daylight' ? 'thermal' : kind;
}

/** What light is multiplied with before its spectrum, for each way to show colours; of approximate ones what is seen of it at rest. */
export type ShineColors = Readonly<Record<ColorMode, Vec3>>;

export const shineColors = ({ color, spectrum = DAYLIGHT }: Luminary): ShineColors => ({
  approximate: color,
  spectral: spectrum === DAYLIGHT ? color : lightFilter(color, spectrum).rgb,
});

/** Light whose filter is nearer to grey than this counts as neutral. */
const NEUTRAL = 1e-3;
/** More lights than this share tables. */
const MOST_TABLES = 20;

/** Blackbodies that shine through filters with a colour, each once, however bright it is. */
export function coloredLights(scene: Scene): readonly ColoredLight[] {
  const known = new Map<string, ColoredLight>();
  for (const light of directLights(scene)) {
    const found = coloredLight(light);
    if (found) known.set([found.temperature, ...found.filter.map((k) => k.toFixed(3))].join(' '), found);
  }
  return [...known.values()].slice(0, MOST_TABLES);
}

/** `filter`: its greatest coefficient is 1. undefined of neutral light, and of lines. */
function coloredLight(light: Luminary): ColoredLight | undefined {
  const { spectrum = DAYLIGHT } = light;
  const filter = shineColors(light).spectral;
  const most = Math.max(...filter);
  if (spectrum.kind !== 'thermal' || most - Math.min(...filter) <= NEUTRAL * most) return undefined;
  return { temperature: spectrum.temperature, filter: scale(filter, 1 / most) };
}

/** Which of these is a light's, or most like it; undefined of neutral light. */
export function coloredIndex(light: Luminary, known: readonly ColoredLight[]): number | undefined {
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
export function shineNumbers({ spectrum = DAYLIGHT }: Luminary, lines: LineTable): readonly [number, number] {
  if (spectrum.kind !== 'thermal') return lines.add(spectrum);
  const T = spectrum.temperature;
  return [T, Math.exp(logLuminance(T) - logLuminance(DAYLIGHT.temperature))];
}

/** The same on the GPU. */
export function sourceOf(
  kind: ShineKind,
  [a, b]: readonly [gpu.Float, gpu.Float],
  lines: LineTable,
): Source | undefined {
  if (kind === 'daylight') return undefined;
  return kind === 'thermal' ? { temperature: a, luminance: b } : lines.source(a, b);
}
