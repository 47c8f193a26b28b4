import type { Light, SpectrumLight } from '../../../../scene/types.ts';
import { formatSpectrum, SPECTRUM_ATTRIBUTE } from '../../../attributes/spectrumAttribute.ts';
import { attribute, custom, type PrimContent, type Properties } from '../../layer/specs.ts';
import { asset, float, token, tuple } from '../../layer/values.ts';
import type { WriteContext } from '../motions.ts';

/** How lights of a kind are written as prims of UsdLux (docs/adr/0024-light-kinds.md). */
export type LightWriter<L extends Light> = (light: L, placement: WriteContext, files: LightFiles) => PrimContent;

/** Files that a light names, by the paths that they are written to. */
export interface LightFiles {
  readonly picture?: string | undefined;
  readonly spectrum?: string | undefined;
}

export function colorProperties({ color, spectrum }: SpectrumLight, { spectrum: table }: LightFiles): Properties {
  const named = spectrum && formatSpectrum(spectrum);
  return [
    attribute('color3f', 'inputs:color', tuple('float3', color)),
    attribute('float', 'inputs:intensity', float(1)),
    ...(named ? [custom('token', SPECTRUM_ATTRIBUTE, token(named))] : []),
    ...(table ? [custom('asset', SPECTRUM_ATTRIBUTE, asset(table))] : []),
  ];
}
