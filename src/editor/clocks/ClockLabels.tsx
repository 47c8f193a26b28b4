import { type ReactNode, useEffect, useRef } from 'react';
import { type Clock, clockTime } from '../../scene/clocks/clock.ts';
import { formatSeconds } from '../format.ts';
import { useFrames } from '../viewport/useFrames.ts';
import type { PreviewContext } from '../viewport/viewportRenderer.ts';
import { labelPlaces } from './labelPlaces.ts';
import { picturedClock } from './picturedClock.ts';

/** What clocks show, beside the things in the picture; the table says the same to those who cannot see it. */
export default function ClockLabels({ clocks }: { readonly clocks: readonly Clock[] }): ReactNode {
  const layer = useRef<HTMLElement>(undefined);
  const drawn = useRef<readonly [view: PreviewContext['view'], clocks: readonly Clock[]]>(undefined);
  // Past React: it changes with every picture, and is in another part of the page.
  useEffect(() => {
    const element = document.createElement('div');
    element.className = 'sl-clock-labels';
    element.ariaHidden = 'true';
    document.querySelector('[data-viewport]')?.append(element);
    layer.current = element;
    return () => {
      element.remove();
      drawn.current = undefined;
    };
  }, []);
  useFrames(({ view, renderer }) => {
    const [lastView, lastClocks] = drawn.current ?? [];
    if (!layer.current || (lastView === view && lastClocks === clocks)) return;
    if (lastClocks !== clocks) layer.current.replaceChildren(...clocks.map(newLabel));
    drawn.current = [view, clocks];
    drawLabels(layer.current, clocks, view, renderer);
  });
  return null;
}

/** A point, and a text with the last part of the path and the time. */
function newLabel({ path }: Clock): HTMLElement {
  const label = document.createElement('div');
  label.dataset.clock = path;
  const text = document.createElement('span');
  text.append(`${path.slice(path.lastIndexOf('/') + 1)} `, document.createElement('b'));
  label.append(document.createElement('i'), text);
  return label;
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
