import { createStore } from 'zustand/vanilla';
import { scale, type Vec3, ZERO } from '../../../math/vec3.ts';
import type { HeldOnScreen } from '../inputState.ts';

/** Where the thrust pad is held: parts of its radius to the right and back, at most full thrust long. */
interface PadPush {
  readonly right: number;
  readonly back: number;
  /** Whether the finger is beyond the rim. */
  readonly isBeyond: boolean;
}

export interface ScreenControlsState {
  /** Absent: the pad is not held. */
  readonly pad?: PadPush | undefined;
  /** Up and down, −1 … 1. */
  readonly rise: number;
  readonly brake: boolean;
  /** The part of full thrust that is held without a finger, 0 … 1. */
  readonly throttle: number;
}

const LET_GO: ScreenControlsState = { rise: 0, brake: false, throttle: 0, pad: undefined };

/** Beyond so many radii of the pad one flies as with the key for full speed. */
const RIM = 1.4;

/** Thrust pad, throttle and buttons on the screen: the throttle says how hard, the pad where to, ahead if it is not held. */
export class ScreenControls implements HeldOnScreen {
  readonly store = createStore<ScreenControlsState>(() => LET_GO);

  /** A finger on the pad, in radii from its middle; undefined: it is lifted. */
  holdPad(at: readonly [right: number, back: number] | undefined): void {
    const size = at && Math.hypot(...at);
    const part = size && size > 1 ? 1 / size : 1;
    this.store.setState({
      pad: at && { right: at[0] * part, back: at[1] * part, isBeyond: (size ?? 0) > RIM },
    });
  }

  get thrust(): Vec3 {
    const { pad, rise, throttle } = this.store.getState();
    const isIdle = !pad && rise === 0;
    if (throttle === 0) return isIdle ? ZERO : [pad?.right ?? 0, rise, pad?.back ?? 0];
    return scale(isIdle ? [0, 0, -1] : [pad?.right ?? 0, rise, pad?.back ?? 0], throttle);
  }

  get fullSpeed(): boolean {
    const { pad, throttle } = this.store.getState();
    return throttle > 0 || pad?.isBeyond === true;
  }

  get brake(): boolean {
    return this.store.getState().brake;
  }

  letGo(): void {
    this.store.setState(LET_GO);
  }
}

/** The throttle with which velocities that are asked for are so fast; `maxSpeed` and `speed` as fractions of c. */
export const throttleOf = (speed: number, maxSpeed: number): number => Math.min(1, speed / maxSpeed);

/** Speeds lie on the slider as their rapidities do: 0 … 1 of that of the greatest. */
export const sliderSpeed = (position: number, maxSpeed: number): number => Math.tanh(position * Math.atanh(maxSpeed));
export const speedPosition = (speed: number, maxSpeed: number): number => Math.atanh(speed) / Math.atanh(maxSpeed);
