import { Button, Kbd, Menu, Text, UnstyledButton } from '@mantine/core';
import {
  IconChevronDown,
  IconDeviceFloppy,
  IconFile,
  IconFilePlus,
  IconFolder,
  IconFolderOpen,
  IconHistory,
  IconLink,
  IconPackageExport,
  IconPencil,
} from '@tabler/icons-react';
import { type ReactNode, useRef, useState } from 'react';
import { messageOf } from '../../formats/diagnostics/inputError.ts';
import { useTexts } from '../i18n/i18n.ts';
import { pickedFiles } from '../loading/pickedFiles.ts';
import { useServices } from '../services.tsx';
import { useOpenFiles } from '../shell/useOpenFiles.ts';
import { useEditor, useEditorState } from '../state/context.tsx';
import { isUnsaved, projectOfScene } from '../state/editor.ts';
import { projectName } from './projectNames.ts';
import type { SessionRecord } from './sessionStore.ts';
import { DEFAULT_SCENE } from './startup.ts';
import { useSaveProject } from './useSaveProject.ts';
import { formatTime, useRestoreSession } from './useSessionRecovery.ts';

/** Maximum number of closed tabs' projects listed. */
const MAX_LISTED_SESSIONS = 5;

/** Menu of all operations on whole projects. */
export function ProjectMenu(): ReactNode {
  const { t } = useTexts();
  const open = useOpenFiles();
  const fileInput = useRef<HTMLInputElement>(null);
  const folderInput = useRef<HTMLInputElement>(null);
  const [earlier, look] = useClosedSessions();
  const onPicked = (input: HTMLInputElement) => {
    open(pickedFiles(input.files ?? []));
    input.value = '';
  };
  return (
    <>
      <Menu position="bottom-start" width={270} onOpen={look}>
        <Menu.Target>
          <Button
            size="compact-sm"
            variant="default"
            leftSection={<IconFolderOpen size={15} />}
            aria-label={t('project.menu')}
            rightSection={<IconChevronDown size={13} />}
          >
            {t('project.menu')}
          </Button>
        </Menu.Target>
        <Menu.Dropdown>
          <OpenItems onFile={() => fileInput.current?.click()} onFolder={() => folderInput.current?.click()} />
          <Menu.Divider />
          <SaveItems />
          {earlier.length > 0 && <ClosedSessionItems earlier={earlier} />}
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

function OpenItems({ onFile, onFolder }: { readonly onFile: () => void; readonly onFolder: () => void }): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  return (
    <>
      <Menu.Item
        leftSection={<IconFilePlus size={15} />}
        onClick={() => editor.openProject(projectOfScene(DEFAULT_SCENE))}
      >
        {t('project.new')}
      </Menu.Item>
      <Menu.Item leftSection={<IconFile size={15} />} onClick={onFile}>
        {t('header.openFile')}
      </Menu.Item>
      <Menu.Item leftSection={<IconFolder size={15} />} onClick={onFolder}>
        {t('header.openFolder')}
      </Menu.Item>
      <Menu.Label>{t('header.openHint')}</Menu.Label>
    </>
  );
}

function SaveItems(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const { save, saveWithFiles } = useSaveProject();
  return (
    <>
      <Menu.Item leftSection={<IconDeviceFloppy size={15} />} rightSection={<Kbd size="xs">Ctrl S</Kbd>} onClick={save}>
        {t('project.save')}
      </Menu.Item>
      <Menu.Item leftSection={<IconPackageExport size={15} />} onClick={() => void saveWithFiles()}>
        {t('project.saveAll')}
      </Menu.Item>
      <Menu.Item leftSection={<IconLink size={15} />} onClick={() => editor.update({ dialog: 'share' })}>
        {t('project.share')}
      </Menu.Item>
      <Menu.Item leftSection={<IconPencil size={15} />} onClick={() => editor.update({ dialog: 'name' })}>
        {t('project.rename')}
      </Menu.Item>
    </>
  );
}

function ClosedSessionItems({ earlier }: { readonly earlier: readonly SessionRecord[] }): ReactNode {
  const { t, language } = useTexts();
  const resume = useRestoreSession();
  return (
    <>
      <Menu.Divider />
      <Menu.Label>{t('project.earlier')}</Menu.Label>
      {earlier.map((session) => (
        <Menu.Item key={session.id} leftSection={<IconHistory size={15} />} onClick={() => resume(session)}>
          {session.name || t('project.unnamed')}
          <Text span size="xs" c="dimmed" ml={8}>
            {formatTime(session.at, language)}
          </Text>
        </Menu.Item>
      ))}
    </>
  );
}

/** Sessions of closed tabs, as of the last refresh. */
function useClosedSessions(): readonly [readonly SessionRecord[], () => void] {
  const editor = useEditor();
  const { sessions } = useServices();
  const [earlier, setEarlier] = useState<readonly SessionRecord[]>([]);
  const look = () => {
    sessions?.closedSessions().then(
      (closed) => setEarlier(closed.filter(({ unsaved }) => unsaved).slice(0, MAX_LISTED_SESSIONS)),
      (error: unknown) => editor.notify({ kind: 'error', text: messageOf(error) }),
    );
  };
  return [earlier, look];
}

/** The project's name, editable, with a mark while there are unsaved changes. */
export function ProjectName(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const name = useEditorState(projectName);
  const unsaved = useEditorState(isUnsaved);
  const shown = name || t('project.unnamed');
  return (
    <UnstyledButton
      className="sl-project-name"
      aria-label={`${t('project.name')}: ${shown}${unsaved ? `, ${t('project.unsaved')}` : ''}`}
      title={unsaved ? t('project.unsaved') : undefined}
      data-unsaved={unsaved}
      onClick={() => editor.update({ dialog: 'name' })}
    >
      <span className="sl-project-title">{shown}</span>
      {unsaved && <span aria-hidden="true">•</span>}
    </UnstyledButton>
  );
}
