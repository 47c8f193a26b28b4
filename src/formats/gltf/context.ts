import type { Document, GLTF } from '@gltf-transform/core';
import { type LocalizedText, type Message, msg } from '../../messages/message.ts';
import type { VariantSet } from '../../scene/types.ts';
import type { SampledSpectrum } from '../../spectrum/sources/lightSpectrum.ts';
import type { DiagnosticCode } from '../diagnostics/diagnosticCodes.ts';
import type { DiagnosticLog } from '../diagnostics/diagnosticLog.ts';
import { inputError } from '../diagnostics/inputError.ts';
import type { DecodedImage } from '../image/decodeImage.ts';
import type { ReadOptions } from '../readOptions.ts';

/** Context of reading one glTF file. */
export interface GltfContext {
  /** Path of the file, for messages. */
  readonly entry: string;
  /** The JSON, validated. Nodes, meshes and materials of `document` are in the same order. */
  readonly json: GLTF.IGLTF;
  readonly document: Document;
  readonly options: ReadOptions;
  readonly pictures: DecodedPictures;
  /** Material variants, with the selected one. */
  readonly variants: VariantSet | undefined;
  readonly notes: DiagnosticLog;
  /** Spectrum tables named by lights. */
  readonly spectra: ReadonlyMap<string, SampledSpectrum | undefined>;
}

/** Pictures that the host decodes, by image; undefined: it cannot be read, which has been told. */
export type DecodedPictures = ReadonlyMap<number, DecodedImage | undefined>;

/** Bytes of buffers and images, by uri. */
export type Resources = Record<string, Uint8Array<ArrayBuffer>>;

/** An InputError: `what` is the part of the file, `message` the value and remedy. */
export const gltfError = (
  entry: string,
  code: DiagnosticCode,
  what: LocalizedText,
  message: Message,
  cause?: unknown,
) => inputError(code, what ? msg`${entry}: ${what}` : entry, message, cause);
