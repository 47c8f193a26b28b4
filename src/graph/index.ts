export { conversion } from './analysis/conversion.ts';
export { type FlatGraph, type FlatNode, type FlatSource, flatten } from './analysis/flatten.ts';
export { inferTypes, type LevelTypes } from './analysis/inferTypes.ts';
export {
  type GraphLevel,
  inputName,
  inputSocket,
  levelOf,
  type NodeSockets,
  socketsOf,
} from './analysis/sockets.ts';
export { edgeError, isReachable, validateDocument } from './analysis/validate.ts';
export {
  DocumentError,
  edgeKey,
  emptyDocument,
  emptyGraph,
  type FileReference,
  type Graph,
  type GraphDocument,
  type GraphEdge,
  type GraphFrame,
  type GraphNode,
  type GraphNote,
  type GroupSocket,
  graphIn,
  type NodeGroup,
  type ParamValue,
} from './document/document.ts';
export { referencedFiles, renameFiles } from './document/fileReferences.ts';
export { CURRENT_VERSION, migrate } from './document/migrations.ts';
export { parseDocument, readDocument } from './document/parse.ts';
export { serializeDocument } from './document/serialize.ts';
export {
  decodeShareLink,
  encodeShareLink,
  isShareLink,
} from './document/shareLink.ts';
export * from './document/structuralTypes.ts';
export {
  type Alignment,
  alignCommand,
  distributeCommand,
  type SizeOf,
} from './edits/arrange.ts';
export { applyCommand, type Command, CommandError, type Edit } from './edits/commands.ts';
export {
  copyFragment,
  duplicateSelection,
  type Fragment,
  type GraphSelection,
  type Paste,
  parseFragment,
  pasteFragment,
  serializeFragment,
} from './edits/fragment.ts';
export { type Grouping, groupCommand } from './edits/group.ts';
export { endGesture, executeCommand, type History, newHistory, redo, undo } from './edits/history.ts';
export { locateNode, type NodeLocation } from './edits/locateNode.ts';
export { type Ungrouping, ungroupCommand } from './edits/ungroup.ts';
export {
  CancelledError,
  type EvaluateOptions,
  type Evaluation,
  Evaluator,
  type EvaluatorOptions,
} from './evaluation/evaluator.ts';
export {
  type HeavyPort,
  type HeavyWorker,
  heavyWorkerPool,
  serveHeavy,
} from './evaluation/heavyWorkers.ts';
export type { NodeResult } from './evaluation/resultCache.ts';
export { type ExpressionContext, type ExpressionResult, evaluateExpression } from './expression.ts';
export * from './nodeType.ts';
