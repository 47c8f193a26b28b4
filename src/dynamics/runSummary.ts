import { type Message, msg } from '../messages/message.ts';
import { MAX_ENERGY_GAIN } from './energy.ts';
import type { RunRecord } from './runRecord.ts';

/** Summary of a run. */
export interface RunSummary {
  /** Largest change of the energy relative to the largest kinetic energy, whatever its cause; undefined if nothing moved. */
  readonly change: number | undefined;
  /**
   * The same of the energy together with what drag has taken: the error of the method. Undefined if nothing moved, or if
   * it cannot be told from what kinematic points, or drag on a GPU, gave or took.
   */
  readonly drift: number | undefined;
  /** Energy that drag has taken in all [J]; undefined: not known. */
  readonly dragLoss: number | undefined;
  /** [m/s] */
  readonly fastest: number;
  /** Time of the last frame [s]. */
  readonly until: number;
  /** How the energy went wrong. Absent: it did not, or that cannot be told. */
  readonly fault?: EnergyFault;
}

/** Energy that the method has added or lost. */
export interface EnergyFault {
  readonly kind: 'gained' | 'lost';
  /** From when on [s]. */
  readonly t: number;
  /** The largest gain or loss from then on, relative to the largest kinetic energy. */
  readonly share: number;
}

/**
 * What an energy fault means and what to do about it.
 * @example
 * inEnglish(energyFaultMessage({ kind: 'lost', t: 2, share: 0.1 }));
 */
export function energyFaultMessage({ kind, t, share }: EnergyFault): Message {
  const [time, percent] = [t.toPrecision(4), Number((100 * share).toPrecision(2))];
  return kind === 'gained'
    ? msg`from t = ${time} s on there is energy without a source, up to ${percent} % of the largest kinetic energy: an error of the method; set a shorter step, or another method`
    : msg`from t = ${time} s on energy is missing that nothing took, up to ${percent} % of the largest kinetic energy: an error of the method; set a shorter step, or another method`;
}

/** Slower motion is rounding error [m/s]. */
const MIN_SPEED = 1e-9;
/** Relative rounding error of energies, including the 32-bit positions of a GPU. */
const ENERGY_ROUNDING = 1e-6;
/** A lasting change of the energy relative to the largest kinetic energy that is a fault; less may be an oscillation. */
const LASTING_CHANGE = 0.05;

export function summarizeRun(record: RunRecord): RunSummary {
  const { total, kinetic, fastest, times, dragLoss, hasKinematic } = record;
  const top = maxMagnitude(fastest);
  const most = maxMagnitude(kinetic);
  const rest = { fastest: top, until: times.at(-1) ?? 0, dragLoss: dragLoss?.at(-1) };
  if (top < MIN_SPEED || most === 0) return { change: undefined, drift: undefined, ...rest };
  const change = maxMagnitude(total.map((energy) => energy - total[0])) / most;
  if (hasKinematic) return { change, drift: undefined, ...rest };
  const whole = dragLoss ? total.map((energy, k) => energy + dragLoss[k]) : total;
  const fault = strongGain(whole, record, most) ?? (dragLoss && lastingChange(whole, record, most));
  const drift = dragLoss && maxMagnitude(whole.map((energy) => energy - whole[0])) / most;
  return { change, drift, ...rest, ...(fault && { fault }) };
}

/** From the first frame on with an energy above its minimum so far by more than an oscillation. */
function strongGain(energy: Float64Array, { kinetic, times }: RunRecord, scale: number): EnergyFault | undefined {
  let [lowest, most] = [Number.POSITIVE_INFINITY, 0];
  const first = energy.findIndex((value, k) => {
    lowest = Math.min(lowest, value);
    most = Math.max(most, kinetic[k]);
    return value - lowest > MAX_ENERGY_GAIN * most + ENERGY_ROUNDING * (Math.abs(value) + Math.abs(lowest));
  });
  if (first < 0) return undefined;
  return {
    kind: 'gained',
    t: times[first],
    share: (energy.subarray(first).reduce((top, value) => Math.max(top, value)) - lowest) / scale,
  };
}

/** From the first frame on from which the energy stays above, or below, its first value by more than an oscillation. */
function lastingChange(energy: Float64Array, { times }: RunRecord, scale: number): EnergyFault | undefined {
  const sign = Math.sign(energy[energy.length - 1] - energy[0]);
  const gains = energy.map((value) => sign * (value - energy[0]));
  const calm = gains.findLastIndex(
    (gain, k) => !(gain > LASTING_CHANGE * scale + ENERGY_ROUNDING * (Math.abs(energy[k]) + Math.abs(energy[0]))),
  );
  if (calm === gains.length - 1) return undefined;
  return {
    kind: sign > 0 ? 'gained' : 'lost',
    t: times[calm + 1],
    share: maxMagnitude(gains.subarray(calm + 1)) / scale,
  };
}

const maxMagnitude = (values: Float64Array): number =>
  values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
