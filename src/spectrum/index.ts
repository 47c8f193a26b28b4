export { dopplerTint } from './dopplerTint.ts';
export { toneMap } from './toneMap.ts';
