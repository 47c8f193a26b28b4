import type { Vec4 } from '../../shaders/types.ts';
import type { Frame } from './frame.ts';

/** A pass on the way to the result. */
export interface Step {
  /** By which later steps read it. */
  readonly name: string;
  /** It makes a picture that is so many times smaller, rounded up. */
  readonly shrink: number;
  readonly color: (frame: Frame) => Vec4;
}

/** An effect as the GPU does it: the last step gives the result, as large as the picture. */
export type Effect = readonly [...Step[], Step];

export const inOneStep = (color: Step['color']): Effect => [{ name: 'result', shrink: 1, color }];
