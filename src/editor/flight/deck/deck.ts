import { createStore } from 'zustand/vanilla';
import { type FlightConditions, flyArcs } from '../../../flight/arc.ts';
import { type Contact, type FlownMoment, flyAmong } from '../../../flight/collision/collide.ts';
import { comeDown, flyOnGround, type GroundRules, withoutGround } from '../../../flight/collision/ground.ts';
import type { FlightRules } from '../../../flight/controls.ts';
import { type FlightState, flightOf, observerOf } from '../../../flight/flightState.ts';
import type { FlightMoment } from '../../../flight/modes/flightMode.ts';
import { FLIGHT_MODES, type FlightModeName } from '../../../flight/modes/modes.ts';
import { FlightPlayback } from '../../../flight/recording/playback.ts';
import { FlightRecorder } from '../../../flight/recording/recorder.ts';
import type { FlightRecording } from '../../../flight/recording/recording.ts';
import { arcsOf } from '../../../flight/step.ts';
import { length, type Vec3 } from '../../../math/vec3.ts';
import { type Message, msg } from '../../../messages/message.ts';
import { messageOf } from '../../../messages/messageError.ts';
import { FASTER_THAN_PICTURES, isFasterThanPictures } from '../../../nodes/flights/pictureLimit.ts';
import type { PictureSpec } from '../../../nodes/socketValues.ts';
import type { Editor } from '../../state/editor.ts';
import { loadPreferences, savePreferences } from '../../state/preferences.ts';
import type { Pilot } from '../pilot.ts';
import { type FlightSettings, keptSettings, MODE_NAMES, settingsOf } from './flightSettings.ts';
import { bodyVelocity } from './targets.ts';
import { Walls } from './walls.ts';

/** What a wall does to a flight. */
export const CONTACT_TEXTS: Readonly<Record<Contact | 'preparing', Message>> = {
  preparing: msg`Preparing walls and ground…`,
  braking: msg`Braking for a wall`,
  'too-fast': msg`Too fast: cannot stop before the wall`,
  touching: msg`At a wall`,
};

/** What the deck shows. */
export interface DeckState extends FlightSettings {
  /** Path of the object that is followed. */
  readonly followed?: string | undefined;
  /** Of the autopilot, world frame [m]. */
  readonly destination?: Vec3 | undefined;
  /** What a wall does just now; `preparing`: they are not ready yet. */
  readonly contact?: Contact | 'preparing' | undefined;
  readonly recording: boolean;
  /** The latest recording. */
  readonly flight?: FlightRecording | undefined;
  /** Its length [s]. */
  readonly duration: number;
  /** The pilot's time [s] that is shown, while it is replayed or held. */
  readonly shown?: number | undefined;
  readonly replaying: boolean;
}

/** The pilot of the page: settings of the modes, recorder and playback. */
export class FlightDeck {
  readonly store = createStore<DeckState>(() => ({
    ...keptSettings(loadPreferences().flight),
    recording: false,
    duration: 0,
    replaying: false,
  }));
  private readonly editor: Editor;
  private readonly letGo: () => void;
  private readonly walls = new Walls((error) => {
    this.set({ collision: undefined, ground: false });
    this.editor.notify({ kind: 'error', text: msg`One flies through walls and ground again: ${messageOf(error)}` });
  });
  private recorder: FlightRecorder | undefined;
  private playback: FlightPlayback | undefined;
  /** Whether the next moment is that of coming down to the ground. */
  private isComingDown = false;
  /** Whether the replay is faster than what is drawn. */
  private isFaster = false;

  /** `letGo`: of what is held without a finger, which would fly on another way, or end a replay. */
  constructor(editor: Editor, letGo: () => void) {
    this.editor = editor;
    this.letGo = letGo;
    this.tellMode();
  }

  readonly pilot: Pilot = {
    fly: (moment, conditions, picture) => {
      // Who takes the controls flies on by hand.
      const { mode } = this.store.getState();
      if (mode === 'autopilot' && length(moment.controls.thrust) > 0) this.choose('thrust');
      const { pieces, after } = this.flown({ ...moment, rules: this.rules(moment, picture) }, conditions, picture);
      for (const piece of pieces) this.recorder?.add(piece.before, piece.arcs, conditions, piece.after);
      if (this.recorder?.isFull) {
        this.stop();
        this.editor.notify({
          kind: 'warning',
          text: msg`The recording is full, and has ended. Save it, and start another.`,
        });
      }
      return after;
    },
    replayed: (dt, busy) => {
      const { shown, replaying, duration } = this.store.getState();
      if (shown === undefined || !this.playback) return undefined;
      if (busy) {
        this.store.setState({ shown: undefined, replaying: false });
        return undefined;
      }
      const time = replaying ? Math.min(duration, shown + dt) : shown;
      if (time !== shown) this.store.setState({ shown: time, replaying: time < duration });
      const state = this.playback.stateAt(time);
      this.tellOfSpeed(state);
      return { state, leg: this.playback.legAt(time) };
    },
  };

