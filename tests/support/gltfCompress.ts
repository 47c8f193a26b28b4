import { type Document, WebIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS, EXTMeshoptCompression, KHRDracoMeshCompression } from '@gltf-transform/extensions';
import createDracoEncoder from 'draco3dgltf/draco_encoder_gltf_nodejs.js';
import { MeshoptEncoder } from 'meshoptimizer';

/** Writers of compressed files; they modify the document, so write each document only once. */

const io = (dependencies: Record<string, unknown>): WebIO =>
  new WebIO().registerExtensions(ALL_EXTENSIONS).registerDependencies(dependencies);

/** `bits`: quantization of positions. */
export function dracoGlb(doc: Document, method: 'edgebreaker' | 'sequential', bits = 16): Promise<Uint8Array> {
  doc
    .createExtension(KHRDracoMeshCompression)
    .setRequired(true)
    .setEncoderOptions({
      method: KHRDracoMeshCompression.EncoderMethod[method === 'sequential' ? 'SEQUENTIAL' : 'EDGEBREAKER'],
      quantizationBits: { POSITION: bits, NORMAL: 14, TEX_COORD: 14 },
    });
  return io({ 'draco3d.encoder': createDracoEncoder({ ENVIRONMENT: 'SHELL' }) }).writeBinary(doc);
}

/** `quantize`: lossless for numbers as they are; `filter`: rounded by the extension's filters. */
export async function meshoptGlb(doc: Document, method: 'quantize' | 'filter'): Promise<Uint8Array> {
  await MeshoptEncoder.ready;
  doc
    .createExtension(EXTMeshoptCompression)
    .setRequired(true)
    .setEncoderOptions({ method: EXTMeshoptCompression.EncoderMethod[method === 'filter' ? 'FILTER' : 'QUANTIZE'] });
  return io({ 'meshopt.encoder': MeshoptEncoder }).writeBinary(doc);
}
