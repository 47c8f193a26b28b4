import type { EdgeChange, NodeChange } from '@xyflow/react';
import { useCallback, useMemo, useRef, useState } from 'react';
import { inferTypes } from '../../../graph/analysis/inferTypes.ts';
import type { GraphLevel } from '../../../graph/analysis/sockets.ts';
import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import { msg } from '../../../messages/message.ts';
import { nodeLibrary } from '../../../nodes/library.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useEditor, useEditorState } from '../../state/context.tsx';
import { cardSize, frameRect, withoutCoveringPictures } from '../cards/cardGeometry.ts';
import { type CardModel, cardModel, connectedSockets } from '../cards/cardModel.ts';
import { nodeResultOf } from '../cards/nodeResult.ts';
import { problemsByNode } from '../cards/problems.ts';
import { titleOverhangs } from '../cards/zoomedOutTitle.ts';
import { moveItemsCommand } from '../commands/edits.ts';
import { nodePositions } from '../layout/layeredLayout.ts';
import {
  type CanvasSelection,
  canvas,
  existingPath,
  flatNodeId,
  levelAt,
  prunedSelection,
  useCanvas,
} from './canvasState.ts';
import {
  ElementCache,
  type FlowItem,
  type FlowNode,
  flowEdges,
  flowItem,
  flowNodes,
  type WireEdge,
} from './flowElements.ts';

type Places = Readonly<Record<string, CanvasPoint>>;
/** Positions during a drag; the document is changed when it ends. */
interface Drag {
  readonly nodes: Places;
  readonly notes: Places;
}
const NO_DRAG: Drag = { nodes: {}, notes: {} };

/** The shown level as React Flow elements, with handlers for its changes. */
export function useFlow() {
  const { t } = useTexts();
  const level = useLevel();
  const chosen = useCanvas((state) => state.selection);
  const uncropped = useCardModels(level);
  const placed = useMemo(
    () =>
      nodePositions(level.graph, (id) => {
        const card = uncropped.get(id);
        return card ? cardSize(card) : [0, 0];
      }),
    [level, uncropped],
  );
  const cards = useMemo(() => withoutCoveringPictures(uncropped, placed), [uncropped, placed]);
  const beyond = useMemo(
    () =>
      titleOverhangs(new Map([...cards].map(([id, card]) => [id, { at: placed[id] ?? [0, 0], size: cardSize(card) }]))),
    [cards, placed],
  );
  const { drag, onNodesChange } = useDrag(level, cards, placed);
  const nameOf = useNames();
  const nodeCache = useRef(new ElementCache<FlowNode>());
  const edgeCache = useRef(new ElementCache<WireEdge>());
  const places = useMemo(() => ({ ...placed, ...drag.nodes }), [placed, drag]);
  const present = useMemo(() => prunedSelection(level, chosen), [level, chosen]);
  const nodes = useMemo(
    () =>
      flowNodes(
        { level, cards, places, notes: drag.notes, selection: present, overhangs: beyond, nameOf },
        nodeCache.current,
      ),
    [level, cards, places, drag, present, beyond, nameOf],
  );
  const edges = useMemo(
    () => flowEdges(level, inferTypes(level, nodeLibrary), present, t, edgeCache.current),
    [level, present, t],
  );
  return { level, uncropped, cards, places, nodes, edges, onNodesChange, onEdgesChange: selectEdges };
}

function useNames(): (card: CardModel) => string {
  const { t, language } = useTexts();
  // biome-ignore lint/correctness/useExhaustiveDependencies: texts change with the language
  return useCallback(
    ({ title, problem }) =>
      problem ? t(msg`${t(title)}, node. Problem: ${problem.message}`) : t(msg`${t(title)}, node`),
    [language, t],
  );
}

function useLevel(): GraphLevel {
  const document = useEditorState((state) => state.history.document);
  const path = useCanvas((state) => state.path);
  return useMemo(() => levelAt(document, path), [document, path]);
}

