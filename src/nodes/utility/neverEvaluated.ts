/** For structural types, which the engine removes before evaluation (graph/document/structuralTypes.ts). */
export function neverEvaluated(): never {
  throw new Error('groups and reroutes are removed before evaluation');
}
