import type { ComputeGpu } from '../../compute/computeDevice.ts';
import { runOnGpu } from '../../compute/runOnGpu.ts';
import { conservedQuantities } from '../../dynamics/energy.ts';
import { METHODS } from '../../dynamics/methods/library.ts';
import {
  type EarlyStop,
  integrate,
  type RunOptions,
  type RunTally,
  type SimulationFrame,
  stepSchedule,
} from '../../dynamics/run.ts';
import type { RunRecord } from '../../dynamics/runRecord.ts';
import { energyFaultMessage, summarizeRun } from '../../dynamics/runSummary.ts';
import { type State, SystemError, withPointName } from '../../dynamics/system.ts';
import type { TeamThreads } from '../../dynamics/threads/threadTeam.ts';
import { type LocalizedText, type Message, msg } from '../../messages/message.ts';
import type { Diagnostic } from '../../scene/types.ts';
import { toLoadedScene } from '../common/loadedScene.ts';
import { nodeRefusal } from '../common/params.ts';
import type { LoadedScene, Services } from '../services.ts';
import type { ProximityContact } from './forces.ts';
import type { Matter } from './matter.ts';
import { MotionRecorder, type RecordedMotion } from './motionRecorder.ts';
import { type BodyGroup, type SimulatedBody, type SimulationSetup, setUpSimulation } from './setup.ts';

/** How a simulation is computed. */
export interface SimulationSettings {
  /** Id of the integration method. */
  readonly method: string;
  /** [m/s] */
  readonly speedOfLight: number;
  /** Newtonian mechanics, as if c were infinite. */
  readonly newtonian: boolean;
  /** [s] */
  readonly duration: number;
  /** Recorded frames per second. */
  readonly rate: number;
  /** Maximum step [s]; 0: a tenth of the stability limit of an explicit method. */
  readonly step: number;
  /** Error tolerance per second, for adaptive steps [m, m/s]; 0: fixed steps. */
  readonly tolerance: number;
  /** Goes on while the energy grows because steps are too long. */
  readonly evenUnstable: boolean;
  /** On a GPU, in 32-bit floats. */
  readonly onGpu: boolean;
  readonly touch: ProximityContact;
}

/** Outputs of the node; `reel` is for resuming only. */
export interface SimulationOutputs {
  readonly geometry: LoadedScene;
  readonly books: RunRecord;
  readonly reel?: RecordedMotion;
}

/** Maximum of vertices × frames, at 36 bytes each. */
const MAX_SAMPLES = 10_000_000;
const MAX_FRAMES = 100_000;
const MAX_STEPS = 100_000_000;

/** A run, frame by frame, of the system that parts make together. */
export class Simulation {
  readonly runOptions: RunOptions;
  private readonly settings: SimulationSettings;
  private readonly node: string;
  private readonly recorder: MotionRecorder;
  private readonly bodyGroups: readonly BodyGroup[];
  private stop: EarlyStop | undefined;
  /** Whether the GPU is a software implementation. */
  private onSoftware = false;

  /** `before`: a recording to continue. Throws a NodeRefusal. */
  constructor(matter: readonly Matter[], settings: SimulationSettings, node: string, before?: RecordedMotion) {
    const c = settings.newtonian ? Number.POSITIVE_INFINITY : settings.speedOfLight;
    if (matter.every(({ kind }) => kind === 'field'))
      throw nodeRefusal(
        'simulate.nothing',
        node,
        msg`there is nothing to simulate; connect a Mass spring or a Collider`,
      );
    const setup = withSystemErrors(node, () => setUpSimulation(matter, c, settings.touch));
    this.settings = settings;
    this.node = node;
    this.runOptions = runOptionsFor(setup, settings, node);
    this.bodyGroups = setup.bodyGroups;
    this.recorder = new MotionRecorder(this.runOptions, setup.bodyGroups, before);
  }

  /** Number of frames of the complete run. */
  get frames(): number {
    return Math.round(this.runOptions.duration / this.runOptions.every) + 1;
  }

