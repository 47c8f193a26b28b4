import type { Registry } from '../nodeType.ts';
import { type Graph, type GraphDocument, type GraphNode, own } from './document.ts';

/**
 * Sorted distinct names of the files that nodes of a document read.
 * @example
 * import { newProject, nodeLibrary } from 'slowlight/nodes';
 * referencedFiles(newProject('street.usda'), nodeLibrary); // ['street.usda']
 */
export function referencedFiles(document: GraphDocument, registry: Registry): string[] {
  const found = new Set<string>();
  renameFiles(document, registry, (file) => {
    found.add(file);
    return file;
  });
  return [...found].sort();
}

/** The same document with its files renamed. */
export function renameFiles(
  document: GraphDocument,
  registry: Registry,
  name: (file: string) => string,
): GraphDocument {
  const groups = Object.entries(document.groups).map(([id, group]) => [
    id,
    { ...group, ...renameFilesInGraph(group, registry, name) },
  ]);
  const files = Object.entries(document.files).map(([file, reference]) => [name(file), reference]);
  return {
    ...document,
    ...renameFilesInGraph(document, registry, name),
    groups: Object.fromEntries(groups),
    files: Object.fromEntries(files),
  };
}

function renameFilesInGraph(
  { nodes }: Graph,
  registry: Registry,
  name: (file: string) => string,
): Pick<Graph, 'nodes'> {
  const changed = Object.entries(nodes).map(([id, node]): [string, GraphNode] => {
    const files = Object.entries(own(registry, node.type)?.params ?? {}).flatMap(([param, spec]) => {
      const file = own(node.params, param);
      return spec.kind === 'text' && spec.file && typeof file === 'string' && file ? [[param, name(file)]] : [];
    });
    return [id, files.length === 0 ? node : { ...node, params: { ...node.params, ...Object.fromEntries(files) } }];
  });
  return { nodes: Object.fromEntries(changed) };
}
