import { type ReactNode, useEffect, useRef } from 'react';
import type { Clock } from '../../scene/clocks/clock.ts';
import { useFrames } from '../viewport/useFrames.ts';
import { LabelLayer } from './labelLayer.ts';

/** What clocks show, beside the things in the picture; the table says the same to those who cannot see it. */
export default function ClockLabels({ clocks }: { readonly clocks: readonly Clock[] }): ReactNode {
  const layer = useRef<LabelLayer>(undefined);
  // Past React: it changes with every picture, and is in another part of the page.
  useEffect(() => {
    const made = new LabelLayer();
    document.querySelector('[data-viewport]')?.append(made.element);
    layer.current = made;
    return () => {
      made.element.remove();
      layer.current = undefined;
    };
  }, []);
  useFrames((shown, now) => layer.current?.follow(clocks, shown, now));
  return null;
}
