import type { GraphLevel } from '../../../graph/analysis/sockets.ts';
import { GROUP } from '../../../graph/document/structuralTypes.ts';
import { type Alignment, alignCommand, distributeCommand } from '../../../graph/edits/arrange.ts';
import type { CanvasPoint, Command } from '../../../graph/edits/commands.ts';
import { CommandError } from '../../../graph/edits/commands.ts';
import { copyFragment, insideGroup, pasteFragment } from '../../../graph/edits/fragment.ts';
import { groupCommand } from '../../../graph/edits/group.ts';
import { ungroupCommand } from '../../../graph/edits/ungroup.ts';
import { type Message, msg } from '../../../messages/message.ts';
import { nodeLibrary } from '../../../nodes/library.ts';
import type { Editor } from '../../state/editor.ts';
import { loadPreferences, savePreferences } from '../../state/preferences.ts';
import {
  type CanvasSelection,
  type CanvasState,
  type CanvasViewport,
  canvas,
  EMPTY_SELECTION,
  existingPath,
  levelAt,
  prunedSelection,
  selectItems,
} from '../canvas/canvasState.ts';
import { findFreeCenter, revealNodes } from '../layout/freePosition.ts';
import { layeredLayout } from '../layout/layeredLayout.ts';
import { copySelection, cutSelection, pasteText } from './clipboard.ts';
import { frameCommand, moveItemsCommand, noteCommand, removeCommand } from './edits.ts';
import type { KeyBinding } from './keyBindings.ts';

/** What actions work on: the shown level and the selection. */
export interface ActionContext {
  readonly editor: Editor;
  readonly level: GraphLevel;
  readonly path: readonly string[];
  readonly selection: CanvasSelection;
  readonly viewport: CanvasViewport;
}

/** Returns undefined while no canvas is mounted. */
export function actionContext(
  editor: Editor,
  { path, selection, viewport }: CanvasState = canvas.getState(),
): ActionContext | undefined {
  const { document } = editor.store.getState().history;
  const level = levelAt(document, path);
  return (
    viewport && {
      editor,
      level,
      path: existingPath(document, path),
      selection: prunedSelection(level, selection),
      viewport,
    }
  );
}

/** An action on the canvas; key bindings, buttons, command palette and help are generated from this table. */
export interface GraphAction {
  readonly id: string;
  readonly title: Message;
  readonly keys: readonly KeyBinding[];
  /** Handled by the browser, as a clipboard event. */
  readonly native?: boolean;
  isEnabled?(context: ActionContext): boolean;
  run(context: ActionContext): void;
}

const hasNodes = ({ selection }: ActionContext): boolean => selection.nodes.length > 0;
const hasSeveralNodes = ({ selection }: ActionContext): boolean => selection.nodes.length > 1;
const hasSelection = ({ selection }: ActionContext): boolean =>
  Object.values(selection).some((list) => list.length > 0);
const groupNode = ({ level, selection }: ActionContext): string | undefined =>
  selection.nodes.find((id) => level.graph.nodes[id]?.type === GROUP);

const editLevel = ({ editor, level }: ActionContext, command: Command, label: Message, gesture?: string): void =>
  editor.edit(insideGroup(level.group, command), label, gesture);

/** Runs an action; a refusal becomes a notice. */
function notifyOnError({ editor }: ActionContext, act: () => void): void {
  try {
    act();
  } catch (error) {
    if (!(error instanceof CommandError)) throw error;
    editor.notify({ kind: 'error', text: error.text });
  }
}

/** Opens the list of nodes to add, at the center or at the pointer. */
function openAddNode({ viewport }: ActionContext, at: CanvasPoint = viewport.center()): void {
  canvas.setState({ adding: { at, from: viewport.toPanel(at) } });
}

function duplicateSelected(context: ActionContext): void {
  const { level, selection, editor } = context;
  const { nodes, notes } = selection;
  const fragment = copyFragment(level.document, { nodes, notes, group: level.group });
  const { command, ...added } = pasteFragment(level.document, fragment, level.group, findFreeCenter(level, fragment));
  editor.edit(command, msg`duplicate`);
  selectItems(added);
  revealNodes(added.nodes);
}