function useCardModels(level: GraphLevel): ReadonlyMap<string, CardModel> {
  const results = useEditorState((state) => state.results);
  const path = useCanvas((state) => state.path);
  const pictures = useCanvas((state) => state.pictures);
  return useMemo(() => {
    const candidate = existingPath(level.document, path);
    const problems = problemsByNode(results);
    const around = {
      level,
      types: inferTypes(level, nodeLibrary),
      edges: connectedSockets(level.graph.edges),
      resultOf: (node: string) =>
        nodeResultOf(results, level.document, flatNodeId(candidate, node), level.graph.nodes[node]),
      problemOf: (node: string) => problems.get(flatNodeId(candidate, node)),
      pictures,
    };
    return new Map(Object.entries(level.graph.nodes).map(([id, node]) => [id, cardModel(id, node, around)]));
  }, [level, results, path, pictures]);
}

function useDrag(level: GraphLevel, cards: ReadonlyMap<string, CardModel>, placed: Places) {
  const editor = useEditor();
  const [drag, setDrag] = useState(NO_DRAG);
  const now = useRef<DragContext>({ level, placed, cards });
  now.current = { level, placed, cards };
  const onNodesChange = useCallback(
    (changes: NodeChange<FlowNode>[]) => {
      selectNodes(changes);
      const moves = changes.flatMap((change) =>
        change.type === 'position' && change.position ? [{ ...change, position: change.position }] : [],
      );
      if (moves.length === 0) return;
      const moved = computeDrag(
        moves.map(({ id, position: { x, y } }) => ({ ...flowItem(id), at: [Math.round(x), Math.round(y)] })),
        now.current,
      );
      if (moves.some(({ dragging }) => dragging)) {
        setDrag(moved);
        return;
      }
      setDrag(NO_DRAG);
      const { level: here } = now.current;
      const changed = (to: Places, from: (key: string) => CanvasPoint | undefined): Places =>
        Object.fromEntries(Object.entries(to).filter(([key, at]) => String(at) !== String(from(key))));
      const nodes = changed(moved.nodes, (key) => now.current.placed[key]);
      const notes = changed(moved.notes, (key) => here.graph.notes[key]?.at);
      if (Object.keys(nodes).length + Object.keys(notes).length > 0)
        editor.edit(moveItemsCommand(here, nodes, notes), msg`move`);
    },
    [editor],
  );
  return { drag, onNodesChange };
}

interface DragContext {
  readonly level: GraphLevel;
  readonly placed: Places;
  readonly cards: ReadonlyMap<string, CardModel>;
}

/** Positions of everything that moves: the dragged nodes, and those in dragged frames. */
function computeDrag(
  moves: readonly (FlowItem & { readonly at: CanvasPoint })[],
  { level, placed, cards }: DragContext,
): Drag {
  const of = (kind: FlowItem['kind']) => moves.filter((move) => move.kind === kind);
  const nodes = new Map(of('node').map(({ key, at }) => [key, at]));
  const boxOf = (id: string) => {
    const [card, at] = [cards.get(id), placed[id]];
    return card && at && { at, size: cardSize(card) };
  };
  for (const { key, at } of of('frame')) {
    const frame = level.graph.frames[key];
    const box = frame && frameRect(frame, boxOf);
    if (!frame || !box) continue;
    for (const id of frame.nodes) {
      const [x, y] = placed[id] ?? [0, 0];
      if (!nodes.has(id)) nodes.set(id, [x + at[0] - box.at[0], y + at[1] - box.at[1]]);
    }
  }
  return {
    nodes: Object.fromEntries(nodes),
    notes: Object.fromEntries(of('note').map(({ key, at }) => [key, at])),
  };
}

function selectNodes(changes: readonly NodeChange<FlowNode>[]): void {
  const selections = changes.flatMap((change) => (change.type === 'select' ? [change] : []));
  if (selections.length === 0) return;
  canvas.setState(({ selection }) => ({
    selection: selections.reduce((held, { id, selected }) => {
      const { kind, key } = flowItem(id);
      return withSelected(held, `${kind}s`, key, selected);
    }, selection),
  }));
}

function selectEdges(changes: readonly EdgeChange<WireEdge>[]): void {
  const selections = changes.flatMap((change) => (change.type === 'select' ? [change] : []));
  if (selections.length === 0) return;
  canvas.setState(({ selection }) => ({
    selection: selections.reduce((held, { id, selected }) => withSelected(held, 'edges', id, selected), selection),
  }));
}

function withSelected(chosen: CanvasSelection, list: keyof CanvasSelection, key: string, on: boolean): CanvasSelection {
  const others = chosen[list].filter((each) => each !== key);
  return { ...chosen, [list]: on ? [...others, key] : others };
}
