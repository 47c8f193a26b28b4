import './vignette.css';
import { type ReactNode, useEffect, useMemo, useRef } from 'react';
import { useStore } from 'zustand';
import { VIGNETTE_LOOKS } from '../../../flight/comfort/vignette.ts';
import { useServices } from '../../services.tsx';
import { useEditor } from '../../state/context.tsx';
import { openComfort, vignetteOf } from './comfort.ts';

/** Darkens the rim over the picture while it flows fast; no part of the picture, or of what is saved. */
export default function Vignette(): ReactNode {
  const editor = useEditor();
  const { observerController } = useServices();
  const { store } = useMemo(() => openComfort(editor, observerController), [editor, observerController]);
  const shade = useRef<HTMLDivElement>(null);
  const strength = useStore(store, vignetteOf);
  const { reach, dark } = VIGNETTE_LOOKS[strength];
  // Past React: it changes with every picture.
  useEffect(() => {
    const close = (closing: number): void => {
      shade.current!.style.setProperty('--sl-clear', `${100 * (1 - reach * closing)}%`);
      shade.current!.dataset.closing = closing.toFixed(2);
    };
    close(store.getState().closing);
    return store.subscribe(({ closing }) => close(closing));
  }, [store, reach]);
  return <div ref={shade} className="sl-vignette" style={{ opacity: dark }} data-vignette={strength} aria-hidden />;
}
