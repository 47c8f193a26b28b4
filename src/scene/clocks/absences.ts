import { type Message, msg } from '../../messages/message.ts';
import type { ClockAbsence } from './readClock.ts';

/** For people: why a clock shows nothing. */
export const CLOCK_ABSENCES: Readonly<Record<ClockAbsence, Message>> = {
  unborn: msg`not yet there`,
  ended: msg`no longer there`,
  hidden: msg`behind a horizon`,
};
