export { type ComputeGpu, openWebGpu } from './computeDevice.ts';
export { runOnGpu } from './runOnGpu.ts';
