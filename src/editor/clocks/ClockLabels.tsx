import { type ReactNode, useRef } from 'react';
import { createPortal } from 'react-dom';
import { type Clock, clockTime } from '../../scene/clocks/clock.ts';
import { formatSeconds } from '../format.ts';
import { useFrames } from '../viewport/useFrames.ts';
import type { PreviewContext } from '../viewport/viewportRenderer.ts';
import { labelPlaces } from './labelPlaces.ts';
import { picturedClock } from './picturedClock.ts';

/** What clocks show, beside the things in the picture; the table says the same to those who cannot see it. */
export default function ClockLabels({ clocks }: { readonly clocks: readonly Clock[] }): ReactNode {
  const layer = useRef<HTMLDivElement>(null);
  const drawn = useRef<readonly [view: PreviewContext['view'], clocks: readonly Clock[]]>(undefined);
  useFrames(({ view, renderer }) => {
    if (!layer.current || (drawn.current?.[0] === view && drawn.current[1] === clocks)) return;
    drawn.current = [view, clocks];
    drawLabels(layer.current, clocks, view, renderer);
  });
  const picture = document.querySelector('[data-viewport]');
  if (!picture) return null;
  return createPortal(
    <div ref={layer} className="sl-clock-labels" aria-hidden>
      {clocks.map(({ path }) => (
        <div key={path} data-clock={path} hidden>
          <i />
          <span>
            {path.slice(path.lastIndexOf('/') + 1)} <b />
          </span>
        </div>
      ))}
    </div>,
    picture,
  );
}

/** Moves the labels, which are the children of `layer` in the order of `clocks`, to where a picture shows these. */
function drawLabels(
  layer: HTMLElement,
  clocks: readonly Clock[],
  { viewPoint, settings }: PreviewContext['view'],
  size: PreviewContext['renderer'],
): void {
  const frame = { width: layer.clientWidth, height: layer.clientHeight };
  const shown = clocks.flatMap((clock, i) => {
    const label = layer.children[i] as HTMLElement;
    const seen = picturedClock(clock, viewPoint, settings, size);
    label.hidden = !seen;
    if (!seen) return [];
    const [point, text] = label.children as unknown as [HTMLElement, HTMLElement];
    text.querySelector('b')!.textContent = formatSeconds(clockTime(clock, seen.time, settings.speedOfLight));
    return [{ point, text, x: seen.place[0] * frame.width, y: seen.place[1] * frame.height }];
  });
  const sized = shown.map(({ text, x, y }) => ({ x, y, width: text.offsetWidth, height: text.offsetHeight }));
  const places = labelPlaces(sized, frame);
  shown.forEach(({ point, text, x, y }, i) => {
    point.style.transform = `translate(${x}px, ${y}px)`;
    text.style.transform = `translate(${places[i]![0]}px, ${places[i]![1]}px)`;
  });
}
