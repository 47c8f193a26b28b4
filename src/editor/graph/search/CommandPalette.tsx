import { inEnglish, type Message, msg } from '../../../messages/message.ts';
import '../cards/sockets.css';
import '../graph.css';
import { Modal } from '@mantine/core';
import { type ReactNode, useMemo } from 'react';
import { useTexts } from '../../language/languageStore.ts';
import { useSaveProject } from '../../projects/useSaveProject.ts';
import { nextFalseColor, nextView, toggleGrid, toggleTool } from '../../shell/actions.ts';
import { useSavePicture } from '../../shell/useSavePicture.ts';
import { useEditor, useEditorState } from '../../state/context.tsx';
import type { Editor } from '../../state/editor.ts';
import { canvas, levelAt, selectItems } from '../canvas/canvasState.ts';
import { actionContext, GRAPH_ACTIONS } from '../commands/actions.ts';
import { addNodeCommand } from '../commands/edits.ts';
import { formatKeyBinding, type KeyBinding } from '../commands/keyBindings.ts';
import { findFreePosition } from '../layout/freePosition.ts';
import { addableNodes } from './addableNodes.ts';
import { QuickPick } from './QuickPick.tsx';
import type { QuickPickItem } from './ranking.ts';
import { useNodeItems } from './useNodeItems.ts';

interface PageCommand {
  readonly title: Message;
  readonly keys?: KeyBinding;
  readonly run: () => void;
}

/** All commands of the page and the canvas, and all node kinds, by name. */
export default function CommandPalette(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const opened = useEditorState((state) => state.dialog === 'palette');
  const close = () => editor.update({ dialog: undefined });
  return (
    <Modal.Root
      opened={opened}
      onClose={close}
      size="min(560px, 94vw)"
      yOffset="12vh"
      transitionProps={{ duration: 0 }}
    >
      <Modal.Overlay backgroundOpacity={0.35} />
      <Modal.Content aria-label={t(msg`Search commands and nodes`)}>
        <Commands close={close} />
      </Modal.Content>
    </Modal.Root>
  );
}

function Commands({ close }: { readonly close: () => void }): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const commands = usePageCommands(editor);
  const document = useEditorState((state) => state.history.document);
  const level = useMemo(() => levelAt(document, canvas.getState().path), [document]);
  const nodes = useNodeItems(level);
  const context = actionContext(editor);
  const named = (
    id: string,
    title: Message,
    group: string,
    keys: KeyBinding | undefined,
    disabled: boolean,
  ): QuickPickItem => ({
    id,
    label: t(title),
    group,
    words: `${inEnglish(title)} ${t(title)}`,
    disabled,
    ...(keys && { keys: formatKeyBinding(keys) }),
  });
  const page = commands.map(({ title, keys }) => named(`page:${title.template}`, title, t(msg`Program`), keys, false));
  const graph = context
    ? GRAPH_ACTIONS.map(({ id, title, keys, isEnabled }) =>
        named(`graph:${id}`, title, t(msg`Graph`), keys[0], isEnabled?.(context) === false),
      )
    : [];
  graph.sort((a, b) => Number(a.disabled) - Number(b.disabled));
  const added = nodes.map((item) => ({
    ...item,
    id: `node:${item.id}`,
    label: t(msg`Add: ${item.label}`),
  }));
  const choose = ({ id, disabled }: QuickPickItem) => {
    if (disabled) return;
    close();
    // The dialogue restores the focus first.
    setTimeout(() => run(id));
  };
  const run = (id: string) => {
    const [kind, name] = [id.slice(0, id.indexOf(':')), id.slice(id.indexOf(':') + 1)];
    const now = actionContext(editor);
    if (kind === 'page') commands.find(({ title }) => title.template === name)?.run();
    else if (kind === 'node') addNode(editor, name);
    else if (now) GRAPH_ACTIONS.find((action) => action.id === name)?.run(now);
  };
  return (
    <QuickPick
      label={t(msg`Search commands and nodes`)}
      items={[...graph, ...page, ...added]}
      onChoose={choose}
      onClose={close}
    />
  );
}

/** At the center of the graph's viewport; opens the graph if needed. */
function addNode(editor: Editor, id: string): void {
  const { viewport, path } = canvas.getState();
  const level = levelAt(editor.store.getState().history.document, path);
  const addition = addableNodes(level).find((each) => each.id === id);
  if (!addition) return;
  const { node, command } = addNodeCommand(
    level,
    addition,
    findFreePosition(level, addition, viewport?.center() ?? [0, 240]),
  );
  editor.edit(command, msg`add a node`);
  editor.update({ graph: true });
  selectItems({ nodes: [node] });
  viewport?.focus(node);
}

function usePageCommands(editor: Editor): readonly PageCommand[] {
  const save = useSavePicture();
  const project = useSaveProject();
  const maximized = useEditorState((state) => state.maximized);
  const graph = useEditorState((state) => state.graph);
  return [
    {
      title: graph ? msg`Hide the node graph` : msg`Show the node graph`,
      keys: 'Mod+Shift+G',
      run: () => editor.update({ graph: !graph }),
    },
    { title: msg`Scenes`, run: () => editor.update({ dialog: 'gallery' }) },
    { title: msg`Lessons`, run: () => editor.update({ lesson: { step: 1 } }) },
    { title: msg`Save project`, keys: 'Mod+S', run: project.save },
    { title: msg`Save with its files`, run: () => void project.saveWithFiles() },
    { title: msg`Share by a link…`, run: () => editor.update({ dialog: 'share' }) },
    { title: msg`Name…`, run: () => editor.update({ dialog: 'name' }) },
    { title: msg`Save picture`, keys: 'Mod+Shift+S', run: () => void save() },
    { title: msg`Undo`, keys: 'Mod+Z', run: editor.undo },
    { title: msg`Redo`, keys: 'Mod+Shift+Z', run: editor.redo },
    { title: msg`Next view`, run: () => nextView(editor) },
    { title: msg`Reference grid`, run: () => toggleGrid(editor) },
    { title: msg`Next false colour`, run: () => nextFalseColor(editor) },
    { title: msg`Inspect what is seen`, keys: 'I', run: () => toggleTool(editor, 'inspect') },
    { title: msg`Measure lengths`, keys: 'M', run: () => toggleTool(editor, 'measure') },
    { title: msg`Only the picture`, run: () => editor.update({ maximized: !maximized }) },
    { title: msg`Keys and help`, keys: '?', run: () => editor.update({ dialog: 'help' }) },
  ];
}