function groupSelection(context: ActionContext): void {
  notifyOnError(context, () => {
    const { level, selection: chosen, editor } = context;
    const selection = { nodes: chosen.nodes, group: level.group };
    const { command, node } = groupCommand(level.document, selection, '', nodeLibrary);
    context.viewport.focus();
    editor.edit(command, msg`make a group`);
    selectItems({ nodes: [node] });
  });
}

function ungroupSelection(context: ActionContext): void {
  const node = groupNode(context);
  if (node === undefined) return;
  notifyOnError(context, () => {
    const { command, nodes } = ungroupCommand(context.level.document, node, context.level.group);
    context.viewport.focus();
    context.editor.edit(command, msg`ungroup`);
    selectItems({ nodes });
  });
}

/** Shows the inside of a group node. */
export function enterGroup({ path, viewport }: ActionContext, node: string): void {
  viewport.focus();
  canvas.setState({ path: [...path, node], selection: EMPTY_SELECTION });
  requestAnimationFrame(() => viewport.fit());
}

/** Returns to an enclosing level; `depth`: number of groups still entered. */
export function leaveGroup({ path, viewport }: ActionContext, depth: number): void {
  const left = path[depth];
  viewport.focus();
  canvas.setState({
    path: path.slice(0, depth),
    selection: { ...EMPTY_SELECTION, nodes: left === undefined ? [] : [left] },
  });
  requestAnimationFrame(() => viewport.fit());
}

function toggleFlag(context: ActionContext, kind: 'mute' | 'collapse'): void {
  const { level, selection } = context;
  const flag = kind === 'mute' ? 'muted' : 'collapsed';
  const on = selection.nodes.some((id) => level.graph.nodes[id]?.[flag] !== true);
  const command: Command =
    kind === 'mute' ? { kind, nodes: selection.nodes, muted: on } : { kind, nodes: selection.nodes, collapsed: on };
  editLevel(context, command, kind === 'mute' ? msg`mute` : msg`collapse`);
}

/** Lays out the selected nodes in place, or all nodes. */
function arrangeNodes(context: ActionContext): void {
  const { level, selection, viewport, editor } = context;
  const nodes = selection.nodes.length > 1 ? selection.nodes : Object.keys(level.graph.nodes);
  const found = layeredLayout(nodes, Object.values(level.graph.edges), viewport.sizeWithPicture);
  const corner = (places: readonly CanvasPoint[]): CanvasPoint => [
    Math.min(...places.map(([x]) => x)),
    Math.min(...places.map(([, y]) => y)),
  ];
  const [x, y] = corner(nodes.map(viewport.positionOf));
  const to = Object.entries(found).map(([id, at]): [string, CanvasPoint] => [id, [at[0] + x, at[1] + y]]);
  editor.edit(moveItemsCommand(level, Object.fromEntries(to)), msg`arrange`);
  requestAnimationFrame(() => viewport.fit(selection.nodes.length > 1 ? selection.nodes : undefined));
}

const alignAction = (to: Alignment, title: Message, ...keys: KeyBinding[]): GraphAction => ({
  id: `align-${to}`,
  title,
  keys,
  isEnabled: hasSeveralNodes,
  run: ({ editor, level, selection, viewport }) =>
    editor.edit(
      alignCommand(level.document, { nodes: selection.nodes, group: level.group }, to, viewport.sizeOf),
      msg`arrange`,
    ),
});

const distributeAction = (axis: 0 | 1, title: Message): GraphAction => ({
  id: `distribute-${axis}`,
  title,
  keys: [],
  isEnabled: ({ selection }) => selection.nodes.length > 2,
  run: ({ editor, level, selection, viewport }) =>
    editor.edit(
      distributeCommand(level.document, { nodes: selection.nodes, group: level.group }, axis, viewport.sizeOf),
      msg`arrange`,
    ),
});

