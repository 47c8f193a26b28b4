import { type Connection, type FinalConnectionState, useReactFlow } from '@xyflow/react';
import { useMemo, useRef } from 'react';
import type { Point } from '../../graph/commands.ts';
import type { GraphEdge } from '../../graph/document.ts';
import { inside } from '../../graph/edits/fragment.ts';
import type { Level } from '../../graph/sockets.ts';
import { useStudio } from '../state/context.tsx';
import { canvas, levelAt } from './canvas.ts';
import { bending, connecting, isThere, reconnecting } from './edits.ts';
import type { Face } from './face.ts';
import { fitsOf, type Loose, offersOf, otherSide } from './fit.ts';
import { type FlowNode, thingOf, type WireEdge } from './flow.ts';

/** What becomes of edges that are drawn, drawn elsewhere, dropped and bent. */
export function useWiring(faces: ReadonlyMap<string, Face>, panel: React.RefObject<HTMLElement | null>) {
  const studio = useStudio();
  const { screenToFlowPosition } = useReactFlow<FlowNode, WireEdge>();
  const shown = useRef(faces);
  shown.current = faces;
  /** The edge whose end was taken up. */
  const carried = useRef<GraphEdge>(undefined);
  return useMemo(() => {
    const levelNow = (): Level => levelAt(studio.store.getState().history.document, canvas.getState().path);
    const draw = (edge: GraphEdge) => {
      const level = levelNow();
      if (!isThere(level, edge)) studio.edit(connecting(level, edge), 'edit.connect');
    };
    const toPanel = ([x, y]: Point): Point => {
      const box = panel.current?.getBoundingClientRect();
      return box ? [x - box.left, y - box.top] : [x, y];
    };
    /** Asks what a loose end is to be connected to: a socket of the node that it was dropped on, or a new node. */
    const ask = (event: MouseEvent | TouchEvent, loose: Loose, onto: string | undefined) => {
      const point = 'clientX' in event ? event : event.changedTouches[0]!;
      const at: Point = [point.clientX, point.clientY];
      const place = screenToFlowPosition({ x: at[0], y: at[1] });
      canvas.setState({
        adding: { at: [place.x, place.y], from: toPanel(at), loose, ...(onto !== undefined && { onto }) },
      });
    };
    const dropped = (event: MouseEvent | TouchEvent, loose: Loose) => {
      const level = levelNow();
      const taken = carried.current;
      if (taken) studio.edit(inside(level.group, { kind: 'disconnect', to: taken.to }), 'edit.disconnect');
      const onto = nodeUnder(event);
      if (taken && onto === undefined) return;
      const offers = onto === undefined ? undefined : offersOf(levelNow(), loose, onto);
      if (offers?.length === 0) return;
      ask(event, loose, onto);
    };
    return {
      isValidConnection: (connection: Connection | WireEdge) => {
        const edge = edgeOf(connection);
        const { loose, fits } = canvas.getState();
        if (!edge || !loose || !fits) return false;
        const end = loose.side === 'outputs' ? edge.to : edge.from;
        const socket = 'input' in end ? end.input : end.output;
        return fits.get(end.node)?.has(`${otherSide(loose.side)} ${socket}`) === true;
      },
      onConnectStart: (
        _event: MouseEvent | TouchEvent,
        params: { nodeId: string | null; handleId: string | null; handleType: string | null },
      ) => {
        if (params.nodeId === null || params.handleId === null) return;
        const side = params.handleType === 'source' ? 'outputs' : 'inputs';
        const loose = { node: params.nodeId, side, socket: params.handleId } as const;
        canvas.setState({ loose, fits: fitting(levelNow(), loose, shown.current) });
      },
      onConnect: (connection: Connection) => {
        const edge = edgeOf(connection);
        if (edge) draw(edge);
      },
      onConnectEnd: (event: MouseEvent | TouchEvent, state: FinalConnectionState) => {
        const { loose } = canvas.getState();
        canvas.setState({ loose: undefined, fits: undefined });
        // Let go where it was taken up: nothing is meant.
        const isBack = state.toHandle !== null && state.toHandle?.nodeId === loose?.node;
        if (loose && !state.isValid && !isBack) dropped(event, loose);
      },
      onReconnectStart: (_event: unknown, { id }: WireEdge) => {
        carried.current = levelNow().graph.edges[id];
      },
      onReconnect: ({ id }: WireEdge, connection: Connection) => {
        const level = levelNow();
        const [before, edge] = [level.graph.edges[id], edgeOf(connection)];
        if (before && edge && !isThere(level, edge)) studio.edit(reconnecting(level, before, edge), 'edit.connect');
      },
      onReconnectEnd: () => {
        carried.current = undefined;
      },
      onEdgeClick: (event: React.MouseEvent, { id }: WireEdge) => {
        const level = levelNow();
        const edge = level.graph.edges[id];
        if (!event.altKey || !edge) return;
        const { x, y } = screenToFlowPosition({ x: event.clientX, y: event.clientY });
        const { command, node } = bending(level, edge, [x, y]);
        studio.edit(command, 'edit.reroute');
        canvas.setState(({ chosen }) => ({ chosen: { ...chosen, nodes: [node], edges: [] } }));
      },
    };
  }, [studio, screenToFlowPosition, panel]);
}

function edgeOf({ source, sourceHandle, target, targetHandle }: Connection | WireEdge): GraphEdge | undefined {
  if (!sourceHandle || !targetHandle) return undefined;
  return { from: { node: source, output: sourceHandle }, to: { node: target, input: targetHandle } };
}

/** The shown sockets that fit a loose end, by node. Its own node is shown as ever. */
function fitting(level: Level, loose: Loose, faces: ReadonlyMap<string, Face>) {
  const fits = fitsOf(level, loose);
  const found = new Map<string, Set<string>>([[loose.node, new Set([`${loose.side} ${loose.socket}`])]]);
  for (const { id, rows } of faces.values()) {
    if (id === loose.node) continue;
    const sockets = rows.flatMap(({ input, output }) => (loose.side === 'outputs' ? input : output) ?? []);
    const names = sockets.filter(({ name }) => fits(id, name)).map(({ name }) => `${otherSide(loose.side)} ${name}`);
    // What it is not shown with it may be offered when the edge is dropped on it.
    if (names.length > 0) found.set(id, new Set(names));
    else if (offersOf(level, loose, id).length > 0) found.set(id, new Set(['hidden']));
  }
  return found;
}

function nodeUnder(event: MouseEvent | TouchEvent): string | undefined {
  const point = 'clientX' in event ? event : event.changedTouches[0]!;
  const element = document.elementFromPoint(point.clientX, point.clientY);
  const id = element?.closest('.react-flow__node')?.getAttribute('data-id');
  return id && thingOf(id).kind === 'node' ? id : undefined;
}
