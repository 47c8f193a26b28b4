export { applyCommand, type Command, CommandError, type Edit } from './commands.ts';
export {
  DocumentError,
  edgeKey,
  emptyDocument,
  type GraphDocument,
  type GraphEdge,
  type GraphNode,
  type ParamValue,
  parseDocument,
  readDocument,
  serializeDocument,
} from './document.ts';
export { CancelledError, type Evaluation, Evaluator, type NodeResult } from './evaluate.ts';
export { endGesture, execute, type History, newHistory, redo, undo } from './history.ts';
export { CURRENT_VERSION, migrate } from './migrations.ts';
export * from './nodeType.ts';
export { reaches, refuseEdge, validateDocument } from './validate.ts';
