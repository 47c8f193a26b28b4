import { degrees } from '../../math/angle.ts';
import { length } from '../../math/vec3.ts';
import { type Message, msg, type Translate } from '../../messages/message.ts';
import type { Inspection } from '../../scene/inspection/inspectEvent.ts';
import type { MeasuredLengths } from '../../scene/inspection/measureLengths.ts';
import { formatBeta, formatLength, formatNumber, formatSeconds } from '../format.ts';

/** A figure with its name. */
export interface FigureRow {
  readonly title: Message;
  readonly value: string;
}

const inDegrees = (angle: number): string => `${formatNumber(degrees(angle))}°`;
const speed = (beta: number): string => `${formatBeta(beta)} c`;
/** Apparent speeds have no bound. */
const apparentSpeed = (beta: number): string => `${formatNumber(beta)} c`;

/** The figures of an inspected point. `now`: the observer's world time [s]. */
export function inspectionRows(found: Inspection, now: number, t: Translate): readonly FigureRow[] {
  const ago = formatSeconds(now - found.emissionTime);
  const radial = Math.abs(found.apparentRadialSpeed);
  return [
    { title: msg`Light left`, value: t(msg`${formatSeconds(found.emissionTime)}, ${ago} ago`) },
    ...(found.properTime === undefined
      ? []
      : [{ title: msg`Its own clock then`, value: formatSeconds(found.properTime) }]),
    { title: msg`Distance then`, value: formatLength(found.distanceThen) },
    {
      title: msg`Distance now`,
      value: found.distanceNow === undefined ? t(msg`unknown`) : formatLength(found.distanceNow),
    },
    { title: msg`Velocity`, value: speed(length(found.velocity)) },
    { title: msg`Relative to you`, value: speed(length(found.relativeVelocity)) },
    { title: msg`Doppler factor D`, value: formatNumber(found.doppler) },
    { title: msg`Seems to move across`, value: apparentSpeed(found.apparentSpeedAcross) },
    {
      title: found.apparentRadialSpeed < 0 ? msg`Seems to approach` : msg`Seems to recede`,
      value: apparentSpeed(radial),
    },
    { title: msg`Looks turned by`, value: inDegrees(found.rotation) },
  ];
}

/** One sentence for screen readers. */
export const inspectionSentence = (path: string, found: Inspection, t: Translate): string =>
  t(
    msg`${path}: ${formatLength(found.distanceThen)} away when its light left, ${speed(length(found.relativeVelocity))} relative to you, D = ${formatNumber(found.doppler)}, looks turned by ${inDegrees(found.rotation)}`,
  );

/** The lengths between two measured points. */
export const lengthRows = (lengths: MeasuredLengths): readonly FigureRow[] => [
  { title: msg`Apparent length`, value: `${formatLength(lengths.apparent)} · ${inDegrees(lengths.angle)}` },
  { title: msg`Length at your moment`, value: formatLength(lengths.slice) },
  { title: msg`Rest length`, value: formatLength(lengths.rest) },
];
