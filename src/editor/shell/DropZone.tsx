import { Text } from '@mantine/core';
import { IconDownload } from '@tabler/icons-react';
import { type ReactNode, useEffect, useState } from 'react';
import { msg } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import { useTexts } from '../language/languageStore.ts';
import { droppedFiles } from '../loading/pickedFiles.ts';
import { useEditor } from '../state/context.tsx';
import { useOpenFiles } from './useOpenFiles.ts';

/** Drop target for files on the whole page; ignores panels that are dragged inside it. */
export function DropZone(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const open = useOpenFiles();
  const [over, setOver] = useState(false);
  useEffect(() => {
    const isFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
    const onOver = (event: DragEvent) => {
      if (!isFiles(event)) return;
      event.preventDefault();
      setOver(true);
    };
    const onLeave = (event: DragEvent) => {
      if (!event.relatedTarget) setOver(false);
    };
    const onDrop = (event: DragEvent) => {
      if (!isFiles(event) || !event.dataTransfer) return;
      event.preventDefault();
      setOver(false);
      droppedFiles(event.dataTransfer).then(open, (error: unknown) =>
        editor.notify({
          kind: 'error',
          text: msg`The browser could not read the dropped files: ${messageOf(error)}. Check that they still exist and can be read, or use Project › Open file.`,
        }),
      );
    };
    addEventListener('dragover', onOver);
    addEventListener('dragleave', onLeave);
    addEventListener('drop', onDrop);
    return () => {
      removeEventListener('dragover', onOver);
      removeEventListener('dragleave', onLeave);
      removeEventListener('drop', onDrop);
    };
  }, [open, editor]);
  return over ? (
    <div className="sl-drop">
      <IconDownload size={32} />
      <Text fw={600}>{t(msg`Drop a scene, a project, a folder or a zip; or missing files of the scene`)}</Text>
    </div>
  ) : null;
}
