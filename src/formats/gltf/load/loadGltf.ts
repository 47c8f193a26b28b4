import { BufferUtils, type Document, type GLTF, type ILogger, WebIO } from '@gltf-transform/core';
import {
  EXTMeshGPUInstancing,
  KHRLightsPunctual,
  KHRMaterialsPBRSpecularGlossiness,
  KHRMaterialsVariants,
  KHRMeshQuantization,
  KHRTextureTransform,
} from '@gltf-transform/extensions';
import { inEnglish, type LocalizedText, listed, msg } from '../../../messages/message.ts';
import { messageOf } from '../../../messages/messageError.ts';
import type { DiagnosticLog } from '../../diagnostics/diagnosticLog.ts';
import { formatBytes } from '../../diagnostics/inputError.ts';
import { missingTexture } from '../../diagnostics/missingFiles.ts';
import { type FileSource, resolvePath } from '../../files/fileSource.ts';
import type { DecodePicture } from '../../image/foreignPictures.ts';
import { COMPRESSIONS, isFallback, unpackGeometry } from '../compression/unpack.ts';
import { type DecodedPictures, gltfError, type Resources } from '../context.ts';
import { KHR_MATERIALS } from '../materialExtensions.ts';
import { checkGltf } from './checkReferences.ts';
import { checkSchema } from './checkSchema.ts';
import { decodePictures, HOST_EXTENSIONS, KTX2_EXTENSION } from './pictures.ts';
import { textureSlots } from './textureSlots.ts';

const GLB_MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BIN_CHUNK = 0x004e4942;
/** Where glTF-Transform looks for the binary chunk of a GLB. */
const GLB_BUFFER = '@glb.bin';

const EXTENSIONS = [
  EXTMeshGPUInstancing,
  KHRLightsPunctual,
  ...KHR_MATERIALS,
  KHRMaterialsPBRSpecularGlossiness,
  KHRMaterialsVariants,
  KHRMeshQuantization,
  KHRTextureTransform,
];
const HANDLED: readonly string[] = [
  ...EXTENSIONS.map((e) => e.EXTENSION_NAME),
  ...COMPRESSIONS,
  KTX2_EXTENSION,
  'KHR_node_visibility',
];
/** Extensions that affect appearance only. */
const LOOKS_ONLY = /^(KHR_materials_|KHR_xmp|EXT_structural_metadata|EXT_mesh_features|EXT_texture_)/;
const CHANGES_COLOR = /^EXT_texture_/;

/** Loads a file with its resources, validates and parses it. */
export async function loadGltf(
  source: FileSource,
  entry: string,
  notes: DiagnosticLog,
  decodePicture?: DecodePicture,
): Promise<{ json: GLTF.IGLTF; document: Document; pictures: DecodedPictures }> {
  const bytes = await source.read(entry);
  if (!bytes) throw gltfError(entry, 'file.missing', '', msg`no such file`);
  const { json, binary } = unpackContainer(entry, bytes);
  const resources = await loadResources(source, entry, json, notes);
  if (binary) resources[GLB_BUFFER] = binary;
  checkExtensions(entry, json, notes, decodePicture ? [...HANDLED, ...HOST_EXTENSIONS] : HANDLED);
  const pictures = await decodePictures({ json, resources, glb: GLB_BUFFER, notes }, decodePicture);
  dropUnreadTextures(json, notes);
  dropUnknownInterpolations(json, notes);
  await unpackGeometry(entry, json, resources);
  checkGltf(entry, json, resources);
  // A later version has been found readable, and glTF-Transform asks for this one.
  json.asset.version = '2.0';
  const quiet = (): void => {};
  const logger: ILogger = { debug: quiet, info: quiet, warn: quiet, error: quiet };
  const io = new WebIO().setLogger(logger).registerExtensions(EXTENSIONS);
  return { json, pictures, document: await io.readJSON({ json, resources }) };
}

