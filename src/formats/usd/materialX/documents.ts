import { listed, msg } from '../../../messages/message.ts';
import { inputError } from '../../diagnostics/inputError.ts';
import { contentBytes } from '../../files/rangedFile.ts';
import type { AssetFiles } from '../assets/assetFiles.ts';
import { parseXml, type XmlElement } from './xml.ts';

/** Maximum number of documents that one includes, itself too. */
export const MAX_DOCUMENTS = 64;

/** MaterialX's own libraries, whose nodes the reader knows: older documents include them. */
const LIBRARIES =
  /(^|\/)(stdlib|pbrlib|bxdf|nprlib|lights|cmlib)\/|(^|\/)(stdlib|pbrlib|nprlib|cmlib|lights)_(defs|ng)\.mtlx$|(^|\/)(standard_surface|open_pbr_surface|gltf_pbr|usd_preview_surface|disney_principled)\.mtlx$/;

/** An element, with what the document around it says of all its elements. */
export interface DocumentElement {
  readonly element: XmlElement;
  readonly file: string;
  readonly colorSpace: string;
  readonly filePrefix: string;
}

/** The elements of a document and of all that it includes (`xi:include`), in the order of reading. Throws InputErrors. */
export async function documentElements(
  bytes: Uint8Array,
  file: string,
  files: Pick<AssetFiles, 'find' | 'candidates'>,
): Promise<DocumentElement[]> {
  const found: DocumentElement[] = [];
  let documents = 0;
  const read = async (content: Uint8Array, id: string, around: readonly string[]): Promise<void> => {
    if (++documents > MAX_DOCUMENTS)
      throw inputError('mtlx.include', file, msg`includes more than ${MAX_DOCUMENTS} documents`);
    const root = parseXml(content, id);
    assertMaterialX(root, id);
    const colorSpace = root.attributes.get('colorspace') ?? '';
    const filePrefix = root.attributes.get('fileprefix') ?? '';
    for (const element of root.children) {
      if (element.name === 'xi:include') await include(element, id, around);
      else found.push({ element, file: id, colorSpace, filePrefix });
    }
  };
  const include = async ({ attributes, line }: XmlElement, id: string, around: readonly string[]): Promise<void> => {
    const href = attributes.get('href') ?? '';
    const place = msg`${id}, line ${line}`;
    if (href === '' || /^[a-z][a-z0-9+.-]+:/i.test(href))
      throw inputError('mtlx.include', place, msg`includes '${href}', which is no path of a file`);
    const next = await files.find(id, href);
    if (!next && LIBRARIES.test(href)) return;
    if (!next)
      throw inputError(
        'mtlx.include',
        place,
        msg`includes '${href}', which is not there (looked for ${listed(files.candidates(id, href))}); open the folder that holds it`,
      );
    if (around.includes(next.id)) throw inputError('mtlx.include', place, msg`'${href}' includes itself`);
    await read(contentBytes(next.content), next.id, [...around, next.id]);
  };
  await read(bytes, file, [file]);
  return found;
}

/** MaterialX 1.36 to 1.39 share the elements that are read. */
function assertMaterialX({ name, attributes }: XmlElement, file: string): void {
  if (name !== 'materialx')
    throw inputError('mtlx.syntax', file, msg`its first element is <${name}>, so it is no MaterialX document`);
  const version = attributes.get('version') ?? '';
  if (!/^1\.\d+(\.\d+)?$/.test(version))
    throw inputError('mtlx.version', file, msg`is MaterialX of version '${version}'; only 1.x is read`);
}
