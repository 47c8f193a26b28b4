import { ActionIcon, Tooltip } from '@mantine/core';
import type { ReactNode } from 'react';
import type { Message } from '../../messages/message.ts';
import { useTexts } from '../language/languageStore.ts';

interface SignProps {
  readonly sign: string;
  readonly title: Message;
  readonly act: () => void;
}

/** A button that is only a sign, with a title. */
export function SignButton({ sign, title, act }: SignProps): ReactNode {
  const { t } = useTexts();
  return (
    <Tooltip label={t(title)} openDelay={400}>
      <ActionIcon size="sm" variant="default" aria-label={t(title)} onClick={act}>
        {sign}
      </ActionIcon>
    </Tooltip>
  );
}
