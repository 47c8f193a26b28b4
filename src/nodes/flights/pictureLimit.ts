import { type FlightState, MAX_PICTURE_GAMMA } from '../../flight/flightState.ts';
import { msg } from '../../messages/message.ts';

/** Whether the picture is that of a slower observer at the same event (`pictureVelocity`). */
export const isFasterThanPictures = ({ velocity }: Pick<FlightState, 'velocity'>): boolean =>
  velocity.rapidity > Math.acosh(MAX_PICTURE_GAMMA);

export const FASTER_THAN_PICTURES = msg`The flight is faster than pictures can show: they are drawn as at γ = ${MAX_PICTURE_GAMMA}. Place and clocks go on exactly.`;
