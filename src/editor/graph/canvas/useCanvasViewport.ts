import { useReactFlow, useStoreApi } from '@xyflow/react';
import { useEffect, useRef } from 'react';
import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import { useEditorState } from '../../state/context.tsx';
import { prefersReducedMotion } from '../../state/preferences.ts';
import { type CanvasRect, cardSize } from '../cards/cardGeometry.ts';
import type { CardModel } from '../cards/cardModel.ts';
import { type CanvasViewport, canvas } from './canvasState.ts';
import { fitTransform } from './fitView.ts';
import type { FlowNode, WireEdge } from './flowElements.ts';

const TRANSITION_DURATION = 200; // [ms]
const transitionDuration = (): number => (prefersReducedMotion() ? 0 : TRANSITION_DURATION);
/** Overlays on the canvas. */
const OVERLAYS = '.sl-graph-tools, .sl-breadcrumb, .react-flow__minimap';

interface ShownGraph {
  /** Card models with all pictures, also those hidden because they would cover other nodes. */
  readonly uncropped: ReadonlyMap<string, CardModel>;
  readonly cards: ReadonlyMap<string, CardModel>;
  readonly places: Readonly<Record<string, CanvasPoint>>;
  /** Nodes as drawn, with notes and frames. */
  readonly nodes: readonly FlowNode[];
}

/** Rectangles of the given nodes, or of all. */
const flowRects = (nodes: readonly FlowNode[], ids?: readonly string[]): readonly CanvasRect[] =>
  nodes
    .filter(({ id }) => !ids || ids.includes(id))
    .map(({ position: { x, y }, width = 0, height = 0 }) => ({ at: [x, y], size: [width, height] }));

function overlayRects(panel: HTMLElement | null): readonly CanvasRect[] {
  const corner = panel?.getBoundingClientRect();
  if (!panel || !corner) return [];
  const boxes = [...panel.querySelectorAll(OVERLAYS)].map((element): CanvasRect => {
    const { left, top, width, height } = element.getBoundingClientRect();
    return { at: [left - corner.left, top - corner.top], size: [width, height] };
  });
  return boxes.filter(({ size }) => size[0] > 0);
}

/** Provides `CanvasViewport` to actions. */
export function useCanvasViewport(shown: ShownGraph, panel: React.RefObject<HTMLElement | null>): void {
  const flow = useReactFlow<FlowNode, WireEdge>();
  const store = useStoreApi<FlowNode, WireEdge>();
  const now = useRef(shown);
  now.current = shown;
  useEffect(() => {
    const sizeIn = (cards: ReadonlyMap<string, CardModel>, id: string): CanvasPoint => {
      const card = cards.get(id);
      return card ? cardSize(card) : [0, 0];
    };
    const sizeOfNode = (id: string): CanvasPoint => sizeIn(now.current.cards, id);
    const placeOf = (id: string): CanvasPoint => now.current.places[id] ?? [0, 0];
    const viewport: CanvasViewport = {
      center: () => {
        const { width, height, transform } = store.getState();
        const [x, y, zoom] = transform;
        return [(width / 2 - x) / zoom, (height / 2 - y) / zoom];
      },
      toPanel: ([x, y]) => {
        const [left, top, zoom] = store.getState().transform;
        return [x * zoom + left, y * zoom + top];
      },
      fit: (nodes, swing = transitionDuration()) => {
        const { width, height } = store.getState();
        const view = fitTransform(flowRects(now.current.nodes, nodes), [width, height], overlayRects(panel.current));
        if (view) void flow.setViewport(view, { duration: swing });
      },
      zoom: (factor) => void flow.zoomTo(flow.getZoom() * factor, { duration: transitionDuration() }),
      sizeOf: sizeOfNode,
      sizeWithPicture: (id) => sizeIn(now.current.uncropped, id),
      positionOf: placeOf,
      reveal: (node) => {
        const { width, height, transform } = store.getState();
        const [left, top, zoom] = transform;
        const [at, size] = [placeOf(node), sizeOfNode(node)];
        const isIn = (axis: 0 | 1, offset: number, room: number): boolean =>
          at[axis] * zoom + offset >= 0 && (at[axis] + size[axis]) * zoom + offset <= room;
        if (isIn(0, left, width) && isIn(1, top, height)) return;
        void flow.setCenter(at[0] + size[0] / 2, at[1] + size[1] / 2, { zoom, duration: transitionDuration() });
      },
      isVisible: (node) => {
        const { width, height, transform } = store.getState();
        const [left, top, zoom] = transform;
        const [at, size] = [placeOf(node), sizeOfNode(node)];
        const overlaps = (axis: 0 | 1, offset: number, room: number): boolean =>
          (at[axis] + size[axis]) * zoom + offset > 0 && at[axis] * zoom + offset < room;
        return overlaps(0, left, width) && overlaps(1, top, height);
      },
      focus: (node) => {
        const give = (selector: string) =>
          panel.current?.querySelector<HTMLElement>(selector)?.focus({ preventScroll: true });
        if (node === undefined) {
          give('.sl-flow');
          return;
        }
        // Waits until a node that was just added is rendered.
        requestAnimationFrame(() => {
          give(`.react-flow__node[data-id="${node}"]`);
          viewport.reveal(node);
        });
      },
    };
    canvas.setState({ viewport });
    // Fits all nodes initially, once the panel has a size.
    const fitAll = (): boolean => {
      if (store.getState().width === 0) return false;
      viewport.fit(undefined, 0);
      return true;
    };
    const unwatch = fitAll() ? () => {} : store.subscribe(() => fitAll() && unwatch());
    return () => {
      unwatch();
      canvas.setState({ viewport: undefined, adding: undefined, editing: undefined });
    };
  }, [flow, store, panel]);
  // Another project is another graph.
  const origin = useEditorState(({ history }) => history.origin);
  const fitted = useRef(origin);
  useEffect(() => {
    if (fitted.current === origin) return;
    fitted.current = origin;
    canvas.getState().viewport?.fit(undefined, 0);
  }, [origin]);
}
