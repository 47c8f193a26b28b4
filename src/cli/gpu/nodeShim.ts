/**
 * What three's renderer expects of a browser, for Node. Import before `three/webgpu`.
 *
 * three advances its frame counter in requestAnimationFrame, and a pass renders once per frame: without the pump every
 * frame would repeat the first.
 */
let pending: FrameRequestCallback | undefined;

Object.assign(globalThis, {
  self: globalThis,
  requestAnimationFrame: (callback: FrameRequestCallback): number => {
    pending = callback;
    return 1;
  },
  cancelAnimationFrame: (): void => {
    pending = undefined;
  },
});

/** Lets three begin a new frame. Call once before each. */
export function pumpFrame(): void {
  const callback = pending;
  pending = undefined;
  callback?.(performance.now());
}
