import {
  ActionIcon,
  Button,
  Group,
  Kbd,
  Menu,
  Text,
  Tooltip,
  useComputedColorScheme,
  useMantineColorScheme,
} from '@mantine/core';
import {
  IconArrowBackUp,
  IconArrowForwardUp,
  IconCamera,
  IconCheck,
  IconKeyboard,
  IconLanguage,
  IconLayoutGrid,
  IconMoon,
  IconSitemap,
  IconSun,
} from '@tabler/icons-react';
import { lazy, type ReactNode, Suspense } from 'react';
import { LANGUAGE_TAGS, LANGUAGES } from '../../messages/languages.ts';
import { msg } from '../../messages/message.ts';
import { isCoarse } from '../flight/inputDevice.ts';
import { useTexts } from '../language/languageStore.ts';
import { useChangeLanguage } from '../language/useChangeLanguage.ts';
import { ProjectMenu, ProjectName } from '../projects/ProjectMenu.tsx';
import { useEditor, useEditorState } from '../state/context.tsx';
import { Logo } from './Logo.tsx';
import { useSavePicture } from './useSavePicture.ts';

/** Where fingers need room for fewer buttons: the rest in a menu. */
const HeaderMenu = lazy(() => import('./HeaderMenu.tsx'));

export function Header(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const save = useSavePicture();
  return (
    <Group component="header" className="sl-header" gap="xs" wrap="nowrap" px="sm" aria-label={t(msg`Program`)}>
      <Logo />
      <Text component="h1" fw={650} size="sm" className="sl-wordmark">
        Slowlight
      </Text>
      <Button
        size="compact-sm"
        variant="default"
        leftSection={<IconLayoutGrid size={15} />}
        aria-label={t(msg`Scenes`)}
        onClick={() => editor.update({ dialog: 'gallery' })}
      >
        {t(msg`Scenes`)}
      </Button>
      <ProjectMenu />
      <UndoRedo />
      <GraphButton />
      <ProjectName />
      <div className="sl-spring" />
      <IconButton label={t(msg`Save picture`)} keys="Ctrl ⇧ S" onClick={() => void save()}>
        <IconCamera size={17} />
      </IconButton>
      <LanguageMenu />
      <SchemeButton />
      <IconButton label={t(msg`Keys and help`)} keys="?" onClick={() => editor.update({ dialog: 'help' })}>
        <IconKeyboard size={17} />
      </IconButton>
      {isCoarse && (
        <Suspense>
          <HeaderMenu />
        </Suspense>
      )}
    </Group>
  );
}

interface IconButtonProps {
  readonly label: string;
  readonly keys?: string;
  readonly disabled?: boolean;
  readonly onClick: () => void;
  readonly children: ReactNode;
}

function IconButton({ label, keys, disabled, onClick, children }: IconButtonProps): ReactNode {
  const tip = (
    <Group gap={6} wrap="nowrap">
      <span>{label}</span>
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
  const { t } = useTexts();
  const editor = useEditor();
  const last = useEditorState(({ history }) => history.past.at(-1)?.label);
  const next = useEditorState(({ history }) => history.future[0]?.label);
  return (
    <Group gap={0} wrap="nowrap">
      <IconButton
        label={last ? t(msg`Undo: ${t(last)}`) : t(msg`Undo`)}
        keys="Ctrl Z"
        disabled={!last}
        onClick={editor.undo}
      >
        <IconArrowBackUp size={17} />
      </IconButton>
      <IconButton
        label={next ? t(msg`Redo: ${t(next)}`) : t(msg`Redo`)}
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
      label={t(shown ? msg`Hide the node graph` : msg`Show the node graph`)}
      keys="Ctrl ⇧ G"
      onClick={() => editor.update({ graph: !shown })}
    >
      <IconSitemap size={17} />
    </IconButton>
  );
}

function LanguageMenu(): ReactNode {
  const { t, language } = useTexts();
  const change = useChangeLanguage();
  return (
    <Menu position="bottom-end">
      <Tooltip label={t(msg`Language`)} openDelay={400}>
        <Menu.Target>
          <ActionIcon variant="subtle" color="gray" size={30} aria-label={t(msg`Language`)}>
            <IconLanguage size={17} />
          </ActionIcon>
        </Menu.Target>
      </Tooltip>
      <Menu.Dropdown>
        {LANGUAGE_TAGS.map((tag) => (
          <Menu.Item
            key={tag}
            lang={LANGUAGES[tag].locale}
            aria-current={tag === language}
            leftSection={<IconCheck size={15} visibility={tag === language ? undefined : 'hidden'} />}
            onClick={() => change(tag)}
          >
            {LANGUAGES[tag].name}
          </Menu.Item>
        ))}
      </Menu.Dropdown>
    </Menu>
  );
}

function SchemeButton(): ReactNode {
  const { t } = useTexts();
  const { setColorScheme } = useMantineColorScheme();
  const scheme = useComputedColorScheme('dark');
  const other = scheme === 'dark' ? 'light' : 'dark';
  return (
    <IconButton
      label={t(other === 'dark' ? msg`Dark colours` : msg`Light colours`)}
      onClick={() => setColorScheme(other)}
    >
      {scheme === 'dark' ? <IconSun size={17} /> : <IconMoon size={17} />}
    </IconButton>
  );
}
