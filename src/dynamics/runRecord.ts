import { type EarlyStop, MAX_ENERGY_GAIN, type RunOptions, type SimulationFrame, stepSchedule } from './run.ts';

/** Record of a run for plots and tables, frame by frame, as plain data. World frame, SI units. */
export interface RunRecord {
  /** Id of the integration method. */
  readonly method: string;
  /** [m/s]; Infinity: Newtonian mechanics. */
  readonly speedOfLight: number;
  /** Whether steps were taken on a GPU, in 32-bit floats. */
  readonly onGpu?: boolean;
  /** Whether there are kinematic points, which add and remove energy. */
  readonly hasKinematic?: boolean;
  /** [s]; 0 for adaptive steps. */
  readonly step: number;
  /** Interval of frames [s]. */
  readonly pace: number;
  /** Time of each frame [s]. */
  readonly times: Float64Array;
  /** Total steps at each frame. */
  readonly steps: Float64Array;
  /** Per frame [J]; as in `ConservedQuantities`. */
  readonly kinetic: Float64Array;
  /** Per frame [J]; as in `ConservedQuantities`. */
  readonly potential: Float64Array;
  /** Per frame [J]; as in `ConservedQuantities`. */
  readonly total: Float64Array;
  /** x, y, z per frame [kg m/s]. */
  readonly momentum: Float64Array;
  /** x, y, z per frame [kg m²/s]. */
  readonly angularMomentum: Float64Array;
  /** Maximum speed [m/s]. */
  readonly fastest: Float64Array;
  /** Why it ended early. */
  readonly stop?: EarlyStop;
}

/** Summary of a run. */
export interface RunSummary {
  /** Largest change of the energy relative to the largest kinetic energy; undefined if nothing moved. */
  readonly drift: number | undefined;
  /** [m/s] */
  readonly fastest: number;
  /** Time of the last frame [s]. */
  readonly until: number;
  /**
   * Time at which the energy had grown by more than half of the largest kinetic energy until then [s]: without energy
   * sources this is the method's error. Absent: never.
   */
  readonly grown?: number;
}

/** Slower motion is rounding error [m/s]. */
const MIN_SPEED = 1e-9;
/** Relative rounding error of energies, including the 32-bit positions of a GPU. */
const ENERGY_ROUNDING = 1e-6;

export function summarizeRun({ total, kinetic, fastest, times, hasKinematic }: RunRecord): RunSummary {
  const top = maxMagnitude(fastest);
  const until = times.at(-1) ?? 0;
  const most = maxMagnitude(kinetic);
  if (top < MIN_SPEED || most === 0) return { drift: undefined, fastest: top, until };
  const drift = maxMagnitude(total.map((energy) => energy - total[0])) / most;
  const frame = hasKinematic ? -1 : firstGrowth(total, kinetic);
  return { drift, fastest: top, until, ...(frame >= 0 && { grown: times[frame] }) };
}

/** First frame with an energy above its minimum so far by more than an oscillation; −1: none. */
function firstGrowth(total: Float64Array, kinetic: Float64Array): number {
  let [lowest, most] = [Number.POSITIVE_INFINITY, 0];
  return total.findIndex((energy, k) => {
    lowest = Math.min(lowest, energy);
    most = Math.max(most, kinetic[k]);
    return energy - lowest > MAX_ENERGY_GAIN * most + ENERGY_ROUNDING * (Math.abs(energy) + Math.abs(lowest));
  });
}

const maxMagnitude = (values: Float64Array): number =>
  values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);

/**
 * Records a run; call once per frame.
 * @example
 * const masses = Float64Array.of(1);
 * const system = makeSystem({ masses, forces: [uniformField(masses, [0, -9.81, 0])] });
 * const start = stateAtRest(Float64Array.of(0, 10, 0));
 * const options = { system, start, method: METHODS.get('leapfrog')!, duration: 1, every: 0.5 };
 * const recorder = new RunRecorder(options);
 * for (const frame of integrate(options)) recorder.addFrame(frame);
 * recorder.record().times; // [0, 0.5, 1] s
 */
export class RunRecorder {
  private readonly order: RunOptions;
  private readonly rows: RunRecordRow[] = [];

  constructor(options: RunOptions) {
    this.order = options;
  }

  /** Adds a row. */
  addFrame({ state, quantities, steps }: SimulationFrame): void {
    this.rows.push({ t: state.t, steps, ...quantities });
  }

  /** The record so far. */
  record(stop?: EarlyStop): RunRecord {
    const { rows, order: options } = this;
    const column = (of: (row: RunRecordRow) => number): Float64Array => Float64Array.from(rows, of);
    return {
      method: options.method.id,
      speedOfLight: options.system.c,
      ...(options.system.kinematic && { hasKinematic: true }),
      step: options.tolerance === undefined ? stepSchedule(options).h : 0,
      pace: options.every,
      times: column(({ t }) => t),
      steps: column(({ steps }) => steps),
      kinetic: column(({ kinetic }) => kinetic),
      potential: column(({ potential }) => potential),
      total: column(({ total }) => total),
      momentum: Float64Array.from(rows.flatMap(({ momentum }) => [...momentum])),
      angularMomentum: Float64Array.from(rows.flatMap(({ angularMomentum }) => [...angularMomentum])),
      fastest: column(({ fastest }) => fastest),
      ...(stop && { stop }),
    };
  }
}

type RunRecordRow = SimulationFrame['quantities'] & { readonly t: number; readonly steps: number };

const CSV_HEADER =
  'time [s],steps,kinetic energy [J],potential energy [J],total energy [J],px [kg m/s],py [kg m/s],pz [kg m/s],Lx [kg m²/s],Ly [kg m²/s],Lz [kg m²/s],fastest [m/s]';

/**
 * The record as a CSV table: a header with units and a row per frame, in full precision.
 * @example
 * const masses = Float64Array.of(1);
 * const options = {
 *   system: makeSystem({ masses }),
 *   start: stateAtRest(new Float64Array(3)),
 *   method: METHODS.get('leapfrog')!,
 *   duration: 1,
 *   every: 1,
 * };
 * const recorder = new RunRecorder(options);
 * for (const frame of integrate(options)) recorder.addFrame(frame);
 * runRecordCsv(recorder.record()).split('\n').length; // 4: a header, two frames, an empty end
 */
export function runRecordCsv(record: RunRecord): string {
  const { times, steps, kinetic, potential, total, momentum, angularMomentum, fastest } = record;
  const rows = Array.from(times, (t, i) => [
    t,
    steps[i],
    kinetic[i],
    potential[i],
    total[i],
    ...momentum.subarray(3 * i, 3 * i + 3),
    ...angularMomentum.subarray(3 * i, 3 * i + 3),
    fastest[i],
  ]);
  return `${[CSV_HEADER, ...rows.map((row) => row.join(','))].join('\n')}\n`;
}
