import { length, type Vec3 } from '../../math/vec3.ts';
import type { Controls } from '../flight/flight.ts';

/** Thrust of each key in camera axes, by the key's place on the keyboard, so that it is the same on every layout. */
const THRUST: Readonly<Record<string, Vec3>> = {
  KeyW: [0, 0, -1],
  KeyS: [0, 0, 1],
  KeyA: [-1, 0, 0],
  KeyD: [1, 0, 0],
  KeyE: [0, 1, 0],
  KeyQ: [0, -1, 0],
};
/** Yaw and pitch of each key. */
const LOOK: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [1, 0],
  ArrowRight: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
/** [rad/s] */
const LOOK_SPEED = 1.2;
const DEAD_ZONE = 0.15;

/** Letters that fly, wherever the focus is on something that does not take letters. */
export const isThrustKey = (code: string): boolean => code in THRUST;
export const isFlightKey = (code: string): boolean => code in THRUST || code in LOOK;

/** Actions of a gamepad's buttons, by their standard numbers. */
const BUTTONS = { play: 0, lock: 3, down: 4, up: 5, full: 7 } as const;

/** What is held down or pushed now: keys, dragging and a gamepad together. */
export class Inputs {
  readonly #keys = new Set<string>();
  #turn: [yaw: number, pitch: number] = [0, 0];
  #pressed = new Set<number>();
  #fullSpeed = false;

  press(code: string): void {
    this.#keys.add(code);
  }
  release(code: string): void {
    this.#keys.delete(code);
  }
  holdFullSpeed(held: boolean): void {
    this.#fullSpeed = held;
  }
  /** Keys whose release will not be heard: the picture lost the focus. */
  releaseAll(): void {
    this.#keys.clear();
    this.#fullSpeed = false;
  }
  /** By the mouse [rad]. */
  turn(yaw: number, pitch: number): void {
    this.#turn[0] += yaw;
    this.#turn[1] += pitch;
  }

  controls(): Controls {
    const thrust: [number, number, number] = [0, 0, 0];
    for (const key of this.#keys) {
      const push = THRUST[key];
      if (push) for (let axis = 0; axis < 3; axis++) thrust[axis]! += push[axis]!;
    }
    const pad = gamepad();
    if (pad) {
      thrust[0] += stick(pad, 0);
      thrust[2] += stick(pad, 1);
      thrust[1] += held(pad, BUTTONS.up) - held(pad, BUTTONS.down);
    }
    const l = Math.max(1, length(thrust));
    const fullSpeed = this.#fullSpeed || (pad !== undefined && held(pad, BUTTONS.full) > 0);
    return { thrust: [thrust[0] / l, thrust[1] / l, thrust[2] / l], fullSpeed };
  }

  /** Yaw and pitch since the last call [rad]; dt [s]. */
  takeTurn(dt: number): readonly [number, number] {
    let [yaw, pitch] = this.#turn;
    this.#turn = [0, 0];
    for (const key of this.#keys) {
      yaw += (LOOK[key]?.[0] ?? 0) * LOOK_SPEED * dt;
      pitch += (LOOK[key]?.[1] ?? 0) * LOOK_SPEED * dt;
    }
    const pad = gamepad();
    if (pad) {
      yaw -= stick(pad, 2) * 2 * LOOK_SPEED * dt;
      pitch -= stick(pad, 3) * 2 * LOOK_SPEED * dt;
    }
    return [yaw, pitch];
  }

  /** Gamepad buttons that went down since the last call. */
  takeButtons(): { readonly play: boolean; readonly lock: boolean } {
    const pad = gamepad();
    const now = new Set(pad ? [BUTTONS.play, BUTTONS.lock].filter((button) => held(pad, button) > 0) : []);
    const went = (button: number) => now.has(button as 0 | 3) && !this.#pressed.has(button);
    const taken = { play: went(BUTTONS.play), lock: went(BUTTONS.lock) };
    this.#pressed = now;
    return taken;
  }
}

const gamepad = (): Gamepad | undefined =>
  navigator.getGamepads?.().find((pad): pad is Gamepad => pad?.connected === true && pad.mapping === 'standard');

const stick = (pad: Gamepad, axis: number): number => {
  const value = pad.axes[axis] ?? 0;
  return Math.abs(value) < DEAD_ZONE ? 0 : (value - Math.sign(value) * DEAD_ZONE) / (1 - DEAD_ZONE);
};

const held = (pad: Gamepad, button: number): number => (pad.buttons[button]?.pressed ? 1 : 0);
