import type { Light, SpectrumLight } from '../../../../scene/types.ts';
import { formatSpectrum, SPECTRUM_ATTRIBUTE } from '../../../attributes/spectrumAttribute.ts';
import type { WriteContext } from '../motionLines.ts';
import type { PrimContent } from '../primTree.ts';
import { floats, type Lines } from '../usdaText.ts';

/** How lights of a kind are written as prims of UsdLux (docs/adr/0024-light-kinds.md). */
export type LightWriter<L extends Light> = (light: L, placement: WriteContext, files: LightFiles) => PrimContent;

/** Files that a light names, by the paths that they are written to. */
export interface LightFiles {
  readonly picture?: string | undefined;
  readonly spectrum?: string | undefined;
}

export function colorLines({ color, spectrum }: SpectrumLight, { spectrum: table }: LightFiles): Lines {
  const named = spectrum && formatSpectrum(spectrum);
  return [
    `color3f inputs:color = ${floats(color)}`,
    'float inputs:intensity = 1',
    ...(named ? [`custom token ${SPECTRUM_ATTRIBUTE} = "${named}"`] : []),
    ...(table ? [`custom asset ${SPECTRUM_ATTRIBUTE} = @${table}@`] : []),
  ];
}
