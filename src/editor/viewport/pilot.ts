import { IDENTITY } from '../../math/quat.ts';
import { length, ZERO } from '../../math/vec3.ts';
import type { Picture } from '../../nodes/define.ts';
import { cameraOf } from '../../nodes/picture.ts';
import type { ObserverState } from '../../physics/observer.ts';
import type { ViewPoint } from '../../scene/view.ts';
import { LOCKS, type Lock, look, stepFlight, wrapTime } from '../flight/flight.ts';
import { sceneKey } from '../loading/localFiles.ts';
import { leaveCamera } from '../shell/actions.ts';
import type { Opened, Studio } from '../state/studio.ts';
import { ridingObserver, startingObserver, upOf, viewPointOf } from '../state/viewpoint.ts';
import { Inputs } from './inputs.ts';

/** Where an observer goes on. */
export interface Returning {
  readonly observer: ObserverState;
  readonly lock: Lock;
  readonly cruise: boolean;
}

/** Moves the observer, and the world's time, by what the person does: what changes by itself and is in no document. */
export class Pilot {
  readonly inputs = new Inputs();
  readonly #studio: Studio;
  #picture: Picture | undefined;
  /** What it is of: files that are added to a scene do not make it another. */
  #scene = '';
  #until: number | undefined;
  #observer: ObserverState = { t: 0, position: ZERO, u: ZERO, orientation: IDENTITY, properTime: 0 };

  /** Of the first picture: where the observer was before the page was loaded again. */
  #returns: Returning | undefined;

  constructor(studio: Studio, returns?: Returning) {
    this.#studio = studio;
    this.#returns = returns;
  }

  get observer(): ObserverState {
    return this.#observer;
  }
  get picture(): Picture | undefined {
    return this.#picture;
  }

  /** So far the motion was computed [s]: time waits there for more. Undefined: it is whole. */
  get until(): number | undefined {
    return this.#until;
  }

  isOf({ origin, source }: Pick<Opened, 'origin' | 'source'>): boolean {
    return this.#scene === keyOf(origin, source);
  }

  /**
   * What is shown from now on. Another project or file begins at its own start, another camera is gone to; any other edit leaves the
   * observer where he is.
   */
  show(picture: Picture, { origin, source }: Pick<Opened, 'origin' | 'source'>, until?: number): void {
    const before = this.#picture?.camera;
    const scene = keyOf(origin, source);
    this.#picture = picture;
    this.#until = until;
    if (scene !== this.#scene) {
      this.#scene = scene;
      this.restart();
      this.#return();
    } else if (before !== picture.camera) {
      const { position, orientation } = ridingObserver(cameraOf(picture), this.#observer, picture.speedOfLight);
      this.#observer = { ...this.#observer, position, orientation };
    }
  }

  /** Back to where the scene begins, as its author meant it to be seen. */
  restart(): void {
    if (!this.#picture) return;
    this.#observer = startingObserver(this.#picture);
    const moving = this.#picture.scene.hints.beta !== undefined;
    this.#studio.change({ lock: moving ? 'look' : 'free', cruise: moving });
  }

  #return(): void {
    if (!this.#returns) return;
    const { observer, lock, cruise } = this.#returns;
    this.#observer = observer;
    this.#studio.change({ lock, cruise });
    this.#returns = undefined;
  }

  seek(t: number): void {
    this.#observer = { ...this.#observer, t };
  }

  /** dt [s]: of the person's time. */
  advance(dt: number): void {
    this.#takeButtons();
    const picture = this.#picture;
    if (!picture) return;
    const turn = this.inputs.takeTurn(dt);
    const controls = this.inputs.controls();
    const busy = turn[0] !== 0 || turn[1] !== 0 || length(controls.thrust) > 0;
    if (picture.ride && busy) leaveCamera(this.#studio);
    if (picture.ride && !busy) this.#ride(picture, dt);
    else this.#fly(picture, dt, turn, controls);
    this.#keepTime(picture);
  }

  viewPoint(): ViewPoint | undefined {
    return this.#picture && viewPointOf(this.#observer, this.#picture, this.#studio.store.getState().lock);
  }

  nextLock(): void {
    const { lock } = this.#studio.store.getState();
    this.#studio.change({ lock: LOCKS[(LOCKS.indexOf(lock) + 1) % LOCKS.length]! });
  }

  togglePlaying(): void {
    const { playing, loop } = this.#studio.store.getState();
    const scene = this.#picture?.scene;
    if (!playing && !loop && scene && this.#observer.t >= scene.endTime) this.seek(scene.startTime);
    this.#studio.change({ playing: !playing });
  }

  #takeButtons(): void {
    const buttons = this.inputs.takeButtons();
    if (buttons.lock) this.nextLock();
    if (buttons.play) this.togglePlaying();
  }

  #fly(
    picture: Picture,
    dt: number,
    [yaw, pitch]: readonly [number, number],
    controls: Parameters<typeof stepFlight>[1],
  ) {
    const { lock, cruise } = this.#studio.store.getState();
    const playing = this.#passes;
    const { scene, speedOfLight: c, maxSpeed } = picture;
    const up = upOf(scene);
    const orientation = yaw || pitch ? look(this.#observer.orientation, yaw, pitch, up) : this.#observer.orientation;
    this.#observer = stepFlight({ ...this.#observer, orientation }, controls, dt, {
      c,
      maxSpeed,
      lock,
      cruise,
      playing,
      up,
    });
  }

  #ride(picture: Picture, dt: number): void {
    const before = this.#observer;
    const after = ridingObserver(
      cameraOf(picture),
      { ...before, t: before.t + (this.#passes ? dt : 0) },
      picture.speedOfLight,
    );
    const slow = Math.hypot(1, length(after.u));
    this.#observer = { ...after, properTime: before.properTime + (after.t - before.t) / slow };
  }

  /** Whether time passes in the world. */
  get #passes(): boolean {
    const { playing } = this.#studio.store.getState();
    return playing && (this.#until === undefined || this.#observer.t < this.#until);
  }

  #keepTime({ scene }: Picture): void {
    const { playing, loop } = this.#studio.store.getState();
    const { startTime, endTime } = scene;
    const { t: now } = this.#observer;
    if (!playing) return;
    const until = this.#until;
    const t = until === undefined ? wrapTime(now, startTime, endTime, loop) : Math.min(now, endTime, until);
    if (t === now) return;
    this.seek(t);
    if (!loop && until === undefined) this.#studio.change({ playing: false });
  }
}

const keyOf = (origin: string, source: string): string => JSON.stringify([origin, sceneKey(source)]);
