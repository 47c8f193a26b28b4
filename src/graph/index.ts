/**
 * The document of a project: nodes and edges, their edits, and the evaluation of what they describe. `slowlight/nodes`
 * has the nodes themselves.
 *
 * @module slowlight/graph
 */

export { validateDocument } from './analysis/validate.ts';
export {
  DocumentError,
  type EventMark,
  emptyDocument,
  type FileReference,
  type Graph,
  type GraphDocument,
  type GraphEdge,
  type GraphFrame,
  type GraphNode,
  type GraphNote,
  type GroupSocket,
  type NodeGroup,
  type ParamValue,
} from './document/document.ts';
export { referencedFiles } from './document/fileReferences.ts';
export { parseDocument, readDocument } from './document/parse.ts';
export { serializeDocument } from './document/serialize.ts';
export { decodeShareLink, encodeShareLink } from './document/shareLink.ts';
export { applyCommand, type CanvasPoint, type Command, CommandError, type Edit } from './edits/commands.ts';
export {
  CancelledError,
  type EvaluateOptions,
  type Evaluation,
  Evaluator,
  type EvaluatorOptions,
  type HeavyRequest,
  type RunHeavy,
} from './evaluation/evaluator.ts';
export type { NodeResult } from './evaluation/resultCache.ts';
export { type ExpressionContext, type ExpressionResult, evaluateExpression } from './expression.ts';
export {
  type AbortSignalLike,
  type BooleanParam,
  type ChoiceParam,
  type ColorParam,
  type EvaluationContext,
  type ListParam,
  type NodeCategory,
  type NodeProblem,
  NodeRefusal,
  type NodeType,
  type NumberParam,
  type NumberVariant,
  type Outputs,
  type ParamSpec,
  type ProgressCallback,
  type Registry,
  type ReportInterim,
  type Socket,
  type TextParam,
  type VectorParam,
  valueError,
} from './nodeType.ts';
