/**
 * Dynamics on a GPU, by WebGPU.
 *
 * @module slowlight/compute
 */

export { type ComputeGpu, openWebGpu } from './computeDevice.ts';
export { runOnGpu } from './runOnGpu.ts';
