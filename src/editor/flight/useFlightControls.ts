import { type RefObject, useEffect, useState } from 'react';
import { useServices } from '../services.tsx';
import { nextFalseColor, nextView, toggleGrid } from '../shell/actions.ts';
import { useEditor } from '../state/context.tsx';
import type { Editor } from '../state/editor.ts';
import { setPointer, toggleCrosshair } from '../viewport/legend/legendState.ts';
import { isFlightKey, isThrustKey } from './inputState.ts';
import type { ObserverController } from './observerController.ts';

/** [rad] per pixel of dragging. */
const RADIANS_PER_PIXEL = 0.0032;

/** Keyboard and mouse input of the viewport while it has the focus. Returns whether it has the focus. */
export function useFlightControls(host: RefObject<HTMLElement | null>): boolean {
  const studio = useEditor();
  const { observerController } = useServices();
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
      observerController.inputs.releaseAll();
      setFocused(false);
    });
    on('keydown', (event) => handleKeyDown(event, element, observerController, studio));
    on('keyup', (event) => {
      observerController.inputs.release(event.code);
      observerController.inputs.holdFullSpeed(event.shiftKey);
    });
    on('pointerdown', (event) => {
      if (event.button === 0) element.setPointerCapture(event.pointerId);
    });
    on('pointerleave', () => setPointer(undefined));
    on('pointermove', (event) => {
      setPointer([event.offsetX / element.clientWidth, event.offsetY / element.clientHeight]);
      const held = element.hasPointerCapture(event.pointerId) || document.pointerLockElement === element;
      if (held)
        observerController.inputs.turn(-event.movementX * RADIANS_PER_PIXEL, -event.movementY * RADIANS_PER_PIXEL);
    });
    addEventListener('keydown', (event) => focusOnFlightKey(event, element, observerController, studio), {
      signal: end.signal,
    });
    on('dblclick', () => void element.requestPointerLock());
    return () => end.abort();
  }, [host, observerController, studio]);
  return focused;
}

/** Focuses the viewport when a flight key is pressed elsewhere, unless the focused element uses the key. */
function focusOnFlightKey(event: KeyboardEvent, element: HTMLElement, pilot: ObserverController, studio: Editor): void {
  if (event.ctrlKey || event.metaKey || event.altKey || !isThrustKey(event.code)) return;
  const { target } = event;
  if (!(target instanceof HTMLElement) || element.contains(target) || studio.store.getState().dialog) return;
  if (target.closest('input, textarea, [contenteditable], [role=slider], [role=menu], [role=listbox]')) return;
  element.focus();
  handleKeyDown(event, element, pilot, studio);
}

function handleKeyDown(event: KeyboardEvent, element: HTMLElement, pilot: ObserverController, studio: Editor): void {
  pilot.inputs.holdFullSpeed(event.shiftKey);
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (isFlightKey(event.code)) pilot.inputs.press(event.code);
  else if (!event.repeat && !runKeyAction(event.code, element, pilot, studio)) return;
  event.preventDefault();
}

/** Runs the action of a key; returns false if it has none. */
function runKeyAction(code: string, element: HTMLElement, pilot: ObserverController, studio: Editor): boolean {
  const { cruise, maximized } = studio.store.getState();
  switch (code) {
    case 'Tab':
      pilot.cycleLock();
      return true;
    case 'Escape':
      element.blur();
      return true;
    case 'Space':
      pilot.togglePlaying();
      return true;
    case 'KeyC':
      studio.update({ cruise: !cruise });
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
      studio.update({ maximized: !maximized });
      return true;
    default:
      return false;
  }
}
