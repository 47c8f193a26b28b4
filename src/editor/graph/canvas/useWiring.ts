import { type Connection, type FinalConnectionState, useReactFlow } from '@xyflow/react';
import { useMemo, useRef } from 'react';
import type { GraphLevel } from '../../../graph/analysis/sockets.ts';
import type { GraphEdge } from '../../../graph/document/document.ts';
import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import { insideGroup } from '../../../graph/edits/fragment.ts';
import { useEditor } from '../../state/context.tsx';
import type { CardModel } from '../cards/cardModel.ts';
import { connectionCheck, oppositeSide, type PendingConnection, socketOptions } from '../commands/connections.ts';
import { connectCommand, hasEdge, reconnectCommand, rerouteCommand } from '../commands/edits.ts';
import { canvas, levelAt } from './canvasState.ts';
import { type FlowNode, flowItem, type WireEdge } from './flowElements.ts';

/** Handlers for edges that are drawn, reconnected, dropped and bent. */
export function useWiring(faces: ReadonlyMap<string, CardModel>, panel: React.RefObject<HTMLElement | null>) {
  const studio = useEditor();
  const { screenToFlowPosition } = useReactFlow<FlowNode, WireEdge>();
  const shown = useRef(faces);
  shown.current = faces;
  /** The edge being reconnected. */
  const carried = useRef<GraphEdge>(undefined);
  return useMemo(() => {
    const levelNow = (): GraphLevel => levelAt(studio.store.getState().history.document, canvas.getState().path);
    const draw = (edge: GraphEdge) => {
      const level = levelNow();
      if (!hasEdge(level, edge)) studio.edit(connectCommand(level, edge), 'edit.connect');
    };
    const toPanel = ([x, y]: CanvasPoint): CanvasPoint => {
      const box = panel.current?.getBoundingClientRect();
      return box ? [x - box.left, y - box.top] : [x, y];
    };
    /** Asks what to connect a dropped edge to: a socket of the node it was dropped on, or a new node. */
    const ask = (event: MouseEvent | TouchEvent, loose: PendingConnection, onto: string | undefined) => {
      const point = 'clientX' in event ? event : event.changedTouches[0]!;
      const at: CanvasPoint = [point.clientX, point.clientY];
      const place = screenToFlowPosition({ x: at[0], y: at[1] });
      canvas.setState({
        adding: { at: [place.x, place.y], from: toPanel(at), pending: loose, ...(onto !== undefined && { onto }) },
      });
    };
    const dropped = (event: MouseEvent | TouchEvent, loose: PendingConnection) => {
      const level = levelNow();
      const taken = carried.current;
      if (taken) studio.edit(insideGroup(level.group, { kind: 'disconnect', to: taken.to }), 'edit.disconnect');
      const onto = nodeUnderPointer(event);
      if (taken && onto === undefined) return;
      const offers = onto === undefined ? undefined : socketOptions(levelNow(), loose, onto);
      if (offers?.length === 0) return;
      ask(event, loose, onto);
    };
    return {
      isValidConnection: (connection: Connection | WireEdge) => {
        const edge = edgeOfConnection(connection);
        const { pending, compatibleSockets } = canvas.getState();
        if (!edge || !pending || !compatibleSockets) return false;
        const end = pending.side === 'outputs' ? edge.to : edge.from;
        const socket = 'input' in end ? end.input : end.output;
        return compatibleSockets.get(end.node)?.has(`${oppositeSide(pending.side)} ${socket}`) === true;
      },
      onConnectStart: (
        _event: MouseEvent | TouchEvent,
        params: { nodeId: string | null; handleId: string | null; handleType: string | null },
      ) => {
        if (params.nodeId === null || params.handleId === null) return;
        const side = params.handleType === 'source' ? 'outputs' : 'inputs';
        const loose = { node: params.nodeId, side, socket: params.handleId } as const;
        canvas.setState({ pending: loose, compatibleSockets: findCompatibleSockets(levelNow(), loose, shown.current) });
      },
      onConnect: (connection: Connection) => {
        const edge = edgeOfConnection(connection);
        if (edge) draw(edge);
      },
      onConnectEnd: (event: MouseEvent | TouchEvent, state: FinalConnectionState) => {
        const { pending } = canvas.getState();
        canvas.setState({ pending: undefined, compatibleSockets: undefined });
        // Dropped on the socket where the drag started: no change.
        const isBack = state.toHandle !== null && state.toHandle?.nodeId === pending?.node;
        if (pending && !state.isValid && !isBack) dropped(event, pending);
      },
      onReconnectStart: (_event: unknown, { id }: WireEdge) => {
        carried.current = levelNow().graph.edges[id];
      },
      onReconnect: ({ id }: WireEdge, connection: Connection) => {
        const level = levelNow();
        const [before, edge] = [level.graph.edges[id], edgeOfConnection(connection)];
        if (before && edge && !hasEdge(level, edge)) studio.edit(reconnectCommand(level, before, edge), 'edit.connect');
      },
      onReconnectEnd: () => {
        carried.current = undefined;
      },
      onEdgeClick: (event: React.MouseEvent, { id }: WireEdge) => {
        const level = levelNow();
        const edge = level.graph.edges[id];
        if (!event.altKey || !edge) return;
        const { x, y } = screenToFlowPosition({ x: event.clientX, y: event.clientY });
        const { command, node } = rerouteCommand(level, edge, [x, y]);
        studio.edit(command, 'edit.reroute');
        canvas.setState(({ selection }) => ({ selection: { ...selection, nodes: [node], edges: [] } }));
      },
    };
  }, [studio, screenToFlowPosition, panel]);
}

function edgeOfConnection({
  source,
  sourceHandle,
  target,
  targetHandle,
}: Connection | WireEdge): GraphEdge | undefined {
  if (!sourceHandle || !targetHandle) return undefined;
  return { from: { node: source, output: sourceHandle }, to: { node: target, input: targetHandle } };
}

/** The visible sockets that fit a pending connection, by node. Its own node is not filtered. */
function findCompatibleSockets(level: GraphLevel, loose: PendingConnection, faces: ReadonlyMap<string, CardModel>) {
  const fits = connectionCheck(level, loose);
  const found = new Map<string, Set<string>>([[loose.node, new Set([`${loose.side} ${loose.socket}`])]]);
  for (const { id, rows } of faces.values()) {
    if (id === loose.node) continue;
    const sockets = rows.flatMap(({ input, output }) => (loose.side === 'outputs' ? input : output) ?? []);
    const names = sockets.filter(({ name }) => fits(id, name)).map(({ name }) => `${oppositeSide(loose.side)} ${name}`);
    // Sockets that are not shown are offered when the edge is dropped on the node.
    if (names.length > 0) found.set(id, new Set(names));
    else if (socketOptions(level, loose, id).length > 0) found.set(id, new Set(['hidden']));
  }
  return found;
}

function nodeUnderPointer(event: MouseEvent | TouchEvent): string | undefined {
  const point = 'clientX' in event ? event : event.changedTouches[0]!;
  const element = document.elementFromPoint(point.clientX, point.clientY);
  const id = element?.closest('.react-flow__node')?.getAttribute('data-id');
  return id && flowItem(id).kind === 'node' ? id : undefined;
}
