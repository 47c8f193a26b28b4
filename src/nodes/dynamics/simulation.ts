import type { ComputeGpu } from '../../compute/gpu.ts';
import { runOnGpu } from '../../compute/run.ts';
import { type Books, figuresOf } from '../../dynamics/books.ts';
import { ledger } from '../../dynamics/energy.ts';
import { METHODS } from '../../dynamics/methods/library.ts';
import { type Frame, type Order, run, type Stop, stepsOf } from '../../dynamics/run.ts';
import { pointName, type State, SystemError } from '../../dynamics/system.ts';
import type { Diagnostic } from '../../scene/types.ts';
import { refusal } from '../geometry/shared.ts';
import { surveyed } from '../geometry/surveyed.ts';
import type { LoadedScene, Services } from '../services.ts';
import type { Touch } from './acting.ts';
import { Film, type Reel } from './film.ts';
import type { Matter } from './matter.ts';
import { type Actor, type Cast, type Stage, stageOf } from './stage.ts';

/** How a simulation is to be computed. */
export interface Settings {
  /** Id of the method. */
  readonly method: string;
  /** [m/s] */
  readonly speedOfLight: number;
  /** By Newton's mechanics, as if c were infinite. */
  readonly newtonian: boolean;
  /** [s] */
  readonly duration: number;
  /** Frames that are kept of a second. */
  readonly rate: number;
  /** The longest step [s]; 0: a tenth of what an explicit method can take. */
  readonly step: number;
  /** What steps may get wrong in each second, which they then follow [m, m/s]; 0: they are all alike. */
  readonly tolerance: number;
  /** By a GPU, in 32-bit numbers. */
  readonly onGpu: boolean;
  readonly touch: Touch;
}

/** What the node gives; under `reel` what only itself needs, to go on. */
export interface Simulated {
  readonly geometry: LoadedScene;
  readonly books: Books;
  readonly reel?: Reel;
}

/** Most vertices times frames that are kept: at 36 bytes each. */
const MOST_SAMPLES = 10_000_000;
const MOST_FRAMES = 100_000;
const MOST_STEPS = 100_000_000;

/** A run from frame to frame, of what parts make together. */
export class Simulation {
  readonly order: Order;
  private readonly settings: Settings;
  private readonly node: string;
  private readonly film: Film;
  private readonly casts: readonly Cast[];
  private stop: Stop | undefined;
  /** The GPU is a program on the processor. */
  private onSoftware = false;

  /** `before`: goes on from there. Throws a NodeRefusal. */
  constructor(matter: readonly Matter[], settings: Settings, node: string, before?: Reel) {
    const c = settings.newtonian ? Number.POSITIVE_INFINITY : settings.speedOfLight;
    if (matter.every(({ kind }) => kind === 'field'))
      throw refusal('simulate.nothing', node, 'nothing is there to move; connect a Mass spring or a Collider');
    const stage = refusing(node, () => stageOf(matter, c, settings.touch));
    this.settings = settings;
    this.node = node;
    this.order = orderOf(stage, settings, node);
    this.casts = stage.casts;
    this.film = new Film(this.order, stage.casts, before);
  }

  /** Frames that there will be. */
  get frames(): number {
    return Math.round(this.order.duration / this.order.every) + 1;
  }

  /** Frames that there are. */
  get taken(): number {
    return this.film.length;
  }

  /** Takes further frames, one each time it is asked; `openGpu`: what takes the steps, where a GPU is to. Throws a NodeRefusal where it cannot. */
  async *run(openGpu: Services['openGpu']): AsyncGenerator<Frame, void> {
    if (this.taken === this.frames) return;
    let gpu: ComputeGpu | undefined;
    try {
      if (this.settings.onGpu) gpu = await openGpu();
      this.onSoftware = gpu?.software ?? false;
      yield* this.follow(gpu?.device);
    } catch (error) {
      throw error instanceof SystemError ? gpuRefusal(this.node, error) : error;
    } finally {
      gpu?.release();
    }
  }

  private async *follow(device: GPUDevice | undefined): AsyncGenerator<Frame, void> {
    const { order, film } = this;
    const { length } = film;
    const { state: start, steps } = film.latest;
    const known = Math.max(1, length) - 1;
    const since = { t: order.start.t, frames: known };
    const left = (this.frames - 1 - known) * order.every;
    const rest: Order = { ...order, since, duration: left, start: { ...start, t: since.t + known * order.every } };
    const running = device ? runOnGpu(device, rest) : run(rest);
    try {
      // The first frame is the one that it goes on from.
      if (length > 0) await running.next();
      for (;;) {
        const { done, value } = await running.next();
        if (done) {
          this.stop = value && named(value, this.casts);
          return;
        }
        const frame = { ...value, steps: steps + value.steps };
        film.take(frame);
        yield frame;
      }
    } finally {
      await running.return(undefined);
    }
  }

  /** Enters a frame that was computed before. */
  enter(state: State, steps: number): void {
    this.film.take({ state, steps, ledger: ledger(this.order.system, state) });
  }

