import { type Connection, type FinalConnectionState, useReactFlow } from '@xyflow/react';
import { useMemo, useRef } from 'react';
import type { GraphLevel } from '../../../graph/analysis/sockets.ts';
import type { GraphEdge } from '../../../graph/document/document.ts';
import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import { insideGroup } from '../../../graph/edits/fragment.ts';
import { msg } from '../../../messages/message.ts';
import { useEditor } from '../../state/context.tsx';
import type { CardModel } from '../cards/cardModel.ts';
import { connectionCheck, oppositeSide, type PendingConnection, socketOptions } from '../commands/connections.ts';
import { connectCommand, hasEdge, reconnectCommand, rerouteCommand } from '../commands/edits.ts';
import { canvas, levelAt } from './canvasState.ts';
import { type FlowNode, flowItem, type WireEdge } from './flowElements.ts';

/** Handlers for edges that are drawn, reconnected, dropped and bent. */
export function useWiring(cards: ReadonlyMap<string, CardModel>, panel: React.RefObject<HTMLElement | null>) {
  const editor = useEditor();
  const { screenToFlowPosition } = useReactFlow<FlowNode, WireEdge>();
  const shown = useRef(cards);
  shown.current = cards;
  /** The edge being reconnected. */
  const reconnectedEdge = useRef<GraphEdge>(undefined);
  return useMemo(() => {
    const levelNow = (): GraphLevel => levelAt(editor.store.getState().history.document, canvas.getState().path);
    const draw = (edge: GraphEdge) => {
      const level = levelNow();
      if (!hasEdge(level, edge)) editor.edit(connectCommand(level, edge), msg`connect`);
    };
    const toPanel = ([x, y]: CanvasPoint): CanvasPoint => {
      const box = panel.current?.getBoundingClientRect();
      return box ? [x - box.left, y - box.top] : [x, y];
    };
    /** Asks what to connect a dropped edge to: a socket of the node it was dropped on, or a new node. */
    const requestConnection = (
      event: MouseEvent | TouchEvent,
      pendingEnd: PendingConnection,
      onto: string | undefined,
    ) => {
      const point = 'clientX' in event ? event : event.changedTouches[0]!;
      const at: CanvasPoint = [point.clientX, point.clientY];
      const place = screenToFlowPosition({ x: at[0], y: at[1] });
      canvas.setState({
        adding: { at: [place.x, place.y], from: toPanel(at), pending: pendingEnd, ...(onto !== undefined && { onto }) },
      });
    };
    const dropped = (event: MouseEvent | TouchEvent, pendingEnd: PendingConnection) => {
      const level = levelNow();
      const taken = reconnectedEdge.current;
      if (taken) editor.edit(insideGroup(level.group, { kind: 'disconnect', to: taken.to }), msg`disconnect`);
      const onto = nodeUnderPointer(event);
      if (taken && onto === undefined) return;
      const offers = onto === undefined ? undefined : socketOptions(levelNow(), pendingEnd, onto);
      if (offers?.length === 0) return;
      requestConnection(event, pendingEnd, onto);
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
        const pendingEnd = { node: params.nodeId, side, socket: params.handleId } as const;
        canvas.setState({
          pending: pendingEnd,
          compatibleSockets: findCompatibleSockets(levelNow(), pendingEnd, shown.current),
        });
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
        reconnectedEdge.current = levelNow().graph.edges[id];
      },
      onReconnect: ({ id }: WireEdge, connection: Connection) => {
        const level = levelNow();
        const [before, edge] = [level.graph.edges[id], edgeOfConnection(connection)];
        if (before && edge && !hasEdge(level, edge)) editor.edit(reconnectCommand(level, before, edge), msg`connect`);
      },
      onReconnectEnd: () => {
        reconnectedEdge.current = undefined;
      },
      onEdgeClick: (event: React.MouseEvent, { id }: WireEdge) => {
        const level = levelNow();
        const edge = level.graph.edges[id];
        if (!event.altKey || !edge) return;
        const { x, y } = screenToFlowPosition({ x: event.clientX, y: event.clientY });
        const { command, node } = rerouteCommand(level, edge, [x, y]);
        editor.edit(command, msg`bend an edge`);
        canvas.setState(({ selection }) => ({ selection: { ...selection, nodes: [node], edges: [] } }));
      },
    };
  }, [editor, screenToFlowPosition, panel]);
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
function findCompatibleSockets(
  level: GraphLevel,
  pendingEnd: PendingConnection,
  cards: ReadonlyMap<string, CardModel>,
) {
  const fits = connectionCheck(level, pendingEnd);
  const found = new Map<string, Set<string>>([[pendingEnd.node, new Set([`${pendingEnd.side} ${pendingEnd.socket}`])]]);
  for (const { id, rows } of cards.values()) {
    if (id === pendingEnd.node) continue;
    const sockets = rows.flatMap(({ input, output }) => (pendingEnd.side === 'outputs' ? input : output) ?? []);
    const names = sockets
      .filter(({ name }) => fits(id, name))
      .map(({ name }) => `${oppositeSide(pendingEnd.side)} ${name}`);
    // Sockets that are not shown are offered when the edge is dropped on the node.
    if (names.length > 0) found.set(id, new Set(names));
    else if (socketOptions(level, pendingEnd, id).length > 0) found.set(id, new Set(['hidden']));
  }
  return found;
}

function nodeUnderPointer(event: MouseEvent | TouchEvent): string | undefined {
  const point = 'clientX' in event ? event : event.changedTouches[0]!;
  const element = document.elementFromPoint(point.clientX, point.clientY);
  const id = element?.closest('.react-flow__node')?.getAttribute('data-id');
  return id && flowItem(id).kind === 'node' ? id : undefined;
}
