import { flyArcs, LOCKS, type Lock } from '../../flight/arc.ts';
import type { WatchedMoment } from '../../flight/comfort/flow.ts';
import type { FlightControls } from '../../flight/controls.ts';
import { type FlightState, flightOf, observerOf } from '../../flight/flightState.ts';
import { velocityMode } from '../../flight/modes/velocity.ts';
import { arcsOf } from '../../flight/step.ts';
import { IDENTITY } from '../../math/quat.ts';
import { sumOf } from '../../math/sum.ts';
import { add, addScaled, dot, length, scale, sub, ZERO } from '../../math/vec3.ts';
import { flightViewPoint } from '../../nodes/flights/flightViewPoint.ts';
import { pictureCamera, pictureLens } from '../../nodes/pictures/renderSettings.ts';
import type { PictureSpec } from '../../nodes/socketValues.ts';
import type { ObserverState } from '../../physics/lorentz/observer.ts';
import type { properTimeBetween as ProperTimeBetween } from '../../physics/worldLines/properTime.ts';
import { lookAtOrientation, riddenLine } from '../../scene/view/camera.ts';
import type { ViewPoint } from '../../scene/view/view.ts';
import { sceneKey } from '../loading/localFiles.ts';
import { leaveCamera } from '../shell/actions.ts';
import type { Editor, PictureSource } from '../state/editor.ts';
import { initialObserver, observerOnCamera, sceneUpVector } from '../state/observer.ts';
import type { HeldWalk } from './held.ts';
import { InputState } from './inputState.ts';
import type { Pilot } from './pilot.ts';
import { isOutside, type SceneLimits, sceneLimits } from './sceneLimits.ts';
import { wrapTime } from './wrapTime.ts';

/** State from which a restored session resumes. */
export interface RestoredObserver {
  readonly observer: ObserverState;
  readonly lock: Lock;
  readonly cruise: boolean;
}

/** Watches what the observer sees of his motion. */
export type Watcher = (moment: Omit<WatchedMoment, 'distance'>, limits: SceneLimits | undefined) => void;

/** Moves the observer and world time by user input. This state is in no document. */
export class ObserverController {
  readonly inputs = new InputState();
  /** Absent until the flight deck is opened. */
  pilot: Pilot | undefined;
  /** Absent unless something is done for comfort. */
  watcher: Watcher | undefined;
  /** Absent unless what is seen is held still. */
  held: HeldWalk | undefined;
  private readonly editor: Editor;
  private currentPicture: PictureSpec | undefined;
  /** Key of the shown scene; it stays the same when files are added to the scene. */
  private scene = '';
  private until: number | undefined;
  private limits: SceneLimits | undefined;
  private flight: FlightState = flightOf({ t: 0, position: ZERO, u: ZERO, orientation: IDENTITY, properTime: 0 });

  /** For the first picture: the state to restore after a page reload. */
  private restored: RestoredObserver | undefined;
  /** What a clock on a world line counts; loaded when a camera is ridden, which begins then. */
  private properTimeBetween: typeof ProperTimeBetween | undefined;

  constructor(editor: Editor, restored?: RestoredObserver) {
    this.editor = editor;
    this.restored = restored;
  }

  get observer(): ObserverState {
    return this.state;
  }
  private get state(): ObserverState {
    return observerOf(this.flight);
  }
  private set state(observer: ObserverState) {
    this.flight = flightOf(observer);
  }
  get picture(): PictureSpec | undefined {
    return this.currentPicture;
  }

  /** Time up to which the motion is computed [s], where playback waits for more; undefined when it is complete. */
  get computedUntil(): number | undefined {
    return this.until;
  }

  isShowing({ origin, source }: Pick<PictureSource, 'origin' | 'source'>): boolean {
    return this.scene === sceneIdentity(origin, source);
  }

  /**
   * Sets the picture to observe. Another project or file starts at its own start; another camera is moved to; any other
   * edit leaves the observer in place.
   */
  setPicture(picture: PictureSpec, { origin, source }: Pick<PictureSource, 'origin' | 'source'>, until?: number): void {
    const before = this.currentPicture?.camera;
    if (picture.scene !== this.currentPicture?.scene)
      this.limits = sceneLimits(picture.scene, initialObserver(picture).position, picture.speedOfLight);
    const scene = sceneIdentity(origin, source);
    this.currentPicture = picture;
    this.until = until;
    if (picture.ride) void this.loadClock();
    if (scene !== this.scene) {
      this.scene = scene;
      this.restart();
      this.restore();
    } else if (before !== picture.camera) {
      const { position, orientation } = observerOnCamera(pictureCamera(picture), this.state, picture.speedOfLight);
      this.state = { ...this.state, position, orientation };
    }
  }

  /** Back to the initial state that the scene defines. */
  restart(): void {
    if (!this.currentPicture) return;
    this.held?.end();
    this.inputs.screen?.letGo();
    this.state = initialObserver(this.currentPicture);
    const moving = this.currentPicture.scene.hints.beta !== undefined;
    this.editor.update({ lock: moving ? 'look' : 'free', cruise: moving });
  }

  private restore(): void {
    if (!this.restored) return;
    const { observer, lock, cruise } = this.restored;
    this.state = observer;
    this.editor.update({ lock, cruise });
    this.restored = undefined;
  }

