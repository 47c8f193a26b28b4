import { flatten } from '../../graph/analysis/flatten.ts';
import { DocumentError, type GraphDocument } from '../../graph/document/document.ts';
import { isParamActive, type NodeProblem, type NodeType, resolveParams } from '../../graph/nodeType.ts';
import { ShaderTextError } from '../../scene/shaderText/sourceLocation.ts';
import { nodeLibrary } from '../library.ts';

/** Faults of shader texts in nodes, by id, which evaluation does not find: of nodes that lead nowhere, too. Texts in files are not read. */
export async function shaderTextFaults(
  document: GraphDocument,
  isEvaluated: (node: string) => boolean = () => false,
): Promise<ReadonlyMap<string, NodeProblem>> {
  const texts = textsOf(document).filter(({ node }) => !isEvaluated(node));
  if (texts.length === 0) return new Map();
  const { readShaderText } = await import('../../scene/shaderText/shaderText.ts');
  return new Map(
    texts.flatMap(({ node, text }) => {
      try {
        readShaderText(text);
        return [];
      } catch (error) {
        if (!(error instanceof ShaderTextError)) throw error;
        return [[node, { severity: 'error', code: 'shader.text', place: node, message: error.text }] as const];
      }
    }),
  );
}

/** The shader texts that count, as far as no edge drives them. */
function textsOf(document: GraphDocument): readonly { readonly node: string; readonly text: string }[] {
  return [...nodesOf(document)].flatMap(({ id, type: name, params: set, inputs }) => {
    const type = nodeLibrary[name] as NodeType | undefined;
    if (!type) return [];
    const params = resolveParams(type, set);
    return Object.entries(type.params).flatMap(([param, spec]) => {
      const counts = spec.kind === 'text' && spec.shader && isParamActive(type, spec, params) && params.file === '';
      const isDriven = [param, 'file', spec.onlyWhen?.param ?? ''].some((input) => inputs.has(input));
      return counts && !isDriven ? [{ node: id, text: String(params[param]) }] : [];
    });
  });
}

function nodesOf(document: GraphDocument) {
  try {
    return flatten(document, nodeLibrary).nodes.values();
  } catch (error) {
    if (error instanceof DocumentError) return [];
    throw error;
  }
}
