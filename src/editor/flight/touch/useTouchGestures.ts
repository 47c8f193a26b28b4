import { type RefObject, useEffect } from 'react';
import { useServices } from '../../services.tsx';
import { useEditor } from '../../state/context.tsx';
import { setPointer } from '../../viewport/legend/legendState.ts';
import { RADIANS_PER_PIXEL } from '../useFlightControls.ts';
import { TouchGestures } from './gestures.ts';
import { beginPinch } from './zoom.ts';

/** How long a finger rests until the menu opens [ms]. */
const REST_TIME = 500;

/** Fingers on the picture: one looks around, a tap inspects, a rest opens the menu; two zoom and roll. */
export function useTouchGestures(picture: RefObject<HTMLElement | null>): void {
  const editor = useEditor();
  const { observerController } = useServices();
  useEffect(() => {
    const element = picture.current;
    if (!element) return;
    const { inputs } = observerController;
    const gestures = new TouchGestures();
    const end = new AbortController();
    const on = (
      type: 'pointerdown' | 'pointermove' | 'pointerup' | 'pointercancel',
      act: (event: PointerEvent) => void,
    ) => element.addEventListener(type, (event) => event.pointerType === 'touch' && act(event), { signal: end.signal });
    const placeOf = ([x, y]: readonly [number, number]) => [x / element.clientWidth, y / element.clientHeight] as const;
    let rest: ReturnType<typeof setTimeout> | undefined;
    /** Whether the finger that is down has opened the menu. */
    let rested = false;
    let pinch: { readonly to: ReturnType<typeof beginPinch>; factor: number } | undefined;
    const openMenu = () => {
      const at = gestures.takeRest();
      if (!at) return;
      rested = true;
      editor.update({ pictureMenu: placeOf(at) });
    };
    on('pointerdown', ({ pointerId, offsetX, offsetY }) => {
      gestures.down(pointerId, offsetX, offsetY);
      clearTimeout(rest);
      rested = false;
      rest = setTimeout(openMenu, REST_TIME);
    });
    on('pointermove', ({ pointerId, offsetX, offsetY }) => {
      const { drag, spread, twist } = gestures.move(pointerId, offsetX, offsetY);
      inputs.turn(-drag[0] * RADIANS_PER_PIXEL, -drag[1] * RADIANS_PER_PIXEL, twist);
      if (spread === 1) return;
      pinch ??= { to: beginPinch(editor), factor: 1 };
      pinch.factor *= spread;
      pinch.to?.(pinch.factor);
    });
    const up = ({ pointerId, type }: PointerEvent) => {
      clearTimeout(rest);
      const tapped = gestures.up(pointerId);
      if (pinch) editor.endGesture();
      pinch = undefined;
      // Who measures chooses a point by it.
      if (!tapped || type !== 'pointerup' || editor.store.getState().tool === 'measure') return;
      setPointer(placeOf(tapped));
      editor.update({ tool: 'inspect' });
    };
    // A click would follow, which closes the menu.
    element.addEventListener('touchend', (event) => rested && event.cancelable && event.preventDefault(), {
      signal: end.signal,
    });
    on('pointerup', up);
    on('pointercancel', up);
    return () => {
      clearTimeout(rest);
      end.abort();
    };
  }, [picture, editor, observerController]);
}
