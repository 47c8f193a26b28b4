import type { Command, Point } from '../../graph/commands.ts';
import { CommandError } from '../../graph/commands.ts';
import { type Alignment, alignmentOf, distributionOf } from '../../graph/edits/arrange.ts';
import { copyOf, inside, pasteOf } from '../../graph/edits/fragment.ts';
import { groupingOf } from '../../graph/edits/group.ts';
import { ungroupingOf } from '../../graph/edits/ungroup.ts';
import type { Level } from '../../graph/sockets.ts';
import { GROUP } from '../../graph/structure.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import type { MessageKey } from '../i18n/messages.ts';
import { loadPreferences, savePreferences } from '../state/preferences.ts';
import type { Studio } from '../state/studio.ts';
import {
  type CanvasState,
  type Chosen,
  canvas,
  choose,
  chosenIn,
  levelAt,
  NOTHING,
  pathIn,
  type Sight,
} from './canvas.ts';
import { copied, cut, paste } from './clipboard.ts';
import { framing, moving, noting, removing } from './edits.ts';
import type { Keys } from './keys.ts';
import { layeredLayout } from './layered.ts';
import { bringIntoSight, freeMiddle } from './room.ts';

/** What actions work on: the level that is shown, and what of it is chosen. */
export interface Context {
  readonly studio: Studio;
  readonly level: Level;
  readonly path: readonly string[];
  readonly chosen: Chosen;
  readonly sight: Sight;
}

/** Undefined while no canvas is shown. */
export function contextOf(
  studio: Studio,
  { path, chosen, sight }: CanvasState = canvas.getState(),
): Context | undefined {
  const { document } = studio.store.getState().history;
  const level = levelAt(document, path);
  return sight && { studio, level, path: pathIn(document, path), chosen: chosenIn(level, chosen), sight };
}

/** Something that is done on the canvas: keys, buttons, the list of commands and the help are made of this table. */
export interface Action {
  readonly id: string;
  readonly title: MessageKey;
  readonly keys: readonly Keys[];
  /** The browser's own keys, which come as events of the clipboard. */
  readonly native?: boolean;
  isPossible?(context: Context): boolean;
  run(context: Context): void;
}

const hasNodes = ({ chosen }: Context): boolean => chosen.nodes.length > 0;
const hasTwo = ({ chosen }: Context): boolean => chosen.nodes.length > 1;
const hasAny = ({ chosen }: Context): boolean => Object.values(chosen).some((list) => list.length > 0);
const groupNode = ({ level, chosen }: Context): string | undefined =>
  chosen.nodes.find((id) => level.graph.nodes[id]?.type === GROUP);

const edit = ({ studio, level }: Context, command: Command, label: MessageKey, gesture?: string): void =>
  studio.edit(inside(level.group, command), label, gesture);

/** Tells of what cannot be done, and does nothing. */
function trying({ studio }: Context, act: () => void): void {
  try {
    act();
  } catch (error) {
    if (!(error instanceof CommandError)) throw error;
    studio.notify({ kind: 'error', text: error.message });
  }
}

/** Opens the list of nodes that can be added, in the middle or where the pointer was. */
function openAdding({ sight }: Context, at: Point = sight.middle()): void {
  canvas.setState({ adding: { at, from: sight.inPanel(at) } });
}

function duplicate(context: Context): void {
  const { level, chosen, studio } = context;
  const { nodes, notes } = chosen;
  const fragment = copyOf(level.document, { nodes, notes, group: level.group });
  const { command, ...added } = pasteOf(level.document, fragment, level.group, freeMiddle(level, fragment));
  studio.edit(command, 'edit.duplicate');
  choose(added);
  bringIntoSight(added.nodes);
}

function group(context: Context): void {
  trying(context, () => {
    const { level, chosen, studio } = context;
    const selection = { nodes: chosen.nodes, group: level.group };
    const { command, node } = groupingOf(level.document, selection, '', nodeLibrary);
    context.sight.focus();
    studio.edit(command, 'edit.group');
    choose({ nodes: [node] });
  });
}

function ungroup(context: Context): void {
  const node = groupNode(context);
  if (node === undefined) return;
  trying(context, () => {
    const { command, nodes } = ungroupingOf(context.level.document, node, context.level.group);
    context.sight.focus();
    context.studio.edit(command, 'edit.ungroup');
    choose({ nodes });
  });
}

/** Shows the inside of a group's node. */
export function enter({ path, sight }: Context, node: string): void {
  sight.focus();
  canvas.setState({ path: [...path, node], chosen: NOTHING });
  requestAnimationFrame(() => sight.fit());
}

/** Back to one of the levels around; `depth`: how many groups are still entered. */
export function leave({ path, sight }: Context, depth: number): void {
  const left = path[depth];
  sight.focus();
  canvas.setState({ path: path.slice(0, depth), chosen: { ...NOTHING, nodes: left === undefined ? [] : [left] } });
  requestAnimationFrame(() => sight.fit());
}

