import { Button } from '@mantine/core';
import { IconDownload } from '@tabler/icons-react';
import type { ReactNode } from 'react';
import { useTexts } from '../i18n/i18n.ts';
import { useSaving } from './savingState.ts';
import { useSaveFile } from './useSaveFile.ts';

interface SaveFileProps {
  /** As evaluations name it. */
  readonly node: string;
}

/** Of the inspector: hands the person the file that a node asks for. */
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

/** The same on a node's card; keys reach that of the inspector. */
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
