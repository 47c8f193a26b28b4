import { useEffect, useRef } from 'react';
import { useServices } from '../services.tsx';
import type { PreviewContext } from './viewportRenderer.ts';

/** Calls `each` for the displayed picture before every paint. */
export function useFrames(each: (picture: PreviewContext, now: number) => void): void {
  const { viewport } = useServices();
  const latest = useRef(each);
  latest.current = each;
  useEffect(() => {
    let frame = requestAnimationFrame(function tick(now) {
      frame = requestAnimationFrame(tick);
      const shown = viewport.besides?.();
      if (shown) latest.current(shown, now);
    });
    return () => cancelAnimationFrame(frame);
  }, [viewport]);
}
