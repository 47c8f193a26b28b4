import { ActionIcon, Group, Text, Tooltip, useComputedColorScheme } from '@mantine/core';
import { type KeyboardEvent, type PointerEvent, type ReactNode, useEffect, useRef, useState } from 'react';
import type { Diagram, PixelPoint } from '../../diagrams/marks.ts';
import type { SpacetimeDiagram } from '../../diagrams/spacetimeDiagram.ts';
import { diagramSvg } from '../../diagrams/svg.ts';
import { msg } from '../../messages/message.ts';
import type { ObserverState } from '../../physics/lorentz/observer.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import { formatSeconds } from '../format.ts';
import { useTexts } from '../language/languageStore.ts';
import { useServices } from '../services.tsx';
import { useTelemetry } from '../state/context.tsx';
import { movedBy } from './observerMoves.ts';

/** The diagram for an observer; `span`: half its x axis [m], absent: what shows all events. */
export type DrawDiagram = (
  observer: ObserverState,
  size: PictureSize,
  span: number | undefined,
) => Diagram | SpacetimeDiagram;

interface ViewProps {
  readonly draw: DrawDiagram;
  /** Whether the observer's event can be moved in it. */
  readonly movable: boolean;
}

const ZOOM = 1.25;
/** Step of an arrow key, in parts of the axis. */
const STEP = 0.02;
/** Room below the plot of a narrow picture for the legend [px]. */
const LEGEND = 250;

/** The picture follows the observer at the rate of the screen. Dragging it, and the arrow keys, move the observer's event. */
export function DiagramView({ draw, movable }: ViewProps): ReactNode {
  const { t } = useTexts();
  const { observerController } = useServices();
  const host = useRef<HTMLDivElement>(null);
  const [span, setSpan] = useState<number>();
  const shown = useLiveDiagram(host, draw, span);
  const time = useTelemetry((live) => live.t);
  const drag = useRef<{ from: PixelPoint; diagram: SpacetimeDiagram; observer: ObserverState } | undefined>(undefined);
  const spacetime = () => (shown.current && 'span' in shown.current ? shown.current : undefined);
  const zoom = (factor: number) => setSpan((spacetime()?.span ?? 1) * factor);
  const c = observerController.picture?.speedOfLight ?? 1;

  const move = (diagram: SpacetimeDiagram, observer: ObserverState, from: PixelPoint, to: PixelPoint) => {
    const [a, b] = [diagram.eventAtPixel(from), diagram.eventAtPixel(to)];
    // The picture follows the pointer: the observer goes the other way.
    observerController.place(movedBy(movedBy(observer, b, -1, c), a, 1, c));
  };
  const onPointerDown = (event: PointerEvent<HTMLDivElement>) => {
    const diagram = spacetime();
    if (!movable || !diagram || event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    if (span === undefined) setSpan(diagram.span);
    drag.current = { from: pixelOf(event), diagram, observer: observerController.observer };
  };
  const onPointerMove = (event: PointerEvent<HTMLDivElement>) => {
    if (drag.current) move(drag.current.diagram, drag.current.observer, drag.current.from, pixelOf(event));
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const diagram = spacetime();
    const step = STEPS[event.key];
    if (!movable || !diagram) return;
    if (event.key === '+') zoom(1 / ZOOM);
    else if (event.key === '-') zoom(ZOOM);
    else if (step) {
      if (span === undefined) setSpan(diagram.span);
      const size = STEP * diagram.height;
      const middle: PixelPoint = [diagram.width / 2, diagram.height / 2];
      move(diagram, observerController.observer, middle, [middle[0] - step[0] * size, middle[1] + step[1] * size]);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const zoomButtons = [
    [msg`Closer`, '+', () => zoom(1 / ZOOM)],
    [msg`Farther`, '−', () => zoom(ZOOM)],
    [msg`Show all events`, '⤢', () => setSpan(undefined)],
  ] as const;
  const label = msg`Observer’s event in the diagram: arrow keys move it in time and place, plus and minus zoom`;
  return (
    <>
      {movable ? (
        <div
          className="sl-diagram"
          role="slider"
          tabIndex={0}
          aria-label={t(label)}
          aria-valuenow={time}
          aria-valuetext={formatSeconds(time)}
          onPointerDown={onPointerDown}
          onPointerMove={onPointerMove}
          onPointerUp={() => {
            drag.current = undefined;
          }}
          onKeyDown={onKeyDown}
        >
          <div ref={host} data-diagram />
        </div>
      ) : (
        <div ref={host} className="sl-diagram" data-diagram />
      )}
      {movable && (
        <Group gap={4}>
          {zoomButtons.map(([title, sign, act]) => (
            <Tooltip key={sign} label={t(title)} openDelay={400}>
              <ActionIcon size="sm" variant="default" aria-label={t(title)} onClick={act}>
                {sign}
              </ActionIcon>
            </Tooltip>
          ))}
        </Group>
      )}
      <Description shown={shown} />
    </>
  );
}

/** To the right and up, in steps. */
const STEPS: Readonly<Record<string, PixelPoint>> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

function pixelOf(event: PointerEvent<HTMLDivElement>): PixelPoint {
  const { left, top } = event.currentTarget.getBoundingClientRect();
  return [event.clientX - left, event.clientY - top];
}

/** The description of the picture as text, at the rate of the instruments. */
function Description({ shown }: { readonly shown: React.RefObject<Diagram | undefined> }): ReactNode {
  const { t } = useTexts();
  useTelemetry((live) => live.t);
  return (
    <Text size="xs" c="dimmed" lh={1.5}>
      {shown.current && t(shown.current.description)}
    </Text>
  );
}

/** Draws into the host whenever the observer, the size or the diagram has changed and the host is visible. */
function useLiveDiagram(
  host: React.RefObject<HTMLDivElement | null>,
  draw: DrawDiagram,
  span: number | undefined,
): React.RefObject<Diagram | SpacetimeDiagram | undefined> {
  const { t } = useTexts();
  const { observerController } = useServices();
  const scheme = useComputedColorScheme('dark');
  const shown = useRef<Diagram | SpacetimeDiagram>(undefined);
  useEffect(() => {
    const parser = new DOMParser();
    let drawn = '';
    let frame = requestAnimationFrame(function next() {
      frame = requestAnimationFrame(next);
      const element = host.current;
      const width = element?.clientWidth ?? 0;
      if (!element || width === 0) return;
      const observer = observerController.observer;
      const state = [width, observer.t, ...observer.position, ...observer.u].join();
      if (state === drawn) return;
      drawn = state;
      const height = width >= 560 ? Math.round(0.62 * width) : Math.round(width + LEGEND);
      shown.current = draw(observer, { width, height }, span);
      // Parsed as XML, not as HTML: the text is our own, and names in it are escaped.
      const svg = parser.parseFromString(diagramSvg(shown.current, scheme, t), 'image/svg+xml').documentElement;
      element.replaceChildren(document.importNode(svg, true));
    });
    return () => cancelAnimationFrame(frame);
  }, [host, draw, span, scheme, t, observerController]);
  return shown;
}
