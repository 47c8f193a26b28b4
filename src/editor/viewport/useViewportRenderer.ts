import { type RefObject, useEffect, useRef, useState } from 'react';
import { msg } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import { useServices } from '../services.tsx';
import { useEditor } from '../state/context.tsx';
import { ViewportRenderer } from './viewportRenderer.ts';

/** After this many losses within this time [ms], rendering is given up. */
const MAX_LOSSES = 3;
const LOSS_WINDOW = 60_000;

/**
 * Keeps a renderer on the canvas. After a loss of device or context a new generation starts with a new canvas;
 * document, observer and time are kept. Returns the generation, for the key of the canvas.
 */
export function useViewportRenderer(canvas: RefObject<HTMLCanvasElement | null>): number {
  const editor = useEditor();
  const services = useServices();
  const [generation, setLife] = useState(0);
  const losses = useRef<number[]>([]);

  useEffect(() => {
    let viewportRenderer: ViewportRenderer | undefined;
    let over = false;
    const begin = async (element: HTMLCanvasElement) => {
      const started = await ViewportRenderer.start(
        element,
        editor,
        services.observerController,
        services.backend,
        lost,
      );
      if (over) return started.stop();
      viewportRenderer = started;
      services.viewport.capture = () => started.capture();
      services.viewport.besides = () => started.previewContext();
      if (generation > 0 && losses.current.length > 0)
        editor.notify({ kind: 'info', text: msg`The graphics device was lost and has been restarted.` });
    };
    const lost = () => {
      if (over) return;
      const now = performance.now();
      losses.current = [...losses.current.filter((time) => now - time < LOSS_WINDOW), now];
      const failed = losses.current.length > MAX_LOSSES;
      editor.update({ graphics: failed ? 'failed' : 'recovering' });
      if (!failed) setLife((lives) => lives + 1);
    };
    if (canvas.current) {
      begin(canvas.current).catch((error: unknown) => {
        editor.notify({ kind: 'error', text: messageOf(error) });
        lost();
      });
    }
    return () => {
      over = true;
      services.viewport.capture = undefined;
      services.viewport.besides = undefined;
      viewportRenderer?.stop();
    };
  }, [canvas, editor, services, generation]);
  return generation;
}
