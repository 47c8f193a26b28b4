/**
 * The browser globals that three's renderer needs, for Node. Import before `three/webgpu`.
 *
 * three advances its frame counter in requestAnimationFrame, and a pass renders once per frame: without `pumpFrame`
 * every frame would repeat the first.
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

/** Begins a new frame of three; call before each. */
export function pumpFrame(): void {
  const callback = pending;
  pending = undefined;
  callback?.(performance.now());
}
