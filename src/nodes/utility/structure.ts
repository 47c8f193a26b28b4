/** What the engine itself takes out before anything is evaluated (graph/structure.ts). */
export function isNeverEvaluated(): never {
  throw new Error('the engine opens out groups and bends before it evaluates');
}
