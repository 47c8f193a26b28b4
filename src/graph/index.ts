export { applyCommand, type Command, CommandError, type Edit } from './commands.ts';
export { conversion } from './convert.ts';
export {
  DocumentError,
  edgeKey,
  emptyDocument,
  emptyGraph,
  type FileReference,
  type Frame,
  type Graph,
  type GraphDocument,
  type GraphEdge,
  type GraphNode,
  type Group,
  type GroupSocket,
  graphIn,
  type Note,
  type ParamValue,
} from './document.ts';
export { type Alignment, alignmentOf, distributionOf, type SizeOf } from './edits/arrange.ts';
export {
  copyOf,
  duplicateOf,
  type Fragment,
  type Paste,
  parseFragment,
  pasteOf,
  type Selection,
  serializeFragment,
} from './edits/fragment.ts';
export { type Grouping, groupingOf } from './edits/group.ts';
export { type NodePlace, placeOf } from './edits/place.ts';
export { type Ungrouping, ungroupingOf } from './edits/ungroup.ts';
export { CancelledError, type EvaluateOptions, type Evaluation, Evaluator, type EvaluatorOptions } from './evaluate.ts';
export { type Expression, type ExpressionContext, evaluateExpression } from './expression.ts';
export { filesIn, withFiles } from './files.ts';
export { type FlatGraph, type FlatNode, type FlatSource, flatten } from './flatten.ts';
export { type HeavyPort, type HeavyThread, heavyThreads, serveHeavy } from './heavy.ts';
export { endGesture, execute, type History, newHistory, redo, undo } from './history.ts';
export { type LevelTypes, typesIn } from './infer.ts';
export { CURRENT_VERSION, migrate } from './migrations.ts';
export * from './nodeType.ts';
export { parseDocument, readDocument } from './read.ts';
export type { NodeResult } from './results.ts';
export { serializeDocument } from './serialize.ts';
export { isShared, readShared, sharedFragment } from './share.ts';
export { inputName, inputSocket, type Level, levelOf, type Sockets, socketsOf } from './sockets.ts';
export * from './structure.ts';
export { reaches, refuseEdge, validateDocument } from './validate.ts';
