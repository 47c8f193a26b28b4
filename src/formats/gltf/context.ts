import type { Document, GLTF } from '@gltf-transform/core';
import type { VariantSet } from '../../scene/types.ts';
import type { SampledSpectrum } from '../../spectrum/sources/lightSpectrum.ts';
import type { DiagnosticCode } from '../diagnostics/diagnosticCodes.ts';
import type { DiagnosticLog } from '../diagnostics/diagnosticLog.ts';
import { inputError } from '../diagnostics/inputError.ts';
import type { ReadOptions } from '../readOptions.ts';

/** What every part of the reader needs to know of the file it reads. */
export interface GltfContext {
  /** Path of the file, for messages. */
  readonly entry: string;
  /** As written; already checked. Nodes, meshes and materials of `document` are in the same order. */
  readonly json: GLTF.IGLTF;
  readonly document: Document;
  readonly options: ReadOptions;
  /** Of its materials, with the one to show. */
  readonly variants: VariantSet | undefined;
  readonly notes: DiagnosticLog;
  /** Tables of spectra that its lights name. */
  readonly spectra: ReadonlyMap<string, SampledSpectrum | undefined>;
}

/** Bytes of buffers and images, by uri. */
export type Resources = Record<string, Uint8Array<ArrayBuffer>>;

/** Refuses the file: `what` names the thing in it, `message` the value and what to do. */
export const gltfError = (entry: string, code: DiagnosticCode, what: string, message: string, cause?: unknown) =>
  inputError(code, what ? `${entry}: ${what}` : entry, message, cause);
