import type { GLTF } from '@gltf-transform/core';
import { msg } from '../../../messages/message.ts';
import { InputError } from '../../../scene/types.ts';
import type { SampledSpectrum } from '../../../spectrum/sources/lightSpectrum.ts';
import { SPECTRUM_ATTRIBUTE } from '../../attributes/spectrumAttribute.ts';
import { readSpectrumCsv } from '../../attributes/spectrumCsv.ts';
import type { DiagnosticLog } from '../../diagnostics/diagnosticLog.ts';
import { missingSpectrum } from '../../diagnostics/missingFiles.ts';
import { type FileSource, resolvePath } from '../../files/fileSource.ts';

/** Loads the spectrum tables that lights' extras name (`lamp.csv`, beside the scene); missing or invalid ones are reported and undefined. */
export async function lightSpectra(
  source: FileSource,
  entry: string,
  json: GLTF.IGLTF,
  notes: DiagnosticLog,
): Promise<ReadonlyMap<string, SampledSpectrum | undefined>> {
  const spectra = new Map<string, SampledSpectrum | undefined>();
  for (const name of new Set(namesIn(json))) {
    const path = resolvePath(entry, name);
    const bytes = await source.read(path);
    const { code, message, missing } = missingSpectrum(name, [path]);
    if (!bytes) notes.add('warning', code, '', message, { missing });
    spectra.set(name, bytes && readOrTell(bytes, path, notes));
  }
  return spectra;
}

function readOrTell(bytes: Uint8Array, path: string, notes: DiagnosticLog): SampledSpectrum | undefined {
  try {
    return readSpectrumCsv(bytes, path);
  } catch (thrown) {
    if (!(thrown instanceof InputError)) throw thrown;
    notes.add('warning', 'spectrum.csv', '', msg`${thrown.text}; its light is taken for daylight`);
    return undefined;
  }
}

function namesIn(json: GLTF.IGLTF): string[] {
  const lights: unknown = Object(json.extensions?.KHR_lights_punctual).lights;
  return (Array.isArray(lights) ? lights : []).flatMap((light: unknown) => {
    const written: unknown = Object(Object(light).extras)[SPECTRUM_ATTRIBUTE];
    return typeof written === 'string' && /\.csv$/i.test(written) ? [written] : [];
  });
}