  /** All there is so far. */
  outputs(): Simulated {
    const { film, settings } = this;
    const books: Books = { ...film.accounts(this.stop), ...(settings.onGpu && { onGpu: true }) };
    const whole = film.scene(this.notes(books));
    const hints = { ...whole.hints, speedOfLight: settings.speedOfLight };
    return {
      geometry: surveyed({ ...whole, hints }),
      books,
      ...(film.length < this.frames && { reel: film.reel() }),
    };
  }

  private notes(books: Books): Diagnostic[] {
    const { node, order, onSoftware } = this;
    const { stop } = books;
    const { h, stable } = stepsOf(order);
    const { grown } = figuresOf(books);
    const notes: Diagnostic[] = [];
    const note = (code: string, param: string, message: string, severity: 'warning' | 'info' = 'warning'): void =>
      void notes.push({ severity, code, place: param ? `${node}.${param}` : node, message });
    if (!stable) {
      const message = `steps of ${h.toPrecision(3)} s are too long for ${order.method.id}: what is small may grow in each; set a shorter step, or 0`;
      note('simulate.unstable', 'step', message);
    }
    if (onSoftware) {
      const message = 'the GPU here is a program on the processor; without it the simulation takes less time';
      note('simulate.software', 'onGpu', message, 'info');
    }
    if (grown !== undefined) {
      const message = `by t = ${grown.toPrecision(4)} s more energy had come from nowhere than half of what moves has: the error of ${order.method.id}; set a shorter step, or another method`;
      note('simulate.grows', 'method', message);
    }
    if (stop) {
      const param = stop.reason === 'tolerance' ? 'tolerance' : '';
      note('simulate.stopped', param, `it ended at t = ${stop.t.toPrecision(4)} s: ${stop.message}`);
    }
    return notes;
  }
}

/** Why a run ended, with the thing that it happened to instead of the number of a point. */
function named(stop: Stop, casts: readonly Cast[]): Stop {
  const { point } = stop;
  if (point === undefined) return stop;
  for (const actor of casts.flatMap(({ actors }) => actors)) {
    const name = nameIn(actor, point);
    if (name) return { ...stop, message: stop.message.replace(pointName(point), name) };
  }
  return stop;
}

/** What a point is of an actor; undefined where it is of none of its things. */
function nameIn(actor: Actor, point: number): string | undefined {
  switch (actor.kind) {
    case 'net': {
      const vertex = actor.pointOfVertex.indexOf(point);
      return vertex >= 0 ? `vertex ${vertex} of ${actor.object.path}` : undefined;
    }
    case 'ball':
      return actor.point === point ? actor.object.path : undefined;
    case 'fixed':
      return actor.points.includes(point) ? actor.object.path : undefined;
    case 'rod':
      return undefined;
  }
}

/** What a GPU cannot do is refused with the way round it. */
const gpuRefusal = (node: string, { message }: SystemError): Error =>
  refusal('simulate.gpu', `${node}.onGpu`, `${message}; compute it on the processor`, {
    ...{ node, param: 'onGpu', value: false },
  });

/** What cannot be a system is refused at the node. */
function refusing<T>(node: string, make: () => T): T {
  try {
    return make();
  } catch (error) {
    if (error instanceof SystemError) throw refusal('simulate.system', node, error.message);
    throw error;
  }
}

function orderOf({ system, start, casts }: Stage, settings: Settings, node: string): Order {
  const { duration, rate, step, tolerance, onGpu } = settings;
  const frames = Math.max(1, Math.round(duration * rate));
  const set = (param: string, value: number) => ({ node, param, value });
  if (frames > MOST_FRAMES) {
    const message = `${frames} frames are more than ${MOST_FRAMES}; keep fewer a second, or let it end sooner`;
    throw refusal('simulate.frames', `${node}.rate`, message, set('duration', MOST_FRAMES / rate));
  }
  const vertices = casts
    .flatMap(({ actors }) => actors)
    .reduce((sum, actor) => sum + (actor.kind === 'net' ? actor.pointOfVertex.length : 0), 0);
  if (vertices * frames > MOST_SAMPLES) {
    const message = `${vertices} vertices in ${frames} frames are more than ${MOST_SAMPLES} samples; keep fewer frames a second, let it end sooner, or take coarser meshes`;
    const most = Math.floor(MOST_SAMPLES / vertices / duration);
    throw refusal('simulate.samples', `${node}.rate`, message, most >= 1 ? set('rate', most) : undefined);
  }
  if (onGpu && tolerance > 0) {
    const message = 'steps that follow their error are not taken on the GPU; let them be all alike, with 0';
    throw refusal('simulate.gpu', `${node}.tolerance`, message, set('tolerance', 0));
  }
  const order: Order = {
    ...{ system, start, method: METHODS.get(settings.method)!, duration, every: duration / frames },
    ...(step > 0 && { step }),
    ...(tolerance > 0 && { tolerance }),
  };
  const { h, perFrame } = stepsOf(order);
  if (perFrame * frames > MOST_STEPS) {
    const message = `it would take ${(perFrame * frames).toExponential(1)} steps of ${h.toExponential(1)} s, more than ${MOST_STEPS}; set a longer step, take softer springs, or let it end sooner`;
    throw refusal('simulate.steps', `${node}.step`, message, set('step', duration / MOST_STEPS));
  }
  return order;
}
