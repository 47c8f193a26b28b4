import { Button, Kbd, Menu, Text, UnstyledButton } from '@mantine/core';
import {
  IconChevronDown,
  IconDeviceFloppy,
  IconDownload,
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
import { useStore } from 'zustand';
import { FORMAT_NAMES } from '../../formats/formatLists.ts';
import { msg } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import { useTexts } from '../language/languageStore.ts';
import { useProjectName } from '../language/useSceneTexts.ts';
import { pickedFiles } from '../loading/pickedFiles.ts';
import { installStore } from '../offline/installPrompt.ts';
import { useServices } from '../services.tsx';
import { useOpenFiles } from '../shell/useOpenFiles.ts';
import { useEditor, useEditorState } from '../state/context.tsx';
import { isUnsaved, projectOfScene } from '../state/editor.ts';
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
  const install = useStore(installStore, (offer) => offer.install);
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
            aria-label={t(msg`Project`)}
            rightSection={<IconChevronDown size={13} />}
          >
            {t(msg`Project`)}
          </Button>
        </Menu.Target>
        <Menu.Dropdown>
          <OpenItems onFile={() => fileInput.current?.click()} onFolder={() => folderInput.current?.click()} />
          <Menu.Divider />
          <SaveItems />
          {earlier.length > 0 && <ClosedSessionItems earlier={earlier} />}
          {install && (
            <>
              <Menu.Divider />
              <Menu.Item leftSection={<IconDownload size={15} />} onClick={install}>
                {t(msg`Install as a program…`)}
              </Menu.Item>
            </>
          )}
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
        {t(msg`New`)}
      </Menu.Item>
      <Menu.Item leftSection={<IconFile size={15} />} onClick={onFile}>
        {t(msg`Open file…`)}
      </Menu.Item>
      <Menu.Item leftSection={<IconFolder size={15} />} onClick={onFolder}>
        {t(msg`Open folder…`)}
      </Menu.Item>
      <Menu.Label>{t(msg`Projects; ${FORMAT_NAMES}; panoramas; a folder or a zip where it has textures`)}</Menu.Label>
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
        {t(msg`Save project`)}
      </Menu.Item>
      <Menu.Item leftSection={<IconPackageExport size={15} />} onClick={() => void saveWithFiles()}>
        {t(msg`Save with its files`)}
      </Menu.Item>
      <Menu.Item leftSection={<IconLink size={15} />} onClick={() => editor.update({ dialog: 'share' })}>
        {t(msg`Share by a link…`)}
      </Menu.Item>
      <Menu.Item leftSection={<IconPencil size={15} />} onClick={() => editor.update({ dialog: 'name' })}>
        {t(msg`Name…`)}
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
      <Menu.Label>{t(msg`Earlier work`)}</Menu.Label>
      {earlier.map((session) => (
        <Menu.Item key={session.id} leftSection={<IconHistory size={15} />} onClick={() => resume(session)}>
          {session.name || t(msg`Unnamed`)}
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
  const name = useProjectName();
  const unsaved = useEditorState(isUnsaved);
  const shown = name || t(msg`Unnamed`);
  return (
    <UnstyledButton
      className="sl-project-name"
      aria-label={`${t(msg`Name of the project`)}: ${shown}${unsaved ? `, ${t(msg`Not saved to a file`)}` : ''}`}
      title={unsaved ? t(msg`Not saved to a file`) : undefined}
      data-unsaved={unsaved}
      onClick={() => editor.update({ dialog: 'name' })}
    >
      <span className="sl-project-title">{shown}</span>
      {unsaved && <span aria-hidden="true">•</span>}
    </UnstyledButton>
  );
}