  /** Tells once that a flight is faster than what is drawn. */
  private tellOfSpeed(state: FlightState): void {
    const { isFaster } = this;
    this.isFaster = isFasterThanPictures(state);
    if (this.isFaster && !isFaster) this.editor.notify({ kind: 'warning', text: FASTER_THAN_PICTURES });
  }

  /** The page's rules with those of the deck. */
  private rules({ state, rules }: FlightMoment, { scene }: PictureSpec): FlightRules {
    const { mode, along, across, level, attitude, followed, destination } = this.store.getState();
    const { c } = rules;
    const body = mode === 'follow' ? scene.objects.find(({ path }) => path === followed) : undefined;
    const velocity = body && bodyVelocity(body, observerOf(state), c);
    return {
      ...rules,
      along: along * c,
      across: across * c,
      level,
      attitude,
      ...(velocity && { followed: velocity }),
      ...(destination && { destination }),
    };
  }

  private flown(moment: FlightMoment, conditions: FlightConditions, picture: PictureSpec): FlownMoment {
    const { mode, collision, ground, eyeHeight: height, clearance: radius, contact } = this.store.getState();
    const isDriving = mode === 'drive' && ground;
    const obstacles = (collision || isDriving) && this.walls.of(picture);
    const flyFreely = (asked: FlightMoment): FlownMoment => {
      const { state: before } = asked;
      const arcs = arcsOf(FLIGHT_MODES[mode], asked);
      const after = flyArcs(before, arcs, conditions);
      return { pieces: [{ before, arcs, after }], after };
    };
    if (!obstacles) {
      const preparing = collision || isDriving ? 'preparing' : undefined;
      if (preparing !== contact) this.store.setState({ contact: preparing });
      return flyFreely(moment);
    }
    if (this.isComingDown) {
      this.isComingDown = false;
      return { pieces: [], after: this.cameDown(moment, conditions, { obstacles, height }) };
    }
    const walls = isDriving ? withoutGround(obstacles, moment.rules.up) : obstacles;
    const fly = (asked: FlightMoment): FlownMoment =>
      collision
        ? flyAmong(FLIGHT_MODES[mode], asked, conditions, { obstacles: walls, kind: collision, radius })
        : flyFreely(asked);
    const flown = isDriving ? flyOnGround(moment, conditions, { obstacles, height }, fly) : fly(moment);
    if (flown.contact !== contact) this.store.setState({ contact: flown.contact });
    if (flown.contact === 'too-fast' && contact !== 'too-fast')
      this.editor.notify({ kind: 'warning', text: CONTACT_TEXTS['too-fast'] });
    return flown;
  }

  choose(mode: FlightModeName): void {
    this.letGo();
    this.set({ mode });
    this.tellMode();
  }

  private tellMode(): void {
    this.editor.update({ flightMode: FLIGHT_MODES[this.store.getState().mode].title });
  }

  next(): void {
    this.choose(MODE_NAMES[(MODE_NAMES.indexOf(this.store.getState().mode) + 1) % MODE_NAMES.length]!);
  }

  /** Changes how one flies, which the page remembers, and where to, which it does not. */
  set(change: Partial<FlightSettings & Pick<DeckState, 'followed' | 'destination'>>): void {
    this.store.setState(change);
    savePreferences({ ...loadPreferences(), flight: settingsOf(this.store.getState()) });
  }

  /** Puts the pilot with the next moment on what is below at the height of the eye, at rest there; or says that nothing is. */
  comeDown(): void {
    this.leave();
    this.isComingDown = true;
  }

  private cameDown({ state, rules }: FlightMoment, conditions: FlightConditions, ground: GroundRules): FlightState {
    const there = comeDown(state, ground, rules.up, conditions);
    if (!there) this.editor.notify({ kind: 'info', text: msg`There is no ground below.` });
    return there ? flightOf({ ...observerOf(state), ...there }) : state;
  }

  toggleRecording(): void {
    if (this.recorder) this.stop();
    else {
      this.recorder = new FlightRecorder();
      this.store.setState({ recording: true, shown: undefined, replaying: false });
    }
  }

  private stop(): void {
    const flight = this.recorder?.recording();
    this.recorder = undefined;
    this.store.setState({ recording: false });
    if (flight && flight.legs.length > 0) this.open(flight);
  }

  /** Takes a recording to be replayed. */
  open(flight: FlightRecording): void {
    this.playback = new FlightPlayback(flight);
    this.store.setState({ flight, duration: this.playback.duration, shown: undefined, replaying: false });
  }

  /** Shows a time of the recording [s], and holds it. */
  show(time: number): void {
    this.letGo();
    this.store.setState({ shown: time, replaying: false });
  }

  toggleReplay(): void {
    this.letGo();
    const { shown, replaying, duration } = this.store.getState();
    this.store.setState({ shown: shown === undefined || shown >= duration ? 0 : shown, replaying: !replaying });
  }

  /** Ends a replay where it is: one flies on from there. */
  leave(): void {
    this.store.setState({ shown: undefined, replaying: false });
  }
}
