import { type EarlyStop, type RunOptions, type RunTally, type SimulationFrame, stepSchedule } from './run.ts';

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
  /** Energy that drag has taken until each frame [J]; absent: not known, because drag acted on a GPU. */
  readonly dragLoss?: Float64Array;
  /** Number of steps that the method's energy correction changed; absent: it has none. */
  readonly corrected?: number;
  /** x, y, z per frame [kg m/s]. */
  readonly momentum: Float64Array;
  /** x, y, z per frame [kg m²/s]. */
  readonly angularMomentum: Float64Array;
  /** Maximum speed [m/s]. */
  readonly fastest: Float64Array;
  /** Why it ended early. */
  readonly stop?: Omit<EarlyStop, 'last'>;
}

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
  addFrame({ state, quantities, ...tally }: SimulationFrame): void {
    this.rows.push({ t: state.t, ...tally, ...quantities });
  }

  /** The record so far. */
  record(stop?: EarlyStop): RunRecord {
    const { rows, order: options } = this;
    const column = (of: (row: RunRecordRow) => number): Float64Array => Float64Array.from(rows, of);
    const corrected = rows.at(-1)?.corrected;
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
      ...(rows.every(({ dragLoss }) => dragLoss !== undefined) && { dragLoss: column(({ dragLoss }) => dragLoss!) }),
      ...(corrected !== undefined && { corrected }),
      momentum: Float64Array.from(rows.flatMap(({ momentum }) => [...momentum])),
      angularMomentum: Float64Array.from(rows.flatMap(({ angularMomentum }) => [...angularMomentum])),
      fastest: column(({ fastest }) => fastest),
      ...(stop && { stop: toldStop(stop) }),
    };
  }
}

/** Without the state, which is no part of a table. */
const toldStop = ({ last: _, ...told }: EarlyStop): NonNullable<RunRecord['stop']> => told;

type RunRecordRow = SimulationFrame['quantities'] & RunTally & { readonly t: number };

const CSV_HEADER =
  'time [s],steps,kinetic energy [J],potential energy [J],total energy [J],px [kg m/s],py [kg m/s],pz [kg m/s],Lx [kg m²/s],Ly [kg m²/s],Lz [kg m²/s],fastest [m/s],energy taken by drag [J]';

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
  const { times, steps, kinetic, potential, total, momentum, angularMomentum, fastest, dragLoss } = record;
  const rows = Array.from(times, (t, i) => [
    t,
    steps[i],
    kinetic[i],
    potential[i],
    total[i],
    ...momentum.subarray(3 * i, 3 * i + 3),
    ...angularMomentum.subarray(3 * i, 3 * i + 3),
    fastest[i],
    dragLoss?.[i] ?? '',
  ]);
  return `${[CSV_HEADER, ...rows.map((row) => row.join(','))].join('\n')}\n`;
}
