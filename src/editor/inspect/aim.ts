import { type RefObject, useEffect, useRef } from 'react';
import { isFlightKey } from '../flight/inputState.ts';
import { legendStore, type PicturePosition } from '../viewport/legend/legendState.ts';

const CENTER: PicturePosition = [0.5, 0.5];
/** A press that moves less is a click [px]; a tap moves more. */
const CLICK_RADIUS = { mouse: 5, touch: 10 } as const;

/** Called by keys and clicks on the picture. */
export interface AimActions {
  /** A click, or Enter. */
  readonly choose?: (place: PicturePosition) => void;
  /** Escape. */
  readonly end: () => void;
}

/** Where the tools aim: at the pointer, or at the middle while one flies by keys, has captured the mouse, or has no pointer over the picture. */
export function useAim(picture: RefObject<HTMLElement | null>, actions: AimActions): () => PicturePosition {
  const byKeys = useRef(false);
  const latest = useRef(actions);
  latest.current = actions;
  const aim = useRef((): PicturePosition => {
    const { pointer } = legendStore.getState();
    return byKeys.current || document.pointerLockElement || !pointer ? CENTER : pointer;
  });
  useEffect(() => {
    const element = picture.current;
    if (!element) return;
    const end = new AbortController();
    const on = <K extends keyof HTMLElementEventMap>(type: K, listen: (event: HTMLElementEventMap[K]) => void) =>
      element.addEventListener(type, listen, { signal: end.signal, capture: true });
    on('keydown', (event) => {
      if (isFlightKey(event.code)) byKeys.current = true;
      const act =
        event.code === 'Escape'
          ? latest.current.end
          : event.code === 'Enter' && latest.current.choose && !event.repeat
            ? () => latest.current.choose?.(aim.current())
            : undefined;
      if (!act) return;
      act();
      // Escape would leave the picture as well.
      event.preventDefault();
      event.stopImmediatePropagation();
    });
    let pressed: readonly [number, number] | undefined;
    on('pointermove', () => {
      byKeys.current = false;
    });
    on('pointerdown', (event) => {
      pressed = event.button === 0 ? [event.clientX, event.clientY] : undefined;
    });
    on('pointerup', (event) => {
      const from = pressed;
      const radius = CLICK_RADIUS[event.pointerType === 'touch' ? 'touch' : 'mouse'];
      pressed = undefined;
      if (!from || Math.hypot(event.clientX - from[0], event.clientY - from[1]) > radius) return;
      const { left, top, width, height } = element.getBoundingClientRect();
      const place: PicturePosition = [(event.clientX - left) / width, (event.clientY - top) / height];
      latest.current.choose?.(document.pointerLockElement ? CENTER : place);
    });
    return () => end.abort();
  }, [picture]);
  return aim.current;
}

export const isCenter = (place: PicturePosition): boolean => place === CENTER;
