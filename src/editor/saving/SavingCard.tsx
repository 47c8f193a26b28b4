import { Button, Group, Paper, Progress, Text } from '@mantine/core';
import type { ReactNode } from 'react';
import { msg } from '../../messages/message.ts';
import { useTexts } from '../language/languageStore.ts';
import { useSaving } from './savingState.ts';

/** Progress of a file being made, with a cancel button. */
export function SavingCard(): ReactNode {
  const { t } = useTexts();
  const job = useSaving((state) => state.job);
  if (!job) return null;
  const { name, part, cancel } = job;
  const label = t(msg`Making ${name}`);
  return (
    <Paper withBorder shadow="md" p="sm" data-saving>
      <Text size="sm" fw={600} role="status">
        {label}
      </Text>
      {part === undefined ? (
        <div className="sl-working" role="progressbar" aria-label={label} />
      ) : (
        <Progress value={100 * part} size="sm" my={6} aria-label={label} transitionDuration={0} />
      )}
      <Group justify="space-between">
        <Text size="xs" c="dimmed">
          {part === undefined ? '' : `${Math.floor(100 * part)} %`}
        </Text>
        <Button size="compact-xs" variant="default" onClick={cancel}>
          {t(msg`Cancel`)}
        </Button>
      </Group>
    </Paper>
  );
}
