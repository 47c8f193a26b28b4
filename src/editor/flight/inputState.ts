import type { AskedYaw, SnapTurn } from '../../flight/comfort/snapTurn.ts';
import type { FlightControls } from '../../flight/controls.ts';
import { length, type Vec3 } from '../../math/vec3.ts';

/** Thrust of each key in camera axes, by physical key (`KeyboardEvent.code`), the same on every layout. */
const THRUST_KEYS: Readonly<Record<string, Vec3>> = {
  KeyW: [0, 0, -1],
  KeyS: [0, 0, 1],
  KeyA: [-1, 0, 0],
  KeyD: [1, 0, 0],
  KeyE: [0, 1, 0],
  KeyQ: [0, -1, 0],
};
/** Yaw and pitch directions of each key. */
const LOOK_KEYS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [1, 0],
  ArrowRight: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
/** Roll directions of each key. */
const ROLL_KEYS: Readonly<Record<string, number>> = { Comma: 1, Period: -1 };
const BRAKE_KEY = 'KeyZ';
/** [rad/s] */
const LOOK_SPEED = 1.2;
const DEAD_ZONE = 0.15;

/** Flight keys, active unless the focused element takes text. */
export const isThrustKey = (code: string): boolean => code in THRUST_KEYS;
export const isFlightKey = (code: string): boolean =>
  code in THRUST_KEYS || code in LOOK_KEYS || code in ROLL_KEYS || code === BRAKE_KEY;

/** Button indices of the W3C standard gamepad. */
const GAMEPAD_BUTTONS = { play: 0, lock: 3, down: 4, up: 5, brake: 6, full: 7, rollLeft: 14, rollRight: 15 } as const;

/** Controls on the screen as they are held now. */
export interface HeldOnScreen extends Pick<FlightControls, 'thrust' | 'fullSpeed' | 'brake'> {
  /** Lets go of all, also of what is held without a finger. */
  readonly letGo: () => void;
}

/** Keys, drags, fingers and gamepad as they are held now. */
export class InputState {
  private readonly keys = new Set<string>();
  private pendingTurn: [yaw: number, pitch: number, roll: number] = [0, 0, 0];
  private pressed = new Set<number>();
  private fullSpeed = false;
  /** Absent until the page is touched. */
  screen: HeldOnScreen | undefined;
  /** Absent: one turns continuously. */
  snapTurn: SnapTurn | undefined;

  press(code: string): void {
    this.keys.add(code);
  }
  release(code: string): void {
    this.keys.delete(code);
  }
  holdFullSpeed(held: boolean): void {
    this.fullSpeed = held;
  }
  /** Forgets held keys, whose release will not be reported after the viewport loses the focus. */
  releaseAll(): void {
    this.keys.clear();
    this.fullSpeed = false;
  }
  /** Adds a rotation by mouse or fingers [rad]. */
  turn(yaw: number, pitch: number, roll = 0): void {
    const [y, p, r] = this.pendingTurn;
    this.pendingTurn = [y + yaw, p + pitch, r + roll];
  }

  /** Those of the next dt [s]. What has been turned since the last call is taken. */
  controls(dt: number): FlightControls {
    const thrust: [number, number, number] = [0, 0, 0];
    for (const key of this.keys) {
      const push = THRUST_KEYS[key];
      if (push) for (let axis = 0; axis < 3; axis++) thrust[axis]! += push[axis]!;
    }
    const { screen } = this;
    screen?.thrust.forEach((push, axis) => {
      thrust[axis]! += push;
    });
    const pad = gamepad();
    if (pad) {
      thrust[0] += stickValue(pad, 0);
      thrust[2] += stickValue(pad, 1);
      thrust[1] += buttonValue(pad, GAMEPAD_BUTTONS.up) - buttonValue(pad, GAMEPAD_BUTTONS.down);
    }
    const l = Math.max(1, length(thrust));
    const fullSpeed =
      this.fullSpeed || screen?.fullSpeed === true || (pad !== undefined && buttonValue(pad, GAMEPAD_BUTTONS.full) > 0);
    const brake =
      this.keys.has(BRAKE_KEY) ||
      screen?.brake === true ||
      (pad !== undefined && buttonValue(pad, GAMEPAD_BUTTONS.brake) > 0);
    return { thrust: [thrust[0] / l, thrust[1] / l, thrust[2] / l], turn: this.takeTurn(dt), fullSpeed, brake };
  }

  /** Pitch, yaw and roll since the last call [rad]; dt [s]. */
  private takeTurn(dt: number): Vec3 {
    const [dragged, draggedUp, twisted] = this.pendingTurn;
    let [held, pitch, roll] = [0, draggedUp, twisted];
    this.pendingTurn = [0, 0, 0];
    for (const key of this.keys) {
      roll += (ROLL_KEYS[key] ?? 0) * LOOK_SPEED * dt;
      held += LOOK_KEYS[key]?.[0] ?? 0;
      pitch += (LOOK_KEYS[key]?.[1] ?? 0) * LOOK_SPEED * dt;
    }
    const pad = gamepad();
    if (pad) {
      held -= stickValue(pad, 2) * 2;
      pitch -= stickValue(pad, 3) * 2 * LOOK_SPEED * dt;
      roll +=
        (buttonValue(pad, GAMEPAD_BUTTONS.rollLeft) - buttonValue(pad, GAMEPAD_BUTTONS.rollRight)) * LOOK_SPEED * dt;
    }
    return [pitch, this.yaw({ dragged, held }, dt), roll];
  }

  private yaw(asked: AskedYaw, dt: number): number {
    return this.snapTurn?.yaw(asked, dt) ?? asked.dragged + asked.held * LOOK_SPEED * dt;
  }

  /** Gamepad buttons that went down since the last call. */
  takeButtons(): { readonly play: boolean; readonly lock: boolean } {
    const pad = gamepad();
    const now = new Set(
      pad ? [GAMEPAD_BUTTONS.play, GAMEPAD_BUTTONS.lock].filter((button) => buttonValue(pad, button) > 0) : [],
    );
    const went = (button: number) => now.has(button as 0 | 3) && !this.pressed.has(button);
    const taken = { play: went(GAMEPAD_BUTTONS.play), lock: went(GAMEPAD_BUTTONS.lock) };
    this.pressed = now;
    return taken;
  }
}

const gamepad = (): Gamepad | undefined =>
  navigator.getGamepads?.().find((pad): pad is Gamepad => pad?.connected === true && pad.mapping === 'standard');

const stickValue = (pad: Gamepad, axis: number): number => {
  const value = pad.axes[axis] ?? 0;
  return Math.abs(value) < DEAD_ZONE ? 0 : (value - Math.sign(value) * DEAD_ZONE) / (1 - DEAD_ZONE);
};

const buttonValue = (pad: Gamepad, button: number): number => (pad.buttons[button]?.pressed ? 1 : 0);