function unpackContainer(entry: string, bytes: Uint8Array): { json: GLTF.IGLTF; binary?: Uint8Array<ArrayBuffer> } {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const isBinary = bytes.length >= 4 && view.getUint32(0, true) === GLB_MAGIC;
  if (!isBinary) return { json: parseJson(entry, bytes) };
  const size = bytes.length >= 12 ? view.getUint32(8, true) : 12;
  if (size > bytes.length) {
    const message = msg`${formatBytes(bytes.length)} of ${formatBytes(size)}: the file is cut off; copy or export it again`;
    throw gltfError(entry, 'gltf.truncated', '', message);
  }
  const version = view.getUint32(4, true);
  if (version !== 2)
    throw gltfError(entry, 'gltf.version', '', msg`GLB version ${version}; only 2 is read, export it as glTF 2.0`);
  const chunks = readChunks(entry, view, bytes, size);
  const json = chunks.get(JSON_CHUNK);
  if (!json) throw gltfError(entry, 'gltf.damaged', '', msg`the GLB has no JSON chunk; export it again`);
  const binary = chunks.get(BIN_CHUNK);
  return { json: parseJson(entry, json), ...(binary ? { binary: unshared(binary) } : {}) };
}

function readChunks(entry: string, view: DataView, bytes: Uint8Array, size: number): Map<number, Uint8Array> {
  const chunks = new Map<number, Uint8Array>();
  for (let at = 12; at + 8 <= size; ) {
    const length = view.getUint32(at, true);
    const type = view.getUint32(at + 4, true);
    if (at + 8 + length > size) {
      const message = msg`a chunk of ${formatBytes(length)} at byte ${at} runs past the end; export it again`;
      throw gltfError(entry, 'gltf.truncated', '', message);
    }
    if (!chunks.has(type)) chunks.set(type, bytes.subarray(at + 8, at + 8 + length));
    at += 8 + length;
  }
  return chunks;
}

function parseJson(entry: string, bytes: Uint8Array): GLTF.IGLTF {
  let json: unknown;
  try {
    json = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
  } catch (thrown) {
    const message = msg`the JSON is damaged or cut off (${messageOf(thrown)}); copy or export it again`;
    throw gltfError(entry, 'gltf.damaged', '', message, thrown);
  }
  const isGltf = typeof json === 'object' && json !== null && Object.hasOwn(json, 'asset');
  if (!isGltf) throw gltfError(entry, 'gltf.damaged', '', msg`not a glTF: the JSON has no "asset"`);
  checkVersion(entry, json as { readonly asset: unknown });
  return checkSchema(entry, json);
}

/** A later version may be read as 2.0 unless it says that it needs more (glTF 2.0, 3.2). Before the schema is checked: that of glTF 1 is another. */
function checkVersion(entry: string, { asset }: { readonly asset: unknown }): void {
  const { version, minVersion = '2.0' } = (asset ?? {}) as Record<string, unknown>;
  if (minVersion === '2.0' && typeof version === 'string' && /^2\.\d+$/.test(version)) return;
  const needed = minVersion === '2.0' ? version : minVersion;
  const shown = needed === undefined ? msg`(none)` : String(needed).slice(0, 40);
  throw gltfError(entry, 'gltf.version', 'asset', msg`glTF ${shown}; only 2.0 is read, export it as 2.0`);
}

const INTERPOLATIONS: readonly unknown[] = [undefined, 'LINEAR', 'STEP', 'CUBICSPLINE'];

/** Exporters write numbers for names. */
function dropUnknownInterpolations(json: GLTF.IGLTF, notes: DiagnosticLog): void {
  for (const [i, { samplers }] of (json.animations ?? []).entries()) {
    const odd = samplers.filter(({ interpolation }) => !INTERPOLATIONS.includes(interpolation));
    if (odd.length === 0) continue;
    const shown = JSON.stringify(odd[0].interpolation).slice(0, 40);
    for (const sampler of odd) delete sampler.interpolation;
    const message = msg`the interpolation ${shown} of ${odd.length} of ${samplers.length} samplers is not LINEAR, STEP or CUBICSPLINE; it is taken as LINEAR`;
    notes.add('warning', 'gltf.interpolation', msg`animation ${i}`, message);
  }
}

