import { type FrameSpacing, worldTimesOf } from '../../flight/spacing.ts';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { properTimeBetween } from '../../physics/worldLines/properTime.ts';
import { type ObserverSetup, observerWorldLine, ridesCamera } from '../../scene/view/observerPath.ts';
import type { FrameTime } from '../project/outputFiles.ts';

/**
 * Frames whose times are those of the world, or of the observer's own clock, at world times. The clock of one who rides a camera shows the world's time at world
 * time 0, of one who coasts at the first frame. Throws a MessageError if he has no clock of his own. c [m/s].
 */
export function spacedFrames(
  frames: readonly FrameTime[],
  spacing: FrameSpacing,
  setup: ObserverSetup,
  c: number,
): readonly FrameTime[] {
  if (spacing === 'world') return frames;
  const line = observerWorldLine(setup, c);
  if (!line)
    throw new MessageError(
      msg`frames in proper time need an observer who moves: let him ride a moving camera with its own velocity, or coast without staying in place`,
    );
  const setAt = ridesCamera(setup) ? 0 : frames[0]!.t;
  const elapsed = (from: number, to: number): number => properTimeBetween(line, from, to, c);
  const times = worldTimesOf(
    { setAt, elapsed },
    frames.map(({ t }) => t),
  );
  if (!times)
    throw new MessageError(msg`the observer's clock never shows ${frames.at(-1)!.t} s: he is as fast as light`);
  return frames.map((frame, i) => ({ ...frame, t: times[i]! }));
}
