import {
  ActionIcon,
  Button,
  Group,
  Kbd,
  Text,
  Tooltip,
  useComputedColorScheme,
  useMantineColorScheme,
} from '@mantine/core';
import {
  IconArrowBackUp,
  IconArrowForwardUp,
  IconCamera,
  IconKeyboard,
  IconLanguage,
  IconLayoutGrid,
  IconMoon,
  IconSitemap,
  IconSun,
} from '@tabler/icons-react';
import type { ReactNode } from 'react';
import { setLanguage, useTexts } from '../i18n/i18n.ts';
import { ProjectMenu, ProjectName } from '../projects/ProjectMenu.tsx';
import { useEditor, useEditorState } from '../state/context.tsx';
import { loadPreferences, savePreferences } from '../state/preferences.ts';
import { Logo } from './Logo.tsx';
import { useSavePicture } from './useSavePicture.ts';

export function Header(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const save = useSavePicture();
  return (
    <Group component="header" className="sl-header" gap="xs" wrap="nowrap" px="sm" aria-label={t('header.toolbar')}>
      <Logo />
      <Text component="h1" fw={650} size="sm" className="sl-wordmark">
        Slowlight
      </Text>
      <Button
        size="compact-sm"
        variant="default"
        leftSection={<IconLayoutGrid size={15} />}
        aria-label={t('header.scenes')}
        onClick={() => editor.update({ dialog: 'gallery' })}
      >
        {t('header.scenes')}
      </Button>
      <ProjectMenu />
      <UndoRedo />
      <GraphButton />
      <ProjectName />
      <div className="sl-spring" />
      <IconButton label={t('header.save')} keys="Ctrl ⇧ S" onClick={() => void save()}>
        <IconCamera size={17} />
      </IconButton>
      <LanguageButton />
      <SchemeButton />
      <IconButton label={t('header.help')} keys="?" onClick={() => editor.update({ dialog: 'help' })}>
        <IconKeyboard size={17} />
      </IconButton>
    </Group>
  );
}

interface IconButtonProps {
  readonly label: string;
  readonly keys?: string;
  readonly disabled?: boolean;
  readonly lang?: string;
  readonly onClick: () => void;
  readonly children: ReactNode;
}

function IconButton({ label, keys, disabled, lang, onClick, children }: IconButtonProps): ReactNode {
  const tip = (
    <Group gap={6} wrap="nowrap">
      <span lang={lang}>{label}</span>
      {keys && <Kbd size="xs">{keys}</Kbd>}
    </Group>
  );
  return (
    <Tooltip label={tip} openDelay={400}>
      <ActionIcon variant="subtle" color="gray" size={30} aria-label={label} disabled={disabled} onClick={onClick}>
        {children}
      </ActionIcon>
    </Tooltip>
  );
}

function UndoRedo(): ReactNode {
  const { t, textOrKey } = useTexts();
  const editor = useEditor();
  const last = useEditorState(({ history }) => history.past.at(-1)?.label);
  const next = useEditorState(({ history }) => history.future[0]?.label);
  return (
    <Group gap={0} wrap="nowrap">
      <IconButton
        label={last ? t('header.undoWhat', { what: textOrKey(last) }) : t('header.undo')}
        keys="Ctrl Z"
        disabled={!last}
        onClick={editor.undo}
      >
        <IconArrowBackUp size={17} />
      </IconButton>
      <IconButton
        label={next ? t('header.redoWhat', { what: textOrKey(next) }) : t('header.redo')}
        keys="Ctrl ⇧ Z"
        disabled={!next}
        onClick={editor.redo}
      >
        <IconArrowForwardUp size={17} />
      </IconButton>
    </Group>
  );
}

/** Toggles the graph. */
function GraphButton(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const shown = useEditorState((state) => state.graph);
  return (
    <IconButton
      label={t(shown ? 'graph.hide' : 'graph.show')}
      keys="Ctrl ⇧ G"
      onClick={() => editor.update({ graph: !shown })}
    >
      <IconSitemap size={17} />
    </IconButton>
  );
}

function LanguageButton(): ReactNode {
  const { t, language } = useTexts();
  const editor = useEditor();
  const other = language === 'en' ? 'zh' : 'en';
  const change = () =>
    setLanguage(other).then(
      () => savePreferences({ ...loadPreferences(), language: other }),
      () => editor.notify({ kind: 'error', text: t('header.noLanguage') }),
    );
  return (
    <IconButton label={t('header.languageLabel')} lang={other} onClick={() => void change()}>
      <IconLanguage size={17} />
    </IconButton>
  );
}

function SchemeButton(): ReactNode {
  const { t } = useTexts();
  const { setColorScheme } = useMantineColorScheme();
  const scheme = useComputedColorScheme('dark');
  const other = scheme === 'dark' ? 'light' : 'dark';
  return (
    <IconButton label={t(`header.${other}`)} onClick={() => setColorScheme(other)}>
      {scheme === 'dark' ? <IconSun size={17} /> : <IconMoon size={17} />}
    </IconButton>
  );
}
