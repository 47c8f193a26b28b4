import { type Message, msg } from '../../../messages/message.ts';
import { measuredMaterial } from '../../../scene/materials/measuredMaterial.ts';
import { InputError, type Material, type SpectrumLight } from '../../../scene/types.ts';
import type { MeasuredReflectance } from '../../../spectrum/reflectance/measuredReflectance.ts';
import type { SampledSpectrum } from '../../../spectrum/sources/lightSpectrum.ts';
import { readReflectanceCsv, readSpectrumCsv } from '../../attributes/spectrumCsv.ts';
import { missingSpectrum } from '../../diagnostics/missingFiles.ts';
import { report } from '../diagnostics.ts';
import { textOf } from '../layer/attributes.ts';
import type { PrimSpec, Value } from '../layer/layer.ts';
import type { StageContext } from './context.ts';

/** Reads and caches the spectrum files of a stage, so that a problem is reported once. */
class TableCache<Table> {
  private readonly tables = new WeakMap<StageContext['files'], Map<string, Table>>();
  private readonly read: (bytes: Uint8Array, name: string) => Table;
  private readonly fallbackMessage: Message;

  /** `instead`: what is said of a missing or invalid table. */
  constructor(read: (bytes: Uint8Array, name: string) => Table, instead: Message) {
    this.read = read;
    this.fallbackMessage = instead;
  }

  /** The table (spectrumCsv.ts) of an asset value; undefined, with a diagnostic, if missing or invalid. */
  async load(context: StageContext, prim: PrimSpec, value: Value): Promise<Table | undefined> {
    const asset = textOf(value) ?? '';
    const anchor = (value.type === 'asset' && value.anchor) || context.layer.name;
    const found = await context.files.findBytes(anchor, asset);
    if (!found) {
      const { code, message, missing } = missingSpectrum(
        asset,
        context.files.candidates(anchor, asset),
        this.fallbackMessage,
      );
      report(context, 'warning', code, prim.path, message, { missing });
      return undefined;
    }
    const tables = this.tables.get(context.files) ?? new Map<string, Table>();
    this.tables.set(context.files, tables);
    try {
      const table = tables.get(found.id) ?? this.read(found.bytes, found.id);
      tables.set(found.id, table);
      return table;
    } catch (thrown) {
      if (!(thrown instanceof InputError)) throw thrown;
      report(context, 'warning', 'spectrum.csv', prim.path, msg`${thrown.text}; ${this.fallbackMessage}`);
      return undefined;
    }
  }
}

const spectra = new TableCache<SampledSpectrum>(readSpectrumCsv, msg`its light is taken for daylight`);
const reflectances = new TableCache<MeasuredReflectance>(
  readReflectanceCsv,
  msg`its surface has the colour of its inputs`,
);

/** The emission spectrum of a light. */
export async function spectrumOfFile(
  context: StageContext,
  prim: PrimSpec,
  value: Value,
): Promise<Pick<SpectrumLight, 'spectrum'>> {
  const spectrum = await spectra.load(context, prim, value);
  return spectrum ? { spectrum } : {};
}

/** The spectral reflectance of a material, with its bands. */
export async function reflectanceOfFile(
  context: StageContext,
  prim: PrimSpec,
  value: Value,
): Promise<Partial<Material>> {
  const reflectance = await reflectances.load(context, prim, value);
  return reflectance ? measuredMaterial(reflectance) : {};
}
