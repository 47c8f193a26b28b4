import { Button, Group, Modal, Stack, Text, TextInput } from '@mantine/core';
import { IconCheck, IconCopy, IconPackageExport } from '@tabler/icons-react';
import { type FormEvent, type ReactNode, useRef, useState } from 'react';
import { referencedFiles, renameFiles } from '../../graph/document/fileReferences.ts';
import { encodeShareLink } from '../../graph/document/shareLink.ts';
import type { History } from '../../graph/edits/history.ts';
import { type LocalizedText, listed, msg, type Translate } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { useTexts } from '../language/languageStore.ts';
import { parseLocalName } from '../loading/localFiles.ts';
import { useEditor, useEditorState } from '../state/context.tsx';
import type { EditorState } from '../state/editor.ts';
import { exportedName, projectName } from './projectNames.ts';
import { useSaveProject } from './useSaveProject.ts';

/** Dialogues about the whole project. */
export default function ProjectDialogs(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const dialog = useEditorState((state) => state.dialog);
  const close = () => editor.update({ dialog: undefined });
  const frame = { onClose: close, centered: true, closeButtonProps: { 'aria-label': t(msg`Close`) } };
  return (
    <>
      <Modal {...frame} opened={dialog === 'share'} title={t(msg`Share by a link`)}>
        {dialog === 'share' && <Share />}
      </Modal>
      <Modal {...frame} opened={dialog === 'name'} title={t(msg`Name of the project`)} size="sm">
        {dialog === 'name' && <Name onDone={close} />}
      </Modal>
    </>
  );
}

function Share(): ReactNode {
  const { t } = useTexts();
  const state = useEditorState((now) => now);
  const shared = linkTo(state, t);
  return 'link' in shared ? <Link link={shared.link} /> : <NoLink why={shared.why} />;
}

/** A link that contains the project, or the reason why there is none. */
function linkTo(state: EditorState, t: Translate): { readonly link: string } | { readonly why: LocalizedText } {
  const { document, origin } = state.history;
  const called = (file: string): string => exportedName(file, origin);
  const own = referencedFiles(document, nodeLibrary).filter((file) => parseLocalName(file));
  if (own.length > 0)
    return {
      why: t(
        msg`A link cannot contain files, and this project reads some from your device: ${listed(own.map(called))}. Save it with its files and send the zip.`,
      ),
    };
  try {
    const named = { ...document, ...titleOf(state.history, projectName(state)) };
    return {
      link: `${location.origin}${location.pathname}#${encodeShareLink(renameFiles(named, nodeLibrary, called))}`,
    };
  } catch (error) {
    return { why: messageOf(error) };
  }
}

/** A link has no file name, so the document carries the title. */
const titleOf = ({ document, origin }: History, name: string): { readonly title?: string } =>
  document.title || origin === '' ? {} : { title: name };

function Link({ link }: { readonly link: string }): ReactNode {
  const { t } = useTexts();
  const field = useRef<HTMLInputElement>(null);
  const [copied, setCopied] = useState(false);
  const copy = () => {
    field.current?.select();
    // If clipboard access is denied, the link is displayed for copying.
    navigator.clipboard?.writeText(link).then(
      () => setCopied(true),
      () => {},
    );
  };
  return (
    <Stack gap="sm">
      <Text size="sm">
        {t(msg`The whole project is in the link, after the #. Only people who get the link can see it.`)}
      </Text>
      <TextInput ref={field} readOnly label={t(msg`Link`)} value={link} onFocus={() => field.current?.select()} />
      <Group justify="flex-end">
        <Button
          size="xs"
          variant="light"
          data-autofocus
          leftSection={copied ? <IconCheck size={15} /> : <IconCopy size={15} />}
          onClick={copy}
        >
          {copied ? t(msg`Copied`) : t(msg`Copy`)}
        </Button>
      </Group>
    </Stack>
  );
}

function NoLink({ why }: { readonly why: LocalizedText }): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const { saveWithFiles } = useSaveProject();
  const save = () => {
    editor.update({ dialog: undefined });
    void saveWithFiles();
  };
  return (
    <Stack gap="sm">
      <Text size="sm" role="alert" className="sl-place">
        {t(why)}
      </Text>
      <Group justify="flex-end">
        <Button size="xs" variant="light" data-autofocus leftSection={<IconPackageExport size={15} />} onClick={save}>
          {t(msg`Save with its files`)}
        </Button>
      </Group>
    </Stack>
  );
}

function Name({ onDone }: { readonly onDone: () => void }): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const [name, setName] = useState(() => projectName(editor.store.getState()));
  const submit = (event: FormEvent) => {
    event.preventDefault();
    editor.edit({ kind: 'describe', what: 'title', value: name.trim() }, msg`rename`);
    onDone();
  };
  return (
    <form onSubmit={submit}>
      <Stack gap="sm">
        <TextInput
          data-autofocus
          aria-label={t(msg`Name of the project`)}
          maxLength={200}
          value={name}
          onChange={(event) => setName(event.currentTarget.value)}
        />
        <Group justify="flex-end">
          <Button size="xs" variant="light" type="submit">
            {t(msg`Done`)}
          </Button>
        </Group>
      </Stack>
    </form>
  );
}