  /** Whether the observer has left the scene. */
  get isOutside(): boolean {
    return this.limits !== undefined && !this.held && isOutside(this.limits, this.state.position);
  }

  /** Stops, and looks back to where the scene is. */
  turnBack(): void {
    if (!this.limits || !this.currentPicture) return;
    this.held?.end();
    this.inputs.screen?.letGo();
    const { min, max } = this.limits.box;
    const { position } = this.state;
    const up = sceneUpVector(this.currentPicture.scene);
    const there = sub(scale(add(min, max), 0.5), position);
    // At the height of the eyes: one who flew straight out flies straight in again.
    const level = addScaled(there, up, -dot(there, up));
    const ahead = length(level) > 0 ? level : there;
    if (length(ahead) > 0) this.state = { ...this.state, u: ZERO, orientation: lookAtOrientation(ahead, up) };
  }

  /** Puts the observer at another event, or gives him another velocity, axes or clock; on a moving camera he no longer rides. */
  place(to: Partial<ObserverState>): void {
    if (this.currentPicture?.ride) leaveCamera(this.editor);
    this.state = { ...this.state, ...to };
  }

  seek(t: number): void {
    this.flight = { ...this.flight, t: sumOf(t) };
  }

  /** dt [s] of real time. */
  advance(dt: number): void {
    this.takeButtons();
    const { flight: before, held } = this;
    const from = held?.camera;
    this.move(dt);
    const { lock } = this.editor.store.getState();
    const walked = from && { before: from, after: held.camera };
    this.watcher?.({ before, after: this.flight, dt, lock, walked }, this.limits);
  }

  private move(dt: number): void {
    const picture = this.currentPicture;
    if (!picture) return;
    const controls = this.inputs.controls(dt);
    const busy = controls.brake || length(controls.turn) + length(controls.thrust) > 0;
    if (this.held) {
      this.held.walk(controls, dt, picture);
      if (this.timeRuns) this.seek(this.state.t + dt);
      this.keepTime(picture);
      return;
    }
    const replayed = this.pilot?.replayed(dt, busy);
    if (replayed) {
      this.flight = replayed.state;
      this.editor.update({ lock: replayed.leg.conditions.lock });
      return;
    }
    if (picture.ride && busy) leaveCamera(this.editor);
    if (picture.ride && !busy) this.ride(picture, this.timeRuns ? dt : 0);
    else this.fly(picture, dt, controls);
    this.keepTime(picture);
  }

  viewPoint(): ViewPoint | undefined {
    const picture = this.currentPicture;
    const eye = picture && flightViewPoint(this.flight, this.editor.store.getState(), pictureLens(picture));
    return eye && { ...eye, ...this.held?.camera };
  }

  cycleLock(): void {
    const { lock } = this.editor.store.getState();
    this.editor.update({ lock: LOCKS[(LOCKS.indexOf(lock) + 1) % LOCKS.length]! });
  }

  togglePlaying(): void {
    const { playing, loop } = this.editor.store.getState();
    const scene = this.currentPicture?.scene;
    if (!playing && !loop && scene && this.state.t >= scene.endTime) this.seek(scene.startTime);
    this.editor.update({ playing: !playing });
  }

  private takeButtons(): void {
    const buttons = this.inputs.takeButtons();
    if (buttons.lock) this.cycleLock();
    if (buttons.play) this.togglePlaying();
  }

  private fly(picture: PictureSpec, dt: number, controls: FlightControls): void {
    const { lock, cruise } = this.editor.store.getState();
    const { scene, speedOfLight: c, maxSpeed } = picture;
    const rules = {
      c,
      maxSpeed,
      cruise,
      up: sceneUpVector(scene),
      along: c,
      across: c,
      level: false,
      attitude: 'hand',
    } as const;
    const before = this.flight;
    const moment = { state: before, controls, dt, rules };
    const conditions = { c, lock, playing: this.timeRuns };
    this.flight =
      this.pilot?.fly(moment, conditions, picture) ?? flyArcs(before, arcsOf(velocityMode, moment), conditions);
  }

  private async loadClock(): Promise<void> {
    this.properTimeBetween ??= (await import('../../physics/worldLines/properTime.ts')).properTimeBetween;
  }

  /** dt [s] of world time. */
  private ride(picture: PictureSpec, dt: number): void {
    if (!this.properTimeBetween) return;
    const before = this.state;
    const camera = pictureCamera(picture);
    const c = picture.speedOfLight;
    const t = before.t + dt;
    const elapsed = this.properTimeBetween(riddenLine(camera), before.t, t, c);
    this.state = observerOnCamera(camera, { ...before, t, properTime: before.properTime + elapsed }, c);
  }

  /** Whether world time runs. */
  private get timeRuns(): boolean {
    const { playing } = this.editor.store.getState();
    return playing && (this.until === undefined || this.state.t < this.until);
  }

  private keepTime({ scene }: PictureSpec): void {
    const { playing, loop } = this.editor.store.getState();
    const { startTime, endTime } = scene;
    const { t: now } = this.state;
    if (!playing) return;
    const until = this.until;
    const t = until === undefined ? wrapTime(now, startTime, endTime, loop) : Math.min(now, endTime, until);
    if (t === now) return;
    this.seek(t);
    if (!loop && until === undefined) this.editor.update({ playing: false });
  }
}

const sceneIdentity = (origin: string, source: string): string => JSON.stringify([origin, sceneKey(source)]);
