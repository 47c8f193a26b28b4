import { type EarlyStop, MAX_ENERGY_GAIN, type RunOptions, type SimulationFrame, stepSchedule } from './run.ts';

/** What a run kept of its state from frame to frame, for plots and tables: plain data. World frame, SI units. */
export interface RunRecord {
  /** Id of the method. */
  readonly method: string;
  /** [m/s]; Infinity: Newton's mechanics. */
  readonly speedOfLight: number;
  /** A GPU took the steps, in 32-bit numbers. */
  readonly onGpu?: boolean;
  /** Something is led its way, and gives energy and takes it. */
  readonly led?: boolean;
  /** [s]; 0 where it adapts. */
  readonly step: number;
  /** Between frames [s]. */
  readonly pace: number;
  /** Of each frame [s]. */
  readonly times: Float64Array;
  /** Taken until each frame. */
  readonly steps: Float64Array;
  /** Of each frame [J]; as in `ConservedQuantities`. */
  readonly kinetic: Float64Array;
  readonly potential: Float64Array;
  readonly total: Float64Array;
  /** x, y, z of each frame [kg m/s]. */
  readonly momentum: Float64Array;
  /** x, y, z of each frame [kg m²/s]. */
  readonly angularMomentum: Float64Array;
  /** [m/s] */
  readonly fastest: Float64Array;
  /** Why it ended before its time. */
  readonly stop?: EarlyStop;
}

/** What a run comes to. */
export interface RunSummary {
  /** The largest change of the energy, in units of the largest kinetic energy; undefined where nothing moved. */
  readonly drift: number | undefined;
  /** [m/s] */
  readonly fastest: number;
  /** Of the last frame [s]. */
  readonly until: number;
  /** When more energy had come from nowhere than half of the largest kinetic energy until then [s]: nothing gives any here, so that it is the method's error. Absent: it never had. */
  readonly grown?: number;
}

/** What is slower than this does not move: rounding makes so much [m/s]. */
const MIN_SPEED = 1e-9;
/** Of energies, by rounding: of places in 32 bits too, which a GPU computes with. */
const ENERGY_ROUNDING = 1e-6;

export function summarizeRun({ total, kinetic, fastest, times, led }: RunRecord): RunSummary {
  const top = maxMagnitude(fastest);
  const until = times.at(-1) ?? 0;
  const most = maxMagnitude(kinetic);
  if (top < MIN_SPEED || most === 0) return { drift: undefined, fastest: top, until };
  const drift = maxMagnitude(total.map((energy) => energy - total[0])) / most;
  const frame = led ? -1 : firstGrowth(total, kinetic);
  return { drift, fastest: top, until, ...(frame >= 0 && { grown: times[frame] }) };
}

/** The first frame at which the energy is above its lowest so far by more than it can swing; −1: none. */
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

/** Keeps the books of a run: each of its frames is entered once. */
export class RunRecorder {
  private readonly order: RunOptions;
  private readonly rows: RunRecordRow[] = [];

  constructor(order: RunOptions) {
    this.order = order;
  }

  addFrame({ state, quantities, steps }: SimulationFrame): void {
    this.rows.push({ t: state.t, steps, ...quantities });
  }

  /** The books so far. */
  record(stop?: EarlyStop): RunRecord {
    const { rows, order } = this;
    const column = (of: (row: RunRecordRow) => number): Float64Array => Float64Array.from(rows, of);
    return {
      method: order.method.id,
      speedOfLight: order.system.c,
      ...(order.system.led && { led: true }),
      step: order.tolerance === undefined ? stepSchedule(order).h : 0,
      pace: order.every,
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

/** The books as a table of comma-separated values: a head with units, and a row for each frame, in full precision. */
export function runRecordCsv(books: RunRecord): string {
  const { times, steps, kinetic, potential, total, momentum, angularMomentum, fastest } = books;
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