  /** Number of frames so far. */
  get recordedFrames(): number {
    return this.recorder.length;
  }

  /**
   * Computes further frames, one per iteration; `openGpu` opens the device if steps are to run on a GPU. Throws a
   * NodeRefusal if that fails.
   */
  async *run({
    openGpu,
    teamThreads,
  }: Pick<Services, 'openGpu' | 'teamThreads'>): AsyncGenerator<SimulationFrame, void> {
    if (this.recordedFrames === this.frames) return;
    let gpu: ComputeGpu | undefined;
    try {
      if (this.settings.onGpu) gpu = await openGpu();
      this.onSoftware = gpu?.software ?? false;
      yield* this.runRemaining(gpu?.device, teamThreads);
    } catch (error) {
      throw error instanceof SystemError ? gpuRefusal(this.node, error) : error;
    } finally {
      gpu?.release();
    }
  }

  private async *runRemaining(
    device: GPUDevice | undefined,
    threads: TeamThreads | undefined,
  ): AsyncGenerator<SimulationFrame, void> {
    const { runOptions: options, recorder } = this;
    const { length } = recorder;
    const { state: start, tally } = recorder.latest;
    const done = Math.max(1, length) - 1;
    const since = { t: options.start.t, frames: done, tally };
    const left = (this.frames - 1 - done) * options.every;
    const rest: RunOptions = {
      ...options,
      since,
      duration: left,
      start: { ...start, t: since.t + done * options.every },
      ...(threads && { threads }),
    };
    const running = device ? runOnGpu(device, rest) : integrate(rest);
    try {
      // The first frame is the one that it resumes from.
      if (length > 0) await running.next();
      for (;;) {
        const { done, value } = await running.next();
        if (done) {
          this.stop = value && withObjectName(value, this.bodyGroups);
          return;
        }
        recorder.addFrame(value);
        yield value;
      }
    } finally {
      await running.return(undefined);
    }
  }

  /** Adds a frame that was computed before. */
  addFrame(state: State, tally: RunTally): void {
    this.recorder.addFrame({ state, ...tally, quantities: conservedQuantities(this.runOptions.system, state) });
  }

  /** Outputs so far. */
  outputs(): SimulationOutputs {
    const { recorder, settings } = this;
    const record: RunRecord = { ...recorder.record(this.stop), ...(settings.onGpu && { onGpu: true }) };
    const scene = recorder.scene(this.notes(record), this.stop?.last);
    const hints = { ...scene.hints, speedOfLight: settings.speedOfLight };
    return {
      geometry: toLoadedScene({ ...scene, hints }),
      books: record,
      ...(recorder.length < this.frames && { reel: recorder.recordedMotion() }),
    };
  }

  private notes(record: RunRecord): Diagnostic[] {
    const { node, runOptions: options, onSoftware } = this;
    const { stop, corrected } = record;
    const { h, stable } = stepSchedule(options);
    const { fault } = summarizeRun(record);
    const notes: Diagnostic[] = [];
    const note = (code: string, param: string, message: Message, severity: 'warning' | 'info' = 'warning'): void =>
      void notes.push({ severity, code, place: param ? `${node}.${param}` : node, message });
    if (!stable) {
      const message = msg`steps of ${h.toPrecision(3)} s are too long for the method: perturbations may grow; set a shorter step, or 0`;
      note('simulate.unstable', 'step', message);
    }
    if (onSoftware) {
      const message = msg`the GPU here is a software implementation; without it the simulation is faster`;
      note('simulate.software', 'onGpu', message, 'info');
    }
    if (fault) note(`simulate.${fault.kind === 'gained' ? 'grows' : 'fades'}`, 'method', energyFaultMessage(fault));
    if (corrected === 0 && record.times.length > 1) {
      const message = msg`the correction changed no step: it only holds back steps that gain energy; the correction by the root conserves it`;
      note('simulate.uncorrected', 'correction', message);
    }
    if (stop) {
      const param = stop.reason === 'tolerance' ? 'tolerance' : '';
      note('simulate.stopped', param, msg`it ended at t = ${stop.t.toPrecision(4)} s: ${stop.message}`);
    }
    return notes;
  }
}

