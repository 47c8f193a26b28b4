/** What the engine itself takes out before anything is evaluated (graph/document/structuralTypes.ts). */
export function neverEvaluated(): never {
  throw new Error('the engine opens out groups and bends before it evaluates');
}