/** Puts a frame around the selection. */
function frameSelection(context: ActionContext): void {
  const { level, selection, editor } = context;
  const { command, frame: key } = frameCommand(level, selection.nodes, '');
  editor.edit(command, msg`add a frame`);
  canvas.setState({ selection: { ...EMPTY_SELECTION, frames: [key] }, editing: `frame:${key}` });
}

function addNote({ level, editor, viewport }: ActionContext): void {
  const { command, note: key } = noteCommand(level, viewport.center());
  editor.edit(command, msg`note`);
  canvas.setState({ selection: { ...EMPTY_SELECTION, notes: [key] }, editing: `note:${key}` });
}

const firstSelected = ({ nodes, notes, frames }: CanvasSelection): string | undefined =>
  [
    ...nodes.map((key) => `node:${key}`),
    ...notes.map((key) => `note:${key}`),
    ...frames.map((key) => `frame:${key}`),
  ][0];

/** Removes the selection. */
function removeSelection(context: ActionContext): void {
  const { level, selection, editor } = context;
  context.viewport.focus();
  editor.edit(removeCommand(level, selection), msg`delete`);
  selectItems({});
}

/** Toggles between the graph taking nearly all of the picture's space and sharing it. */
function toggleLargeGraph(editor: Editor): void {
  editor.update({ graphEnlarged: !editor.store.getState().graphEnlarged });
}

/** Toggles pictures on nodes; saved as a preference. */
function togglePictures(): void {
  const pictures = !canvas.getState().pictures;
  canvas.setState({ pictures });
  savePreferences({ ...loadPreferences(), nodePictures: pictures });
}

const writeClipboard = (editor: Editor, words: string | undefined): void => {
  if (words === undefined) return;
  navigator.clipboard.writeText(words).catch((error) => reportError(editor, error));
};
const reportError = (editor: Editor, error: unknown): void => {
  editor.notify({ kind: 'error', text: String(error) });
};

