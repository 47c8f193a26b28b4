import { InputError, type Luminary } from '../../scene/types.ts';
import type { SampledSpectrum } from '../../spectrum/lightSpectrum.ts';
import { missingSpectrum } from '../missing.ts';
import { readSpectrumCsv } from '../spectrumCsv.ts';
import { textOf } from './attributes.ts';
import { report, type StageContext } from './context.ts';
import type { PrimSpec, Value } from './layer.ts';

/** Of one reading of a stage: each file once, so that what is found out about a spectrum is found out once. */
const read = new WeakMap<StageContext['files'], Map<string, SampledSpectrum>>();

/** The table (spectrumCsv.ts) that an asset value names; nothing, with a diagnostic, where it is not there or no spectrum. */
export async function spectrumOfFile(
  context: StageContext,
  prim: PrimSpec,
  value: Value,
): Promise<Pick<Luminary, 'spectrum'>> {
  const asset = textOf(value) ?? '';
  const anchor = (value.type === 'asset' && value.anchor) || context.layer.name;
  const found = await context.files.findBytes(anchor, asset);
  if (!found) {
    const { code, message, missing } = missingSpectrum(asset, context.files.candidates(anchor, asset));
    report(context, 'warning', code, prim.path, message, { missing });
    return {};
  }
  const known = read.get(context.files) ?? new Map<string, SampledSpectrum>();
  read.set(context.files, known);
  try {
    const spectrum = known.get(found.id) ?? readSpectrumCsv(found.bytes, found.id);
    known.set(found.id, spectrum);
    return { spectrum };
  } catch (thrown) {
    if (!(thrown instanceof InputError)) throw thrown;
    report(context, 'warning', 'spectrum.csv', prim.path, `${thrown.message}; its light is taken for daylight`);
    return {};
  }
}
