import { useEffect, useRef } from 'react';
import { useEditorState } from '../../state/context.tsx';
import { useCanvas } from './canvasState.ts';

/** Where what had the focus goes, by an undo or into a group, the canvas has it: keys go on being heard. */
export function useFocusRestore(panel: React.RefObject<HTMLElement | null>): void {
  const last = useRef<EventTarget>(undefined);
  const held = useEditorState((state) => state.history.document);
  const path = useCanvas((state) => state.path);
  useEffect(() => {
    const host = panel.current;
    const onFocus = ({ target }: FocusEvent) => {
      last.current = target ?? undefined;
    };
    host?.addEventListener('focusin', onFocus);
    return () => host?.removeEventListener('focusin', onFocus);
  }, [panel]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: what is shown changes with these
  useEffect(() => {
    const frame = requestAnimationFrame(() => {
      const { current } = last;
      const isLost = document.activeElement === document.body && current instanceof Node && !current.isConnected;
      if (isLost) panel.current?.querySelector<HTMLElement>('.sl-flow')?.focus({ preventScroll: true });
    });
    return () => cancelAnimationFrame(frame);
  }, [panel, held, path]);
}
