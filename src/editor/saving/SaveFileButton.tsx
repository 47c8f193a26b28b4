import { Button } from '@mantine/core';
import { IconDownload } from '@tabler/icons-react';
import type { ReactNode } from 'react';
import { msg } from '../../messages/message.ts';
import { useTexts } from '../language/languageStore.ts';
import { useSaving } from './savingState.ts';
import { useSaveFile } from './useSaveFile.ts';

interface SaveFileProps {
  /** Id in evaluation results. */
  readonly node: string;
}

/** Inspector button that saves the file of an output node. */
export function SaveFileButton({ node }: SaveFileProps): ReactNode {
  const { t } = useTexts();
  const save = useSaveFile();
  const busy = useSaving(({ job }) => job !== undefined);
  return (
    <Button
      size="xs"
      variant="light"
      disabled={busy}
      leftSection={<IconDownload size={15} aria-hidden />}
      onClick={() => void save(node)}
    >
      {t(msg`Download the file`)}
    </Button>
  );
}

/** The same on a node's card; keyboard users reach the inspector's. */
export function SaveFileIcon({ node }: SaveFileProps): ReactNode {
  const { t } = useTexts();
  const save = useSaveFile();
  const busy = useSaving(({ job }) => job !== undefined);
  return (
    <button
      type="button"
      className="sl-node-enter sl-node-save nodrag"
      tabIndex={-1}
      disabled={busy}
      aria-label={t(msg`Download the file`)}
      title={t(msg`Download the file`)}
      onClick={() => void save(node)}
    >
      <IconDownload size={14} />
    </button>
  );
}
