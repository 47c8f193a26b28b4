import { Button, Group, Modal, Stack, Text, TextInput } from '@mantine/core';
import { IconCheck, IconCopy, IconPackageExport } from '@tabler/icons-react';
import { type FormEvent, type ReactNode, useRef, useState } from 'react';
import { messageOf } from '../../formats/diagnostics/inputError.ts';
import { referencedFiles, renameFiles } from '../../graph/document/fileReferences.ts';
import { encodeShareLink } from '../../graph/document/shareLink.ts';
import type { History } from '../../graph/edits/history.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { type Translate, useTexts } from '../i18n/i18n.ts';
import { parseLocalName } from '../loading/localFiles.ts';
import { useEditor, useEditorState } from '../state/context.tsx';
import type { EditorState } from '../state/editor.ts';
import { exportedName, projectName } from './projectNames.ts';
import { useSaveProject } from './useSaveProject.ts';

/** Dialogues about the whole project. */
export function ProjectDialogs(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const dialog = useEditorState((state) => state.dialog);
  const close = () => editor.update({ dialog: undefined });
  const frame = { onClose: close, centered: true, closeButtonProps: { 'aria-label': t('close') } };
  return (
    <>
      <Modal {...frame} opened={dialog === 'share'} title={t('share.title')}>
        {dialog === 'share' && <Share />}
      </Modal>
      <Modal {...frame} opened={dialog === 'name'} title={t('project.name')} size="sm">
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
function linkTo(state: EditorState, t: Translate): { readonly link: string } | { readonly why: string } {
  const { document, origin } = state.history;
  const called = (file: string): string => exportedName(file, origin);
  const own = referencedFiles(document, nodeLibrary).filter((file) => parseLocalName(file));
  if (own.length > 0) return { why: t('share.local', { files: own.map(called).join(', ') }) };
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
      <Text size="sm">{t('share.intro')}</Text>
      <TextInput ref={field} readOnly label={t('share.link')} value={link} onFocus={() => field.current?.select()} />
      <Group justify="flex-end">
        <Button
          size="xs"
          variant="light"
          data-autofocus
          leftSection={copied ? <IconCheck size={15} /> : <IconCopy size={15} />}
          onClick={copy}
        >
          {copied ? t('share.copied') : t('share.copy')}
        </Button>
      </Group>
    </Stack>
  );
}

function NoLink({ why }: { readonly why: string }): ReactNode {
  const { t, translateMessage } = useTexts();
  const editor = useEditor();
  const { saveWithFiles } = useSaveProject();
  const save = () => {
    editor.update({ dialog: undefined });
    void saveWithFiles();
  };
  return (
    <Stack gap="sm">
      <Text size="sm" role="alert" className="sl-place">
        {translateMessage(why)}
      </Text>
      <Group justify="flex-end">
        <Button size="xs" variant="light" data-autofocus leftSection={<IconPackageExport size={15} />} onClick={save}>
          {t('project.saveAll')}
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
    editor.edit({ kind: 'describe', what: 'title', value: name.trim() }, 'edit.rename');
    onDone();
  };
  return (
    <form onSubmit={submit}>
      <Stack gap="sm">
        <TextInput
          data-autofocus
          aria-label={t('project.name')}
          maxLength={200}
          value={name}
          onChange={(event) => setName(event.currentTarget.value)}
        />
        <Group justify="flex-end">
          <Button size="xs" variant="light" type="submit">
            {t('project.done')}
          </Button>
        </Group>
      </Stack>
    </form>
  );
}
