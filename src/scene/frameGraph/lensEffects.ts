import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { isPanoramic, type Lens } from '../view/lenses/lenses.ts';
import { EFFECTS, type EffectId } from './effects.ts';
import type { FrameGraph } from './frameGraph.ts';

/** Throws a MessageError if a frame graph has an effect that is defined for perspective lenses only, and the picture's lens is another. */
export function assertLensEffects(lens: Lens, { passes, extraBuffers }: FrameGraph): void {
  if (!isPanoramic(lens)) return;
  for (const pass of passes) {
    if (pass.kind !== 'effect' || typeof pass.effect !== 'string') continue;
    // From outside, a camera with a perspective lens looks on.
    if (pass.buffer > 0 && extraBuffers[pass.buffer - 1]?.outside) continue;
    if (PERSPECTIVE_EFFECTS.has(pass.effect))
      throw new MessageError(
        msg`${EFFECTS[pass.effect].title} is of a perspective lens; leave it out, or choose that lens`,
      );
  }
}

/** They depend on the angle from an axis, or on distances along it. */
const PERSPECTIVE_EFFECTS: ReadonlySet<EffectId> = new Set(['depth-of-field', 'vignette', 'observer-marks']);
