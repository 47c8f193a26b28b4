import type { EdgeChange, NodeChange } from '@xyflow/react';
import { useCallback, useMemo, useRef, useState } from 'react';
import type { Point } from '../../graph/commands.ts';
import { typesIn } from '../../graph/infer.ts';
import type { Level } from '../../graph/sockets.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { useTexts } from '../i18n/i18n.ts';
import { useStudio, useStudioState } from '../state/context.tsx';
import { type Chosen, canvas, chosenIn, flatName, levelAt, pathIn, useCanvas } from './canvas.ts';
import { moving } from './edits.ts';
import { endsIn, type Face, faceOf } from './face.ts';
import { reaches } from './far.ts';
import { type FlowNode, flowEdges, flowNodes, Kept, type Thing, thingOf, type WireEdge } from './flow.ts';
import { placesIn } from './layered.ts';
import { outcomeOf } from './outcome.ts';
import { problemsIn } from './problems.ts';
import { frameBox, sizeOf, withRoom } from './shape.ts';

type Places = Readonly<Record<string, Point>>;
/** Where things are while they are dragged; the document hears of it when they are let go. */
interface Drag {
  readonly nodes: Places;
  readonly notes: Places;
}
const STILL: Drag = { nodes: {}, notes: {} };

/** The shown level as React Flow wants it, and what becomes of its changes. */
export function useFlow() {
  const level = useLevel();
  const chosen = useCanvas((state) => state.chosen);
  const whole = useFaces(level);
  const placed = useMemo(
    () =>
      placesIn(level.graph, (id) => {
        const face = whole.get(id);
        return face ? sizeOf(face) : [0, 0];
      }),
    [level, whole],
  );
  const faces = useMemo(() => withRoom(whole, placed), [whole, placed]);
  const beyond = useMemo(
    () => reaches(new Map([...faces].map(([id, face]) => [id, { at: placed[id] ?? [0, 0], size: sizeOf(face) }]))),
    [faces, placed],
  );
  const { drag, onNodesChange } = useDrag(level, faces, placed);
  const nameOf = useNames();
  const nodeCache = useRef(new Kept<FlowNode>());
  const edgeCache = useRef(new Kept<WireEdge>());
  const places = useMemo(() => ({ ...placed, ...drag.nodes }), [placed, drag]);
  const present = useMemo(() => chosenIn(level, chosen), [level, chosen]);
  const nodes = useMemo(
    () =>
      flowNodes(
        { level, faces, places, notes: drag.notes, chosen: present, reaches: beyond, nameOf },
        nodeCache.current,
      ),
    [level, faces, places, drag, present, beyond, nameOf],
  );
  const edges = useMemo(
    () => flowEdges(level, typesIn(level, nodeLibrary), present, edgeCache.current),
    [level, present],
  );
  return { level, whole, faces, places, nodes, edges, onNodesChange, onEdgesChange: chooseEdges };
}

function useNames(): (face: Face) => string {
  const { t, any, said, language } = useTexts();
  // biome-ignore lint/correctness/useExhaustiveDependencies: texts change with the language
  return useCallback(
    ({ title, problem }) =>
      problem
        ? t('graph.node.problem', { title: any(title), problem: said(problem.message) })
        : t('graph.node', { title: any(title) }),
    [language, said],
  );
}

function useLevel(): Level {
  const document = useStudioState((state) => state.history.document);
  const path = useCanvas((state) => state.path);
  return useMemo(() => levelAt(document, path), [document, path]);
}

function useFaces(level: Level): ReadonlyMap<string, Face> {
  const results = useStudioState((state) => state.results);
  const path = useCanvas((state) => state.path);
  const pictures = useCanvas((state) => state.pictures);
  return useMemo(() => {
    const way = pathIn(level.document, path);
    const problems = problemsIn(results);
    const around = {
      level,
      types: typesIn(level, nodeLibrary),
      edges: endsIn(level.graph.edges),
      resultOf: (node: string) => outcomeOf(results, level.document, flatName(way, node), level.graph.nodes[node]),
      problemOf: (node: string) => problems.get(flatName(way, node)),
      pictures,
    };
    return new Map(Object.entries(level.graph.nodes).map(([id, node]) => [id, faceOf(id, node, around)]));
  }, [level, results, path, pictures]);
}

function useDrag(level: Level, faces: ReadonlyMap<string, Face>, placed: Places) {
  const studio = useStudio();
  const [drag, setDrag] = useState(STILL);
  const now = useRef<Ground>({ level, placed, faces });
  now.current = { level, placed, faces };
  const onNodesChange = useCallback(
    (changes: NodeChange<FlowNode>[]) => {
      chooseNodes(changes);
      const moves = changes.flatMap((change) =>
        change.type === 'position' && change.position ? [{ ...change, position: change.position }] : [],
      );
      if (moves.length === 0) return;
      const moved = dragOf(
        moves.map(({ id, position: { x, y } }) => ({ ...thingOf(id), at: [Math.round(x), Math.round(y)] })),
        now.current,
      );
      if (moves.some(({ dragging }) => dragging)) {
        setDrag(moved);
        return;
      }
      setDrag(STILL);
      const { level: here } = now.current;
      const changed = (to: Places, from: (key: string) => Point | undefined): Places =>
        Object.fromEntries(Object.entries(to).filter(([key, at]) => String(at) !== String(from(key))));
      const nodes = changed(moved.nodes, (key) => now.current.placed[key]);
      const notes = changed(moved.notes, (key) => here.graph.notes[key]?.at);
      if (Object.keys(nodes).length + Object.keys(notes).length > 0)
        studio.edit(moving(here, nodes, notes), 'edit.move');
    },
    [studio],
  );
  return { drag, onNodesChange };
}

interface Ground {
  readonly level: Level;
  readonly placed: Places;
  readonly faces: ReadonlyMap<string, Face>;
}

/** Where all are that move: what is dragged, and what is in dragged frames. */
function dragOf(moves: readonly (Thing & { readonly at: Point })[], { level, placed, faces }: Ground): Drag {
  const of = (kind: Thing['kind']) => moves.filter((move) => move.kind === kind);
  const nodes = new Map(of('node').map(({ key, at }) => [key, at]));
  const boxOf = (id: string) => {
    const [face, at] = [faces.get(id), placed[id]];
    return face && at && { at, size: sizeOf(face) };
  };
  for (const { key, at } of of('frame')) {
    const frame = level.graph.frames[key];
    const box = frame && frameBox(frame, boxOf);
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

function chooseNodes(changes: readonly NodeChange<FlowNode>[]): void {
  const selections = changes.flatMap((change) => (change.type === 'select' ? [change] : []));
  if (selections.length === 0) return;
  canvas.setState(({ chosen }) => ({
    chosen: selections.reduce((held, { id, selected }) => {
      const { kind, key } = thingOf(id);
      return withChoice(held, `${kind}s`, key, selected);
    }, chosen),
  }));
}

function chooseEdges(changes: readonly EdgeChange<WireEdge>[]): void {
  const selections = changes.flatMap((change) => (change.type === 'select' ? [change] : []));
  if (selections.length === 0) return;
  canvas.setState(({ chosen }) => ({
    chosen: selections.reduce((held, { id, selected }) => withChoice(held, 'edges', id, selected), chosen),
  }));
}

function withChoice(chosen: Chosen, list: keyof Chosen, key: string, on: boolean): Chosen {
  const others = chosen[list].filter((each) => each !== key);
  return { ...chosen, [list]: on ? [...others, key] : others };
}
