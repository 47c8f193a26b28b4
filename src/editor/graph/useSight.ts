import { useReactFlow, useStoreApi } from '@xyflow/react';
import { useEffect, useRef } from 'react';
import type { Point } from '../../graph/commands.ts';
import { prefersReducedMotion } from '../state/preferences.ts';
import { canvas, type Sight } from './canvas.ts';
import type { Face } from './face.ts';
import type { FlowNode, WireEdge } from './flow.ts';
import { viewOf } from './framing.ts';
import { type Box, sizeOf } from './shape.ts';

const SWING = 200; // [ms]
const duration = (): number => (prefersReducedMotion() ? 0 : SWING);
/** What lies over the canvas. */
const OVERLAYS = '.sl-graph-tools, .sl-breadcrumb, .react-flow__minimap';

interface Shown {
  /** With all the pictures that there would be room for elsewhere. */
  readonly whole: ReadonlyMap<string, Face>;
  readonly faces: ReadonlyMap<string, Face>;
  readonly places: Readonly<Record<string, Point>>;
  /** As they are drawn, with notes and frames. */
  readonly nodes: readonly FlowNode[];
}

/** Of some nodes, or of all that there is. */
const boxesOf = (nodes: readonly FlowNode[], ids?: readonly string[]): readonly Box[] =>
  nodes
    .filter(({ id }) => !ids || ids.includes(id))
    .map(({ position: { x, y }, width = 0, height = 0 }) => ({ at: [x, y], size: [width, height] }));

function overlaysIn(panel: HTMLElement | null): readonly Box[] {
  const corner = panel?.getBoundingClientRect();
  if (!panel || !corner) return [];
  const boxes = [...panel.querySelectorAll(OVERLAYS)].map((element): Box => {
    const { left, top, width, height } = element.getBoundingClientRect();
    return { at: [left - corner.left, top - corner.top], size: [width, height] };
  });
  return boxes.filter(({ size }) => size[0] > 0);
}

/** Lets actions know, and change, what part of the canvas is seen. */
export function useSight(shown: Shown, panel: React.RefObject<HTMLElement | null>): void {
  const flow = useReactFlow<FlowNode, WireEdge>();
  const store = useStoreApi<FlowNode, WireEdge>();
  const now = useRef(shown);
  now.current = shown;
  useEffect(() => {
    const sizeIn = (faces: ReadonlyMap<string, Face>, id: string): Point => {
      const face = faces.get(id);
      return face ? sizeOf(face) : [0, 0];
    };
    const sizeOfNode = (id: string): Point => sizeIn(now.current.faces, id);
    const placeOf = (id: string): Point => now.current.places[id] ?? [0, 0];
    const sight: Sight = {
      middle: () => {
        const { width, height, transform } = store.getState();
        const [x, y, zoom] = transform;
        return [(width / 2 - x) / zoom, (height / 2 - y) / zoom];
      },
      inPanel: ([x, y]) => {
        const [left, top, zoom] = store.getState().transform;
        return [x * zoom + left, y * zoom + top];
      },
      fit: (nodes, swing = duration()) => {
        const { width, height } = store.getState();
        const view = viewOf(boxesOf(now.current.nodes, nodes), [width, height], overlaysIn(panel.current));
        if (view) void flow.setViewport(view, { duration: swing });
      },
      zoom: (factor) => void flow.zoomTo(flow.getZoom() * factor, { duration: duration() }),
      sizeOf: sizeOfNode,
      roomFor: (id) => sizeIn(now.current.whole, id),
      placeOf,
      show: (node) => {
        const { width, height, transform } = store.getState();
        const [left, top, zoom] = transform;
        const [at, size] = [placeOf(node), sizeOfNode(node)];
        const isIn = (axis: 0 | 1, offset: number, room: number): boolean =>
          at[axis] * zoom + offset >= 0 && (at[axis] + size[axis]) * zoom + offset <= room;
        if (isIn(0, left, width) && isIn(1, top, height)) return;
        void flow.setCenter(at[0] + size[0] / 2, at[1] + size[1] / 2, { zoom, duration: duration() });
      },
      sees: (node) => {
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
        // What was just added is drawn first.
        requestAnimationFrame(() => {
          give(`.react-flow__node[data-id="${node}"]`);
          sight.show(node);
        });
      },
    };
    canvas.setState({ sight });
    // At first all is in sight, once the panel has its size.
    const look = (): boolean => {
      if (store.getState().width === 0) return false;
      sight.fit(undefined, 0);
      return true;
    };
    const unwatch = look() ? () => {} : store.subscribe(() => look() && unwatch());
    return () => {
      unwatch();
      canvas.setState({ sight: undefined, adding: undefined, writing: undefined });
    };
  }, [flow, store, panel]);
}