function toggle(context: Context, kind: 'mute' | 'collapse'): void {
  const { level, chosen } = context;
  const flag = kind === 'mute' ? 'muted' : 'collapsed';
  const on = chosen.nodes.some((id) => level.graph.nodes[id]?.[flag] !== true);
  const command: Command =
    kind === 'mute' ? { kind, nodes: chosen.nodes, muted: on } : { kind, nodes: chosen.nodes, collapsed: on };
  edit(context, command, kind === 'mute' ? 'edit.mute' : 'edit.collapse');
}

/** Lays out what is chosen where it is, or all. */
function arrange(context: Context): void {
  const { level, chosen, sight, studio } = context;
  const nodes = chosen.nodes.length > 1 ? chosen.nodes : Object.keys(level.graph.nodes);
  const found = layeredLayout(nodes, Object.values(level.graph.edges), sight.roomFor);
  const corner = (places: readonly Point[]): Point => [
    Math.min(...places.map(([x]) => x)),
    Math.min(...places.map(([, y]) => y)),
  ];
  const [x, y] = corner(nodes.map(sight.placeOf));
  const to = Object.entries(found).map(([id, at]): [string, Point] => [id, [at[0] + x, at[1] + y]]);
  studio.edit(moving(level, Object.fromEntries(to)), 'edit.arrange');
  requestAnimationFrame(() => sight.fit(chosen.nodes.length > 1 ? chosen.nodes : undefined));
}

const align = (to: Alignment, title: MessageKey, ...keys: Keys[]): Action => ({
  id: `align-${to}`,
  title,
  keys,
  isPossible: hasTwo,
  run: ({ studio, level, chosen, sight }) =>
    studio.edit(
      alignmentOf(level.document, { nodes: chosen.nodes, group: level.group }, to, sight.sizeOf),
      'edit.arrange',
    ),
});

const distribute = (axis: 0 | 1, title: MessageKey): Action => ({
  id: `distribute-${axis}`,
  title,
  keys: [],
  isPossible: ({ chosen }) => chosen.nodes.length > 2,
  run: ({ studio, level, chosen, sight }) =>
    studio.edit(
      distributionOf(level.document, { nodes: chosen.nodes, group: level.group }, axis, sight.sizeOf),
      'edit.arrange',
    ),
});

/** A frame around what is chosen. */
function frame(context: Context): void {
  const { level, chosen, studio } = context;
  const { command, frame: key } = framing(level, chosen.nodes, '');
  studio.edit(command, 'edit.frame');
  canvas.setState({ chosen: { ...NOTHING, frames: [key] }, writing: `frame:${key}` });
}

function note({ level, studio, sight }: Context): void {
  const { command, note: key } = noting(level, sight.middle());
  studio.edit(command, 'edit.note');
  canvas.setState({ chosen: { ...NOTHING, notes: [key] }, writing: `note:${key}` });
}

const firstOf = ({ nodes, notes, frames }: Chosen): string | undefined =>
  [
    ...nodes.map((key) => `node:${key}`),
    ...notes.map((key) => `note:${key}`),
    ...frames.map((key) => `frame:${key}`),
  ][0];

/** With what is chosen removed. */
function remove(context: Context): void {
  const { level, chosen, studio } = context;
  context.sight.focus();
  studio.edit(removing(level, chosen), 'edit.remove');
  choose({});
}

/** Gives the graph nearly all of the picture's room, or back what it took. */
function makeLarge(studio: Studio): void {
  studio.change({ largeGraph: !studio.store.getState().largeGraph });
}

/** The next visit has them as they are now. */
function togglePictures(): void {
  const pictures = !canvas.getState().pictures;
  canvas.setState({ pictures });
  savePreferences({ ...loadPreferences(), nodePictures: pictures });
}

const write = (studio: Studio, words: string | undefined): void => {
  if (words === undefined) return;
  navigator.clipboard.writeText(words).catch((error) => refused(studio, error));
};
const refused = (studio: Studio, error: unknown): void => {
  studio.notify({ kind: 'error', text: String(error) });
};