/** Buffers and images by URI. Data URIs are decoded and replaced by short names in `json`. */
async function loadResources(
  source: FileSource,
  entry: string,
  json: GLTF.IGLTF,
  notes: DiagnosticLog,
): Promise<Resources> {
  const resources: Resources = Object.create(null);
  const load = async (item: { uri?: string }, what: LocalizedText): Promise<boolean> => {
    if (item.uri === undefined) return true;
    const bytes = await loadUri(source, entry, what, item.uri);
    if (item.uri.startsWith('data:')) item.uri = inEnglish(what);
    resources[item.uri] = bytes ?? new Uint8Array(0);
    return bytes !== undefined;
  };
  for (const [i, buffer] of (json.buffers ?? []).entries()) {
    const { uri = '' } = buffer;
    if (isFallback(buffer) || (await load(buffer, msg`buffer ${i}`))) continue;
    throw gltfError(
      entry,
      'gltf.missing-file',
      msg`buffer ${i}`,
      msg`there is no file ${uri}; put it beside the scene`,
    );
  }
  for (const [i, image] of (json.images ?? []).entries()) {
    const { uri = '' } = image;
    if (await load(image, msg`image ${i}`)) continue;
    const { code, message, missing } = missingTexture(uri, [resolvePath(entry, unescaped(uri))]);
    notes.add('warning', code, usersOf(json, i), message, { missing });
  }
  return resources;
}

/** Names an image and the materials that use it: `image 3, material Wood`. */
function usersOf(json: GLTF.IGLTF, image: number): LocalizedText {
  const users = (json.materials ?? []).flatMap((material, i) =>
    textureSlots(material).some(({ info }) => json.textures?.[info.index]?.source === image)
      ? [msg`material ${material.name ?? i}`]
      : [],
  );
  return listed([msg`image ${image}`, ...users.slice(0, 3), ...(users.length > 3 ? ['…'] : [])]);
}

async function loadUri(
  source: FileSource,
  entry: string,
  what: LocalizedText,
  uri: string,
): Promise<Uint8Array<ArrayBuffer> | undefined> {
  if (uri.startsWith('data:')) {
    try {
      return BufferUtils.createBufferFromDataURI(uri);
    } catch (thrown) {
      throw gltfError(entry, 'gltf.damaged', what, msg`its data URI cannot be decoded (${messageOf(thrown)})`, thrown);
    }
  }
  const bytes = (await source.read(resolvePath(entry, unescaped(uri)))) ?? (await source.read(resolvePath(entry, uri)));
  return bytes && unshared(bytes);
}

/** File sources never return shared memory; the type does not say so. */
const unshared = (bytes: Uint8Array): Uint8Array<ArrayBuffer> => bytes as Uint8Array<ArrayBuffer>;

/** URIs are percent-encoded, but not by every exporter. */
function unescaped(uri: string): string {
  try {
    return decodeURIComponent(uri);
  } catch {
    return uri;
  }
}

/** Throws for unsupported required extensions, reports ignored ones, and hides both from glTF-Transform. */
function checkExtensions(entry: string, json: GLTF.IGLTF, notes: DiagnosticLog, handled: readonly string[]): void {
  for (const name of json.extensionsRequired ?? []) {
    if (handled.includes(name) || LOOKS_ONLY.test(name)) continue;
    const message = msg`it needs the extension ${name}, which is not read; export it without`;
    throw gltfError(entry, 'gltf.unsupported-extension', '', message);
  }
  for (const name of json.extensionsUsed ?? []) {
    if (handled.includes(name)) continue;
    const severity = LOOKS_ONLY.test(name) && !CHANGES_COLOR.test(name) ? 'info' : 'warning';
    const effect = CHANGES_COLOR.test(name) ? msg`; what uses it is shown without its picture or colour` : '';
    notes.add(severity, 'gltf.ignored-extension', '', msg`the extension ${name} is left out${effect}`);
  }
  json.extensionsRequired = json.extensionsRequired?.filter((name) =>
    EXTENSIONS.some((e) => e.EXTENSION_NAME === name),
  );
}

/** Removes textures only available in unsupported formats from materials. */
function dropUnreadTextures(json: GLTF.IGLTF, notes: DiagnosticLog): void {
  for (const [i, material] of (json.materials ?? []).entries()) {
    for (const { holder, name, info } of textureSlots(material)) {
      const texture = json.textures?.[info.index];
      if (texture === undefined || texture.source !== undefined) continue;
      delete holder[name];
      notes.add(
        'warning',
        'file.unreadable-texture',
        msg`material ${material.name ?? i}`,
        msg`its ${name} has no picture that is read; shown without it`,
      );
    }
  }
}
