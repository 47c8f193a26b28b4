import { type RefObject, useEffect, useState } from 'react';
import { useServices } from '../services.tsx';
import { nextFalseColor, nextView, toggleGrid, toggleTool } from '../shell/actions.ts';
import { useEditor } from '../state/context.tsx';
import type { Editor } from '../state/editor.ts';
import { setPointer, toggleCrosshair } from '../viewport/legend/legendState.ts';
import { isFlightKey, isThrustKey } from './inputState.ts';
import type { ObserverController } from './observerController.ts';

/** [rad] per pixel of dragging. */
export const RADIANS_PER_PIXEL = 0.0032;

/** Keyboard and mouse input of the viewport while it has the focus. Returns whether it has the focus. */
export function useFlightControls(host: RefObject<HTMLElement | null>): boolean {
  const editor = useEditor();
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
    on('keydown', (event) => handleKeyDown(event, element, observerController, editor));
    on('keyup', (event) => {
      observerController.inputs.release(event.code);
      observerController.inputs.holdFullSpeed(event.shiftKey);
    });
    on('pointerdown', (event) => {
      if (event.button === 0) element.setPointerCapture(event.pointerId);
    });
    // What a finger points at stays when it is lifted.
    on('pointerleave', ({ pointerType }) => pointerType !== 'touch' && setPointer(undefined));
    on('contextmenu', (event) => {
      event.preventDefault();
      // Fingers ask for it by resting (touch/useTouchGestures.ts), on every system.
      const { pointerType, offsetX, offsetY } = event as PointerEvent;
      if (pointerType !== 'touch')
        editor.update({ pictureMenu: [offsetX / element.clientWidth, offsetY / element.clientHeight] });
    });
    on('pointermove', (event) => {
      setPointer([event.offsetX / element.clientWidth, event.offsetY / element.clientHeight]);
      if (event.pointerType === 'touch') return;
      const held = element.hasPointerCapture(event.pointerId) || document.pointerLockElement === element;
      if (held)
        observerController.inputs.turn(-event.movementX * RADIANS_PER_PIXEL, -event.movementY * RADIANS_PER_PIXEL);
    });
    addEventListener('keydown', (event) => focusOnFlightKey(event, element, observerController, editor), {
      signal: end.signal,
    });
    on('dblclick', () => void element.requestPointerLock());
    return () => end.abort();
  }, [host, observerController, editor]);
  return focused;
}

/** Focuses the viewport when a flight key is pressed elsewhere, unless the focused element uses the key. */
function focusOnFlightKey(
  event: KeyboardEvent,
  element: HTMLElement,
  observerController: ObserverController,
  editor: Editor,
): void {
  if (event.ctrlKey || event.metaKey || event.altKey || !isThrustKey(event.code)) return;
  const { target } = event;
  if (!(target instanceof HTMLElement) || element.contains(target) || editor.store.getState().dialog) return;
  if (target.closest('input, textarea, [contenteditable], [role=slider], [role=menu], [role=listbox]')) return;
  element.focus();
  handleKeyDown(event, element, observerController, editor);
}

function handleKeyDown(
  event: KeyboardEvent,
  element: HTMLElement,
  observerController: ObserverController,
  editor: Editor,
): void {
  observerController.inputs.holdFullSpeed(event.shiftKey);
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (isFlightKey(event.code)) observerController.inputs.press(event.code);
  else if (!event.repeat && !runKeyAction(event.code, element, observerController, editor)) return;
  event.preventDefault();
}

/** Runs the action of a key; returns false if it has none. */
function runKeyAction(
  code: string,
  element: HTMLElement,
  observerController: ObserverController,
  editor: Editor,
): boolean {
  const { cruise, maximized, outsideView } = editor.store.getState();
  const deck = async () => (await import('./deck/openDeck.ts')).openDeck(editor, observerController);
  switch (code) {
    case 'Tab':
      observerController.cycleLock();
      return true;
    case 'Escape':
      element.blur();
      return true;
    case 'Space':
      observerController.togglePlaying();
      return true;
    case 'KeyT':
      void deck().then((loaded) => loaded.next());
      return true;
    case 'KeyK':
      void deck().then((loaded) => loaded.toggleRecording());
      return true;
    case 'KeyH':
      void import('./hold/hold.ts').then(({ toggleHold }) => toggleHold(editor, observerController));
      return true;
    case 'KeyO':
      editor.update({ outsideView: !outsideView });
      return true;
    case 'KeyC':
      editor.update({ cruise: !cruise });
      return true;
    case 'KeyR':
      observerController.restart();
      return true;
    case 'KeyB':
      observerController.turnBack();
      return true;
    case 'KeyV':
      nextView(editor);
      return true;
    case 'KeyG':
      toggleGrid(editor);
      return true;
    case 'KeyX':
      nextFalseColor(editor);
      return true;
    case 'KeyP':
      toggleCrosshair();
      return true;
    case 'KeyI':
      toggleTool(editor, 'inspect');
      return true;
    case 'KeyM':
      toggleTool(editor, 'measure');
      return true;
    case 'KeyF':
      editor.update({ maximized: !maximized });
      return true;
    default:
      return false;
  }
}
