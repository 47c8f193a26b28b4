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
export { CancelledError, type EvaluateOptions, type Evaluation, Evaluator, type EvaluatorOptions } from './evaluate.ts';
export { type FlatGraph, type FlatNode, type FlatSource, flatten } from './flatten.ts';
export { endGesture, execute, type History, newHistory, redo, undo } from './history.ts';
export { type LevelTypes, typesIn } from './infer.ts';
export { CURRENT_VERSION, migrate } from './migrations.ts';
export * from './nodeType.ts';
export { parseDocument, readDocument } from './read.ts';
export type { NodeResult } from './results.ts';
export { serializeDocument } from './serialize.ts';
export { inputName, inputSocket, type Level, levelOf, type Sockets, socketsOf } from './sockets.ts';
export * from './structure.ts';
export { reaches, refuseEdge, validateDocument } from './validate.ts';