export const GRAPH_ACTIONS: readonly GraphAction[] = [
  { id: 'add', title: msg`Add a node…`, keys: ['Shift+A', 'Space'], run: (context) => openAddNode(context) },
  { id: 'remove', title: msg`Delete`, keys: ['Delete', 'Backspace'], isEnabled: hasSelection, run: removeSelection },
  { id: 'duplicate', title: msg`Duplicate`, keys: ['Mod+D'], isEnabled: hasSelection, run: duplicateSelected },
  {
    id: 'copy',
    title: msg`Copy`,
    keys: ['Mod+C'],
    native: true,
    isEnabled: hasSelection,
    run: ({ editor }) => writeClipboard(editor, copySelection(editor)),
  },
  {
    id: 'cut',
    title: msg`Cut`,
    keys: ['Mod+X'],
    native: true,
    isEnabled: hasSelection,
    run: ({ editor }) => writeClipboard(editor, cutSelection(editor)),
  },
  {
    id: 'paste',
    title: msg`Paste`,
    keys: ['Mod+V'],
    native: true,
    run: ({ editor }) => {
      navigator.clipboard.readText().then(
        (words) => pasteText(editor, words),
        (error) => reportError(editor, error),
      );
    },
  },
  {
    id: 'select-all',
    title: msg`Select all`,
    keys: ['Mod+A'],
    run: ({ level: { graph } }) => selectItems({ nodes: Object.keys(graph.nodes), notes: Object.keys(graph.notes) }),
  },
  {
    id: 'inspect',
    title: msg`Open the inspector`,
    keys: ['Enter'],
    isEnabled: hasNodes,
    run: ({ editor }) => editor.update({ inspecting: true }),
  },
  {
    id: 'rename',
    title: msg`Rename`,
    keys: ['F2'],
    isEnabled: ({ selection }) => firstSelected(selection) !== undefined,
    run: ({ selection }) => canvas.setState({ editing: firstSelected(selection) }),
  },
  { id: 'mute', title: msg`Mute`, keys: ['M'], isEnabled: hasNodes, run: (context) => toggleFlag(context, 'mute') },
  {
    id: 'collapse',
    title: msg`Collapse`,
    keys: ['H'],
    isEnabled: hasNodes,
    run: (context) => toggleFlag(context, 'collapse'),
  },
  { id: 'group', title: msg`Make a group`, keys: ['Mod+G'], isEnabled: hasNodes, run: groupSelection },
  {
    id: 'ungroup',
    title: msg`Ungroup`,
    keys: ['Mod+Alt+G'],
    isEnabled: (context) => groupNode(context) !== undefined,
    run: ungroupSelection,
  },
  {
    id: 'enter',
    title: msg`Enter the group`,
    keys: ['Mod+Enter'],
    isEnabled: (context) => groupNode(context) !== undefined,
    run: (context) => enterGroup(context, groupNode(context)!),
  },
  {
    id: 'leave',
    title: msg`Leave the group`,
    keys: ['Mod+Shift+Enter'],
    isEnabled: ({ path }) => path.length > 0,
    run: (context) => leaveGroup(context, context.path.length - 1),
  },
  { id: 'frame', title: msg`Frame around the selection`, keys: ['F'], isEnabled: hasNodes, run: frameSelection },
  { id: 'note', title: msg`Add a note`, keys: ['N'], run: addNote },
  { id: 'arrange', title: msg`Arrange`, keys: ['L'], run: arrangeNodes },
  alignAction('left', msg`Align left edges`, 'Alt+ArrowLeft'),
  alignAction('right', msg`Align right edges`, 'Alt+ArrowRight'),
  alignAction('top', msg`Align tops`, 'Alt+ArrowUp'),
  alignAction('bottom', msg`Align bottoms`, 'Alt+ArrowDown'),
  alignAction('center', msg`Align centres`),
  alignAction('middle', msg`Align middles`),
  distributeAction(0, msg`Space evenly across`),
  distributeAction(1, msg`Space evenly down`),
  { id: 'large', title: msg`Enlarge or restore`, keys: ['Shift+Space'], run: ({ editor }) => toggleLargeGraph(editor) },
  { id: 'pictures', title: msg`Pictures on nodes`, keys: ['P'], run: togglePictures },
  { id: 'fit', title: msg`Fit all`, keys: ['Home'], run: ({ viewport }) => viewport.fit() },
  {
    id: 'fit-chosen',
    title: msg`Fit the selection`,
    keys: ['.'],
    isEnabled: hasNodes,
    run: ({ viewport, selection }) => viewport.fit(selection.nodes),
  },
  { id: 'zoom-in', title: msg`Zoom in`, keys: ['+', '='], run: ({ viewport }) => viewport.zoom(1.25) },
  { id: 'zoom-out', title: msg`Zoom out`, keys: ['-'], run: ({ viewport }) => viewport.zoom(0.8) },
];

/** Step of the arrow keys [px]; Shift makes it larger. */
const NUDGE_DIRECTIONS: Readonly<Record<string, CanvasPoint>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};
const NUDGE = 10;
const LARGE_NUDGE = 50;

/** Moves the selection by one step; while a key is held, all steps are one undo step. */
export function nudgeSelection(
  { level, selection, viewport, editor }: ActionContext,
  key: string,
  far: boolean,
): boolean {
  const step = NUDGE_DIRECTIONS[key];
  if (!step || selection.nodes.length + selection.notes.length === 0) return false;
  const length = far ? LARGE_NUDGE : NUDGE;
  const moved = ([x, y]: CanvasPoint): CanvasPoint => [x + step[0] * length, y + step[1] * length];
  const nodes = selection.nodes.map((id): [string, CanvasPoint] => [id, moved(viewport.positionOf(id))]);
  const notes = selection.notes.map((id): [string, CanvasPoint] => [id, moved(level.graph.notes[id]!.at)]);
  const gesture = `nudge ${[...selection.nodes, ...selection.notes].join(' ')}`;
  editor.edit(moveItemsCommand(level, Object.fromEntries(nodes), Object.fromEntries(notes)), msg`move`, gesture);
  return true;
}
