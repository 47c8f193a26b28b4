import './sockets.css';
import './graph.css';
import { Modal } from '@mantine/core';
import { type ReactNode, useMemo } from 'react';
import { inEveryLanguage } from '../i18n/everyLanguage.ts';
import { useTexts } from '../i18n/i18n.ts';
import type { MessageKey } from '../i18n/messages.ts';
import { useSaveProject } from '../projects/useSaveProject.ts';
import { nextFalseColor, nextView, toggleGrid } from '../shell/actions.ts';
import { useSavePicture } from '../shell/useSavePicture.ts';
import { useStudio, useStudioState } from '../state/context.tsx';
import type { Studio } from '../state/studio.ts';
import { ACTIONS, contextOf } from './actions.ts';
import { additionsFor } from './additions.ts';
import { canvas, choose, levelAt } from './canvas.ts';
import { adding } from './edits.ts';
import { Finder } from './Finder.tsx';
import { type Keys, keysShown } from './keys.ts';
import type { Item } from './ranking.ts';
import { freePlaceIn } from './room.ts';
import { useNodeItems } from './useNodeItems.ts';

interface PageCommand {
  readonly title: MessageKey;
  readonly keys?: Keys;
  readonly run: () => void;
}

/** Everything that can be done, by its name: commands of the page and of the canvas, and every kind of node. */
export default function Palette(): ReactNode {
  const { t } = useTexts();
  const studio = useStudio();
  const opened = useStudioState((state) => state.dialog === 'palette');
  const close = () => studio.change({ dialog: undefined });
  return (
    <Modal.Root
      opened={opened}
      onClose={close}
      size="min(560px, 94vw)"
      yOffset="12vh"
      transitionProps={{ duration: 0 }}
    >
      <Modal.Overlay backgroundOpacity={0.35} />
      <Modal.Content aria-label={t('palette.title')}>
        <Commands close={close} />
      </Modal.Content>
    </Modal.Root>
  );
}

function Commands({ close }: { readonly close: () => void }): ReactNode {
  const { t } = useTexts();
  const studio = useStudio();
  const commands = usePageCommands(studio);
  const document = useStudioState((state) => state.history.document);
  const level = useMemo(() => levelAt(document, canvas.getState().path), [document]);
  const nodes = useNodeItems(level);
  const context = contextOf(studio);
  const named = (id: string, title: MessageKey, group: string, keys: Keys | undefined, disabled: boolean): Item => ({
    id,
    label: t(title),
    group,
    words: inEveryLanguage(title),
    disabled,
    ...(keys && { keys: keysShown(keys) }),
  });
  const page = commands.map(({ title, keys }) => named(`page:${title}`, title, t('palette.page'), keys, false));
  const graph = context
    ? ACTIONS.map(({ id, title, keys, isPossible }) =>
        named(`graph:${id}`, title, t('panel.graph'), keys[0], isPossible?.(context) === false),
      )
    : [];
  graph.sort((a, b) => Number(a.disabled) - Number(b.disabled));
  const added = nodes.map((item) => ({
    ...item,
    id: `node:${item.id}`,
    label: t('palette.add', { what: item.label }),
  }));
  const choose = ({ id, disabled }: Item) => {
    if (disabled) return;
    close();
    // The dialogue gives the focus back first.
    setTimeout(() => run(id));
  };
  const run = (id: string) => {
    const [kind, name] = [id.slice(0, id.indexOf(':')), id.slice(id.indexOf(':') + 1)];
    const now = contextOf(studio);
    if (kind === 'page') commands.find(({ title }) => title === name)?.run();
    else if (kind === 'node') addNode(studio, name);
    else if (now) ACTIONS.find((action) => action.id === name)?.run(now);
  };
  return <Finder label={t('palette.title')} items={[...graph, ...page, ...added]} onChoose={choose} onClose={close} />;
}

/** In the middle of what is seen of the graph, which is opened where it is not. */
function addNode(studio: Studio, id: string): void {
  const { sight, path } = canvas.getState();
  const level = levelAt(studio.store.getState().history.document, path);
  const addition = additionsFor(level).find((each) => each.id === id);
  if (!addition) return;
  const { node, command } = adding(level, addition, freePlaceIn(level, addition, sight?.middle() ?? [0, 240]));
  studio.edit(command, 'edit.add');
  studio.change({ graph: true });
  choose({ nodes: [node] });
  sight?.focus(node);
}

function usePageCommands(studio: Studio): readonly PageCommand[] {
  const save = useSavePicture();
  const project = useSaveProject();
  const maximized = useStudioState((state) => state.maximized);
  const graph = useStudioState((state) => state.graph);
  return [
    { title: graph ? 'graph.hide' : 'graph.show', keys: 'Mod+Shift+G', run: () => studio.change({ graph: !graph }) },
    { title: 'header.scenes', run: () => studio.change({ dialog: 'gallery' }) },
    { title: 'project.save', keys: 'Mod+S', run: project.save },
    { title: 'project.saveAll', run: () => void project.saveAll() },
    { title: 'project.share', run: () => studio.change({ dialog: 'share' }) },
    { title: 'project.rename', run: () => studio.change({ dialog: 'name' }) },
    { title: 'header.save', keys: 'Mod+Shift+S', run: () => void save() },
    { title: 'header.undo', keys: 'Mod+Z', run: studio.undo },
    { title: 'header.redo', keys: 'Mod+Shift+Z', run: studio.redo },
    { title: 'help.view', run: () => nextView(studio) },
    { title: 'help.grid', run: () => toggleGrid(studio) },
    { title: 'help.falseColor', run: () => nextFalseColor(studio) },
    { title: 'help.maximize', run: () => studio.change({ maximized: !maximized }) },
    { title: 'header.help', keys: '?', run: () => studio.change({ dialog: 'help' }) },
  ];
}
