import { createStore } from 'zustand/vanilla';
import { driveMode } from '../../../flight/modes/drive.ts';
import { velocityMode } from '../../../flight/modes/velocity.ts';
import { length } from '../../../math/vec3.ts';
import { type Message, msg } from '../../../messages/message.ts';
import type { Editor } from '../../state/editor.ts';
import type { InputState } from '../inputState.ts';
import { deviceTurn, screenOrientation } from './deviceTurn.ts';

/** Whether one looks around by turning the device. Never at first: some systems ask each time. */
export const deviceLook = createStore<boolean>(() => false);

/** Smaller turns are those of a hand at rest, which draw nothing [rad]. */
const REST = 0.003;
/** A device that tells how it is held does so by then [ms]. */
const PATIENCE = 1500;

let end: AbortController | undefined;

export function endDeviceLook(): void {
  end?.abort();
  deviceLook.setState(false, true);
}

/** Turns as the device is turned from now on. To be called by a tap: iOS asks then. */
export async function beginDeviceLook(editor: Editor, inputs: InputState): Promise<void> {
  const refuse = (text: Message): void => {
    endDeviceLook();
    editor.notify({ kind: 'warning', text });
  };
  if (!isSecureContext || !('DeviceOrientationEvent' in window))
    return refuse(msg`How the device is held is told to pages of https and of the device itself alone.`);
  endDeviceLook();
  const { requestPermission } = DeviceOrientationEvent as { requestPermission?: () => Promise<string> };
  const answer = await requestPermission?.call(DeviceOrientationEvent).catch(() => 'denied');
  if (answer === 'denied') return refuse(msg`The system does not tell this page how the device is held.`);
  deviceLook.setState(true, true);
  end = new AbortController();
  const { signal } = end;
  const silence = setTimeout(() => refuse(msg`This device does not tell how it is held.`), PATIENCE);
  signal.addEventListener('abort', () => clearTimeout(silence));
  let known: { readonly orientation: ReturnType<typeof screenOrientation>; readonly angle: number } | undefined;
  addEventListener(
    'deviceorientation',
    ({ alpha, beta, gamma }) => {
      if (alpha === null || beta === null || gamma === null) return;
      clearTimeout(silence);
      const { angle } = screen.orientation;
      const orientation = screenOrientation({ alpha, beta, gamma }, angle);
      // A page that turns on its device is no turn of the device.
      if (known?.angle !== angle) {
        known = { orientation, angle };
        return;
      }
      const { template } = editor.store.getState().flightMode;
      const level = template === velocityMode.title.template || template === driveMode.title.template;
      const turn = deviceTurn(known.orientation, orientation, level);
      if (length(turn) < REST) return;
      known = { orientation, angle };
      inputs.turn(turn[1], turn[0], turn[2]);
    },
    { signal },
  );
}
