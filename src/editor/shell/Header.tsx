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
  IconChevronDown,
  IconFile,
  IconFolder,
  IconFolderOpen,
  IconKeyboard,
  IconLanguage,
  IconLayoutGrid,
  IconMoon,
  IconSun,
} from '@tabler/icons-react';
import { type ReactNode, useRef } from 'react';
import { setLanguage, useTexts } from '../i18n/i18n.ts';
import { pickedFiles } from '../loading/picked.ts';
import { useStudio, useStudioState } from '../state/context.tsx';
import { loadPreferences, savePreferences } from '../state/preferences.ts';
import { Logo } from './Logo.tsx';
import { useOpenFiles } from './useOpenFiles.ts';
import { useSavePicture } from './useSavePicture.ts';

export function Header(): ReactNode {
  const { t } = useTexts();
  const studio = useStudio();
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
        onClick={() => studio.change({ dialog: 'gallery' })}
      >
        {t('header.scenes')}
      </Button>
      <OpenMenu />
      <UndoRedo />
      <div className="sl-spring" />
      <IconButton label={t('header.save')} keys="Ctrl S" onClick={() => void save()}>
        <IconCamera size={17} />
      </IconButton>
      <LanguageButton />
      <SchemeButton />
      <IconButton label={t('header.help')} keys="?" onClick={() => studio.change({ dialog: 'help' })}>
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

function OpenMenu(): ReactNode {
  const { t } = useTexts();
  const open = useOpenFiles();
  const fileInput = useRef<HTMLInputElement>(null);
  const folderInput = useRef<HTMLInputElement>(null);
  const onPicked = (input: HTMLInputElement) => {
    open(pickedFiles(input.files ?? []));
    input.value = '';
  };
  return (
    <>
      <Menu position="bottom-start" width={250}>
        <Menu.Target>
          <Button
            size="compact-sm"
            variant="default"
            leftSection={<IconFolderOpen size={15} />}
            aria-label={t('header.open')}
            rightSection={<IconChevronDown size={13} />}
          >
            {t('header.open')}
          </Button>
        </Menu.Target>
        <Menu.Dropdown>
          <Menu.Item leftSection={<IconFile size={15} />} onClick={() => fileInput.current?.click()}>
            {t('header.openFile')}
          </Menu.Item>
          <Menu.Item leftSection={<IconFolder size={15} />} onClick={() => folderInput.current?.click()}>
            {t('header.openFolder')}
          </Menu.Item>
          <Menu.Label>{t('header.openHint')}</Menu.Label>
        </Menu.Dropdown>
      </Menu>
      <input ref={fileInput} type="file" multiple hidden onChange={(event) => onPicked(event.currentTarget)} />
      <input
        ref={(input) => {
          folderInput.current = input;
          if (input) input.webkitdirectory = true;
        }}
        type="file"
        hidden
        onChange={(event) => onPicked(event.currentTarget)}
      />
    </>
  );
}

function UndoRedo(): ReactNode {
  const { t, any } = useTexts();
  const studio = useStudio();
  const last = useStudioState(({ history }) => history.past.at(-1)?.label);
  const next = useStudioState(({ history }) => history.future[0]?.label);
  return (
    <Group gap={0} wrap="nowrap">
      <IconButton
        label={last ? t('header.undoWhat', { what: any(last) }) : t('header.undo')}
        keys="Ctrl Z"
        disabled={!last}
        onClick={studio.undo}
      >
        <IconArrowBackUp size={17} />
      </IconButton>
      <IconButton
        label={next ? t('header.redoWhat', { what: any(next) }) : t('header.redo')}
        keys="Ctrl ⇧ Z"
        disabled={!next}
        onClick={studio.redo}
      >
        <IconArrowForwardUp size={17} />
      </IconButton>
    </Group>
  );
}

function LanguageButton(): ReactNode {
  const { t, language } = useTexts();
  const other = language === 'en' ? 'zh' : 'en';
  const change = () => {
    savePreferences({ ...loadPreferences(), language: other });
    void setLanguage(other);
  };
  return (
    <IconButton label={t('header.languageLabel')} lang={other} onClick={change}>
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
