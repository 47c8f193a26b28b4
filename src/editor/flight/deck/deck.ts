import { createStore } from 'zustand/vanilla';
import { type FlightConditions, flyArcs } from '../../../flight/arc.ts';
import { type CollisionKind, type Contact, type FlownMoment, flyAmong } from '../../../flight/collision/collide.ts';
import type { Attitude, FlightRules } from '../../../flight/controls.ts';
import { type FlightState, observerOf } from '../../../flight/flightState.ts';
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
import { bodyVelocity } from './targets.ts';
import { Walls } from './walls.ts';

/** What a wall does to a flight. */
export const CONTACT_TEXTS: Readonly<Record<Contact | 'preparing', Message>> = {
  preparing: msg`Preparing the walls…`,
  braking: msg`Braking for a wall`,
  'too-fast': msg`Too fast: cannot stop before the wall`,
  touching: msg`At a wall`,
};

/** What the deck shows. */
export interface DeckState {
  readonly mode: FlightModeName;
  /** Proper acceleration along the nose and across it, in units of c per second. */
  readonly along: number;
  readonly across: number;
  /** Whether the horizon is kept level. */
  readonly level: boolean;
  readonly attitude: Attitude;
  /** Path of the object that is followed. */
  readonly followed?: string | undefined;
  /** Of the autopilot, world frame [m]. */
  readonly destination?: Vec3 | undefined;
  /** What happens at walls; absent: one flies through them. */
  readonly collision?: CollisionKind | undefined;
  /** How far one stays from walls [m]. */
  readonly clearance: number;
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
    mode: 'velocity',
    along: 0.5,
    across: 0.25,
    level: false,
    attitude: 'hand',
    collision: loadPreferences().collision,
    clearance: 0.3,
    recording: false,
    duration: 0,
    replaying: false,
  }));
  private readonly editor: Editor;
  private readonly walls = new Walls((error) => {
    this.collide(undefined);
    this.editor.notify({ kind: 'error', text: msg`One flies through walls again: ${messageOf(error)}` });
  });
  private recorder: FlightRecorder | undefined;
  private playback: FlightPlayback | undefined;
  /** Whether the replay is faster than what is drawn. */
  private isFaster = false;

  constructor(editor: Editor) {
    this.editor = editor;
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
    const { mode, collision: kind, clearance: radius, contact } = this.store.getState();
    const obstacles = kind && this.walls.of(picture);
    if (kind && obstacles) {
      const flown = flyAmong(FLIGHT_MODES[mode], moment, conditions, { obstacles, kind, radius });
      if (flown.contact !== contact) this.store.setState({ contact: flown.contact });
      if (flown.contact === 'too-fast' && contact !== 'too-fast')
        this.editor.notify({ kind: 'warning', text: CONTACT_TEXTS['too-fast'] });
      return flown;
    }
    const preparing = kind && 'preparing';
    if (preparing !== contact) this.store.setState({ contact: preparing });
    const { state: before } = moment;
    const arcs = arcsOf(FLIGHT_MODES[mode], moment);
    const after = flyArcs(before, arcs, conditions);
    return { pieces: [{ before, arcs, after }], after };
  }

  collide(collision: CollisionKind | undefined): void {
    this.store.setState({ collision });
    savePreferences({ ...loadPreferences(), collision });
  }

  choose(mode: FlightModeName): void {
    this.store.setState({ mode });
    this.editor.update({ flightMode: FLIGHT_MODES[mode].title });
  }

  next(): void {
    const names = Object.keys(FLIGHT_MODES) as FlightModeName[];
    this.choose(names[(names.indexOf(this.store.getState().mode) + 1) % names.length]!);
  }

  set(
    change: Partial<
      Pick<DeckState, 'along' | 'across' | 'level' | 'attitude' | 'followed' | 'destination' | 'clearance'>
    >,
  ): void {
    this.store.setState(change);
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
    this.store.setState({ shown: time, replaying: false });
  }

  toggleReplay(): void {
    const { shown, replaying, duration } = this.store.getState();
    this.store.setState({ shown: shown === undefined || shown >= duration ? 0 : shown, replaying: !replaying });
  }

  /** Ends a replay where it is: one flies on from there. */
  leave(): void {
    this.store.setState({ shown: undefined, replaying: false });
  }
}
