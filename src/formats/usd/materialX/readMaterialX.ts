import { msg } from '../../../messages/message.ts';
import type { AssetFiles } from '../assets/assetFiles.ts';
import { EMPTY_MAP, type Layer, type PrimSpec } from '../layer/layer.ts';
import { DocumentPrims, emptyPrim, type MaterialXRemark } from './documentPrims.ts';
import { documentElements } from './documents.ts';

/**
 * A MaterialX document as a USD layer, with the paths of OpenUSD's usdMtlx: its materials are below `/MaterialX/Materials`,
 * each with its shader and the node graphs that drive it; its node graphs are below `/MaterialX/NodeGraphs`, its shaders
 * below `/MaterialX/Shaders`. Throws an InputError that names file and line.
 */
export async function readMaterialX(
  bytes: Uint8Array,
  file: string,
  files: Pick<AssetFiles, 'find' | 'candidates'>,
  remark: MaterialXRemark,
): Promise<Layer> {
  const elements = await documentElements(bytes, file, files);
  const builder = new DocumentPrims(elements, file, remark);
  const groups = new Map<string, ReadonlyMap<string, PrimSpec>>([
    ['Materials', builder.materials()],
    ['NodeGraphs', builder.nodeGraphs()],
    ['Shaders', builder.shaders()],
  ]);
  const children = new Map<string, PrimSpec>();
  for (const [name, group] of groups)
    if (group.size > 0) children.set(name, { ...emptyPrim(`/MaterialX/${name}`, ''), children: group });
  const looks = elements.filter(({ element }) => element.name === 'look').length;
  if (looks > 0)
    remark('mtlx.left-out', msg`its looks are not read; bind its materials to prims in a USD layer (material:binding)`);
  const legacy = elements.find(({ element }) => element.name === 'material');
  if (legacy)
    remark(
      'mtlx.left-out',
      msg`line ${legacy.element.line}: <material> is of MaterialX before 1.38, and is not read (save it with MaterialX 1.38 or later)`,
    );
  const rootPrims = new Map<string, PrimSpec>();
  if (children.size > 0) rootPrims.set('MaterialX', { ...emptyPrim('/MaterialX', ''), children });
  return { name: file, metadata: EMPTY_MAP, rootPrims };
}
