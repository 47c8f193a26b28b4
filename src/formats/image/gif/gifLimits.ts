import { type Message, msg } from '../../../messages/message.ts';

/** Programs show frames of less than 2 hundredths of a second for 10 instead. */
export const MAX_GIF_RATE = 50;
/** The longest frame is 65,535 hundredths of a second. */
export const MIN_GIF_RATE = 1 / 655;
/** Along a side [px]. */
export const MAX_GIF_SIDE = 4096;

/** Why a film cannot be a GIF; undefined if it can. `fps`: frames per second. */
export function gifProblem({ width, height }: { width: number; height: number }, fps: number): Message | undefined {
  if (!(fps <= MAX_GIF_RATE && fps >= MIN_GIF_RATE))
    return msg`a .gif has between one frame in 655 s and ${MAX_GIF_RATE} a second, not ${fps}; choose another rate, or write an .mp4`;
  if (Math.max(width, height) > MAX_GIF_SIDE)
    return msg`a .gif of ${width} × ${height} pixels is too large; write at most ${MAX_GIF_SIDE} along a side, or an .mp4`;
  return undefined;
}
