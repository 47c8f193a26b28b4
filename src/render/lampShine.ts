import type { Vec3 } from '../math/vec3.ts';
import type { Luminary } from '../scene/types.ts';
import type { ColorMode } from '../scene/view.ts';
import type * as gpu from '../shaders/types.ts';
import { lightFilter } from '../spectrum/lightFilter.ts';
import { DAYLIGHT, type LightSpectrum } from '../spectrum/lightSpectrum.ts';
import { logLuminance } from '../spectrum/planck.ts';
import type { LineTable } from './lineTable.ts';
import type { Source } from './radiance.ts';

/** What tells shaders apart by which light is turned: all blackbodies of 6504 K together, others one by one. */
export type ShineKind = 'daylight' | 'thermal' | 'lines';

export const shineKind = ({ spectrum = DAYLIGHT }: { readonly spectrum?: LightSpectrum }): ShineKind =>
  spectrum.kind !== 'thermal' ? 'lines' : spectrum.temperature === DAYLIGHT.temperature ? 'daylight' : 'thermal';

/** What light is multiplied with before its spectrum, for each way to show colours; of approximate ones what is seen of it at rest. */
export type ShineColors = Readonly<Record<ColorMode, Vec3>>;

export const shineColors = ({ color, spectrum = DAYLIGHT }: Luminary): ShineColors => ({
  approximate: color,
  spectral: spectrum === DAYLIGHT ? color : lightFilter(color, spectrum).rgb,
});

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
