import { Button } from '@mantine/core';
import { IconDownload } from '@tabler/icons-react';
import type { ReactNode } from 'react';
import { useTexts } from '../i18n/i18n.ts';
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
      {t('saving.download')}
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
      aria-label={t('saving.download')}
      title={t('saving.download')}
      onClick={() => void save(node)}
    >
      <IconDownload size={14} />
    </button>
  );
}
