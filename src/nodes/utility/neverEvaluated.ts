/** For structural types, which the engine removes before evaluation (graph/document/structuralTypes.ts). */
export function neverEvaluated(): never {
  throw new Error('the engine opens out groups and bends before it evaluates');
}