/** The reason why a run ended, with the affected object's name instead of a point index. */
function withObjectName(stop: EarlyStop, bodyGroups: readonly BodyGroup[]): EarlyStop {
  const { point } = stop;
  if (point === undefined) return stop;
  for (const body of bodyGroups.flatMap(({ bodies }) => bodies)) {
    const name = pointNameIn(body, point);
    if (name) return { ...stop, message: withPointName(stop.message, point, name) };
  }
  return stop;
}

/** Description of a point of a body; undefined if it is not one of its points. */
function pointNameIn(body: SimulatedBody, point: number): LocalizedText | undefined {
  switch (body.kind) {
    case 'net': {
      const vertex = body.pointOfVertex.indexOf(point);
      return vertex >= 0 ? msg`vertex ${vertex} of ${body.object.path}` : undefined;
    }
    case 'ball':
      return body.point === point ? body.object.path : undefined;
    case 'fixed':
      return body.points.includes(point) ? body.object.path : undefined;
    case 'rod':
      return undefined;
  }
}

/** Refuses what a GPU cannot do, with an alternative. */
const gpuRefusal = (node: string, { text }: SystemError): Error =>
  nodeRefusal('simulate.gpu', `${node}.onGpu`, msg`${text}; compute it on the processor`, {
    ...{ node, param: 'onGpu', value: false },
  });

/** Turns a SystemError into a refusal at the node. */
function withSystemErrors<T>(node: string, make: () => T): T {
  try {
    return make();
  } catch (error) {
    if (error instanceof SystemError) throw nodeRefusal('simulate.system', node, error.text);
    throw error;
  }
}

function runOptionsFor(
  { system, start, bodyGroups }: SimulationSetup,
  settings: SimulationSettings,
  node: string,
): RunOptions {
  const { duration, rate, step, tolerance, onGpu, evenUnstable } = settings;
  const frames = Math.max(1, Math.round(duration * rate));
  const set = (param: string, value: number) => ({ node, param, value });
  if (frames > MAX_FRAMES) {
    const message = msg`${frames} frames are more than ${MAX_FRAMES}; keep fewer a second, or let it end sooner`;
    throw nodeRefusal('simulate.frames', `${node}.rate`, message, set('duration', MAX_FRAMES / rate));
  }
  const vertices = bodyGroups
    .flatMap(({ bodies }) => bodies)
    .reduce((sum, body) => sum + (body.kind === 'net' ? body.pointOfVertex.length : 0), 0);
  if (vertices * frames > MAX_SAMPLES) {
    const message = msg`${vertices} vertices in ${frames} frames are more than ${MAX_SAMPLES} samples; keep fewer frames a second, let it end sooner, or take coarser meshes`;
    const most = Math.floor(MAX_SAMPLES / vertices / duration);
    throw nodeRefusal('simulate.samples', `${node}.rate`, message, most >= 1 ? set('rate', most) : undefined);
  }
  if (onGpu && tolerance > 0) {
    const message = msg`adaptive steps are not supported on the GPU; use fixed steps, with 0`;
    throw nodeRefusal('simulate.gpu', `${node}.tolerance`, message, set('tolerance', 0));
  }
  const options: RunOptions = {
    ...{ system, start, method: METHODS.get(settings.method)!, duration, every: duration / frames },
    ...(step > 0 && { step }),
    ...(tolerance > 0 && { tolerance }),
    ...(evenUnstable && { evenUnstable }),
  };
  const { h, perFrame } = stepSchedule(options);
  if (perFrame * frames > MAX_STEPS) {
    const message = msg`it would take ${(perFrame * frames).toExponential(1)} steps of ${h.toExponential(1)} s, more than ${MAX_STEPS}; set a longer step, take softer springs, or let it end sooner`;
    throw nodeRefusal('simulate.steps', `${node}.step`, message, set('step', duration / MAX_STEPS));
  }
  return options;
}
