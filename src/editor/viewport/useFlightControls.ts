import { type RefObject, useEffect, useState } from 'react';
import { useServices } from '../services.tsx';
import { nextFalseColor, nextView, toggleGrid } from '../shell/actions.ts';
import { useStudio } from '../state/context.tsx';
import { pointAt, toggleCrosshair } from '../state/legend.ts';
import type { Studio } from '../state/studio.ts';
import { isFlightKey, isThrustKey } from './inputs.ts';
import type { Pilot } from './pilot.ts';

/** [rad] per pixel of dragging. */
const TURN = 0.0032;

/** Keys and mouse over the picture, while it has the focus. Returns whether it has. */
export function useFlightControls(host: RefObject<HTMLElement | null>): boolean {
  const studio = useStudio();
  const { pilot } = useServices();
  const [focused, setFocused] = useState(false);
  useEffect(() => {
    const element = host.current;
    if (!element) return;
    element.tabIndex = 0;
    const end = new AbortController();
    const on = <K extends keyof HTMLElementEventMap>(type: K, listen: (event: HTMLElementEventMap[K]) => void) =>
      element.addEventListener(type, listen, { signal: end.signal });
    on('focus', () => setFocused(true));
    on('blur', () => {
      pilot.inputs.releaseAll();
      setFocused(false);
    });
    on('keydown', (event) => pressed(event, element, pilot, studio));
    on('keyup', (event) => {
      pilot.inputs.release(event.code);
      pilot.inputs.holdFullSpeed(event.shiftKey);
    });
    on('pointerdown', (event) => {
      if (event.button === 0) element.setPointerCapture(event.pointerId);
    });
    on('pointerleave', () => pointAt(undefined));
    on('pointermove', (event) => {
      pointAt([event.offsetX / element.clientWidth, event.offsetY / element.clientHeight]);
      const held = element.hasPointerCapture(event.pointerId) || document.pointerLockElement === element;
      if (held) pilot.inputs.turn(-event.movementX * TURN, -event.movementY * TURN);
    });
    addEventListener('keydown', (event) => takeOff(event, element, pilot, studio), { signal: end.signal });
    on('dblclick', () => void element.requestPointerLock());
    return () => end.abort();
  }, [host, pilot, studio]);
  return focused;
}

/** A flight key that is pressed outside the picture brings the focus there, unless it means something where it is. */
function takeOff(event: KeyboardEvent, element: HTMLElement, pilot: Pilot, studio: Studio): void {
  if (event.ctrlKey || event.metaKey || event.altKey || !isThrustKey(event.code)) return;
  const { target } = event;
  if (!(target instanceof HTMLElement) || element.contains(target) || studio.store.getState().dialog) return;
  if (target.closest('input, textarea, [contenteditable], [role=slider], [role=menu], [role=listbox]')) return;
  element.focus();
  pressed(event, element, pilot, studio);
}

function pressed(event: KeyboardEvent, element: HTMLElement, pilot: Pilot, studio: Studio): void {
  pilot.inputs.holdFullSpeed(event.shiftKey);
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (isFlightKey(event.code)) pilot.inputs.press(event.code);
  else if (!event.repeat && !act(event.code, element, pilot, studio)) return;
  event.preventDefault();
}

/** Does what a key stands for; false: it stands for nothing here. */
function act(code: string, element: HTMLElement, pilot: Pilot, studio: Studio): boolean {
  const { cruise, maximized } = studio.store.getState();
  switch (code) {
    case 'Tab':
      pilot.nextLock();
      return true;
    case 'Escape':
      element.blur();
      return true;
    case 'Space':
      pilot.togglePlaying();
      return true;
    case 'KeyC':
      studio.change({ cruise: !cruise });
      return true;
    case 'KeyR':
      pilot.restart();
      return true;
    case 'KeyV':
      nextView(studio);
      return true;
    case 'KeyG':
      toggleGrid(studio);
      return true;
    case 'KeyX':
      nextFalseColor(studio);
      return true;
    case 'KeyP':
      toggleCrosshair();
      return true;
    case 'KeyF':
      studio.change({ maximized: !maximized });
      return true;
    default:
      return false;
  }
}
