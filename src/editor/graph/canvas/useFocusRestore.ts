import { useEffect, useRef } from 'react';
import { useEditorState } from '../../state/context.tsx';
import { useCanvas } from './canvasState.ts';

/**
 * Focuses the canvas when the focused element was removed (by an undo, or on entering a group), so that shortcuts keep
 * working.
 */
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
  // biome-ignore lint/correctness/useExhaustiveDependencies: the rendered elements change with these
  useEffect(() => {
    const frame = requestAnimationFrame(() => {
      const { current } = last;
      const isLost = document.activeElement === document.body && current instanceof Node && !current.isConnected;
      if (isLost) panel.current?.querySelector<HTMLElement>('.sl-flow')?.focus({ preventScroll: true });
    });
    return () => cancelAnimationFrame(frame);
  }, [panel, held, path]);
}
