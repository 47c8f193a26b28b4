export { type ComputeGpu, openWebGpu } from './gpu.ts';
export { runOnGpu } from './run.ts';
