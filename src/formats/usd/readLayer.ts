import type { DiagnosticList } from '../diagnostics/diagnosticLog.ts';
import { contentBytes, contentHead, type FileContent } from '../files/rangedFile.ts';
import type { AssetFiles } from './assets/assetFiles.ts';
import type { ParseLayer } from './compose/layers/layerStore.ts';
import { readCrate } from './crate/readCrate.ts';
import { IDENT_BYTES, isCrate } from './crate/structure/bootstrap.ts';
import { report } from './diagnostics.ts';
import type { Layer } from './layer/layer.ts';
import { parseLayer } from './text/parser.ts';

/** Reads one USD layer, text or binary, whatever its file is called. Throws an InputError that names the place. */
export const readLayer = (content: FileContent, name: string): Layer =>
  isCrate(contentHead(content, IDENT_BYTES)) ? readCrate(content, name) : parseLayer(contentBytes(content), name);

/** Reads the layers of a stage, MaterialX documents too. */
export const layerParser =
  (files: AssetFiles, diagnostics: DiagnosticList): ParseLayer =>
  async (content, name) => {
    if (!isXml(contentHead(content, XML_HEAD))) return readLayer(content, name);
    const { readMaterialX } = await import('./materialX/readMaterialX.ts');
    return readMaterialX(contentBytes(content), name, files, (code, message) =>
      report({ layer: { name }, diagnostics }, 'warning', code, '', message),
    );
  };

const XML_HEAD = 64;
/** Whether a file begins as XML does, after a byte order mark and white space. */
const isXml = (head: Uint8Array): boolean => /^(\xef\xbb\xbf)?\s*<[?!a-z]/i.test(String.fromCharCode(...head));