export const ACTIONS: readonly Action[] = [
  { id: 'add', title: 'graph.add', keys: ['Shift+A', 'Space'], run: (context) => openAdding(context) },
  { id: 'remove', title: 'graph.remove', keys: ['Delete', 'Backspace'], isPossible: hasAny, run: remove },
  { id: 'duplicate', title: 'graph.duplicate', keys: ['Mod+D'], isPossible: hasAny, run: duplicate },
  {
    id: 'copy',
    title: 'graph.copy',
    keys: ['Mod+C'],
    native: true,
    isPossible: hasAny,
    run: ({ studio }) => write(studio, copied(studio)),
  },
  {
    id: 'cut',
    title: 'graph.cut',
    keys: ['Mod+X'],
    native: true,
    isPossible: hasAny,
    run: ({ studio }) => write(studio, cut(studio)),
  },
  {
    id: 'paste',
    title: 'graph.paste',
    keys: ['Mod+V'],
    native: true,
    run: ({ studio }) => {
      navigator.clipboard.readText().then(
        (words) => paste(studio, words),
        (error) => refused(studio, error),
      );
    },
  },
  {
    id: 'select-all',
    title: 'graph.selectAll',
    keys: ['Mod+A'],
    run: ({ level: { graph } }) => choose({ nodes: Object.keys(graph.nodes), notes: Object.keys(graph.notes) }),
  },
  {
    id: 'inspect',
    title: 'graph.inspect',
    keys: ['Enter'],
    isPossible: hasNodes,
    run: ({ studio }) => studio.change({ inspecting: true }),
  },
  {
    id: 'rename',
    title: 'graph.rename',
    keys: ['F2'],
    isPossible: ({ chosen }) => firstOf(chosen) !== undefined,
    run: ({ chosen }) => canvas.setState({ writing: firstOf(chosen) }),
  },
  { id: 'mute', title: 'graph.mute', keys: ['M'], isPossible: hasNodes, run: (context) => toggle(context, 'mute') },
  {
    id: 'collapse',
    title: 'graph.collapse',
    keys: ['H'],
    isPossible: hasNodes,
    run: (context) => toggle(context, 'collapse'),
  },
  { id: 'group', title: 'graph.group', keys: ['Mod+G'], isPossible: hasNodes, run: group },
  {
    id: 'ungroup',
    title: 'graph.ungroup',
    keys: ['Mod+Alt+G'],
    isPossible: (context) => groupNode(context) !== undefined,
    run: ungroup,
  },
  {
    id: 'enter',
    title: 'graph.enter',
    keys: ['Mod+Enter'],
    isPossible: (context) => groupNode(context) !== undefined,
    run: (context) => enter(context, groupNode(context)!),
  },
  {
    id: 'leave',
    title: 'graph.leave',
    keys: ['Mod+Shift+Enter'],
    isPossible: ({ path }) => path.length > 0,
    run: (context) => leave(context, context.path.length - 1),
  },
  { id: 'frame', title: 'graph.frame', keys: ['F'], isPossible: hasNodes, run: frame },
  { id: 'note', title: 'graph.note', keys: ['N'], run: note },
  { id: 'arrange', title: 'graph.arrange', keys: ['L'], run: arrange },
  align('left', 'graph.align.left', 'Alt+ArrowLeft'),
  align('right', 'graph.align.right', 'Alt+ArrowRight'),
  align('top', 'graph.align.top', 'Alt+ArrowUp'),
  align('bottom', 'graph.align.bottom', 'Alt+ArrowDown'),
  align('center', 'graph.align.center'),
  align('middle', 'graph.align.middle'),
  distribute(0, 'graph.distribute.across'),
  distribute(1, 'graph.distribute.down'),
  { id: 'large', title: 'graph.large', keys: ['Shift+Space'], run: ({ studio }) => makeLarge(studio) },
  { id: 'pictures', title: 'graph.pictures', keys: ['P'], run: togglePictures },
  { id: 'fit', title: 'graph.fit', keys: ['Home'], run: ({ sight }) => sight.fit() },
  {
    id: 'fit-chosen',
    title: 'graph.fitChosen',
    keys: ['.'],
    isPossible: hasNodes,
    run: ({ sight, chosen }) => sight.fit(chosen.nodes),
  },
  { id: 'zoom-in', title: 'graph.zoomIn', keys: ['+', '='], run: ({ sight }) => sight.zoom(1.25) },
  { id: 'zoom-out', title: 'graph.zoomOut', keys: ['-'], run: ({ sight }) => sight.zoom(0.8) },
];

/** How far the arrow keys move what is chosen [px]; with Shift by more. */
const STEPS: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};
const NUDGE = 10;
const PUSH = 50;

/** Moves what is chosen a little; while a key is held, in one step of the history. */
export function nudge({ level, chosen, sight, studio }: Context, key: string, far: boolean): boolean {
  const step = STEPS[key];
  if (!step || chosen.nodes.length + chosen.notes.length === 0) return false;
  const length = far ? PUSH : NUDGE;
  const moved = ([x, y]: Point): Point => [x + step[0] * length, y + step[1] * length];
  const nodes = chosen.nodes.map((id): [string, Point] => [id, moved(sight.placeOf(id))]);
  const notes = chosen.notes.map((id): [string, Point] => [id, moved(level.graph.notes[id]!.at)]);
  const gesture = `nudge ${[...chosen.nodes, ...chosen.notes].join(' ')}`;
  studio.edit(moving(level, Object.fromEntries(nodes), Object.fromEntries(notes)), 'edit.move', gesture);
  return true;
}
