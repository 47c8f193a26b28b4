export { runOnGpu } from './run.ts';
