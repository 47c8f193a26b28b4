import { type RefObject, useEffect, useRef, useState } from 'react';
import { useTexts } from '../i18n/i18n.ts';
import { useServices } from '../services.tsx';
import { useStudio } from '../state/context.tsx';
import { Stage } from './stage.ts';

/** So many losses within so long [ms], and the device is given up. */
const MOST_LOSSES = 3;
const WITHIN = 60_000;

/**
 * Keeps a renderer on the canvas. When the device or the context is lost, a new life begins with a new canvas: the document,
 * the observer and the time go on where they were. Returns the number of the life, the key of the canvas.
 */
export function useStage(canvas: RefObject<HTMLCanvasElement | null>): number {
  const { t } = useTexts();
  const studio = useStudio();
  const services = useServices();
  const [life, setLife] = useState(0);
  const losses = useRef<number[]>([]);
  const say = useRef(t);
  say.current = t;

  useEffect(() => {
    let stage: Stage | undefined;
    let over = false;
    const begin = async (element: HTMLCanvasElement) => {
      const started = await Stage.start(element, studio, services.pilot, services.backend, lost);
      if (over) return started.stop();
      stage = started;
      services.stage.capture = () => started.capture();
      services.stage.besides = () => started.besides();
      if (life > 0 && losses.current.length > 0) studio.notify({ kind: 'info', text: say.current('notice.recovered') });
    };
    const lost = () => {
      if (over) return;
      const now = performance.now();
      losses.current = [...losses.current.filter((time) => now - time < WITHIN), now];
      const failed = losses.current.length > MOST_LOSSES;
      studio.change({ graphics: failed ? 'failed' : 'recovering' });
      if (!failed) setLife((lives) => lives + 1);
    };
    if (canvas.current) {
      begin(canvas.current).catch((error: unknown) => {
        const text = error instanceof Error ? error.message : String(error);
        studio.notify({ kind: 'error', text });
        lost();
      });
    }
    return () => {
      over = true;
      services.stage.capture = undefined;
      services.stage.besides = undefined;
      stage?.stop();
    };
  }, [canvas, studio, services, life]);
  return life;
}
