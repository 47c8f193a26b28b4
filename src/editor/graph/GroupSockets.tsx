import { ActionIcon, Group, Stack, Text, TextInput, Tooltip } from '@mantine/core';
import { IconTrash } from '@tabler/icons-react';
import type { ReactNode } from 'react';
import { own } from '../../graph/document.ts';
import type { Level } from '../../graph/sockets.ts';
import { useTexts } from '../i18n/i18n.ts';
import { useStudio } from '../state/context.tsx';
import { changingSocket } from './edits.ts';

interface GroupSocketsProps {
  readonly level: Level;
  readonly side: 'inputs' | 'outputs';
}

/** The sockets of the group that is entered, to be named and taken away; new ones are drawn. */
export function GroupSockets({ level, side }: GroupSocketsProps): ReactNode {
  const { t } = useTexts();
  const studio = useStudio();
  const group = own(level.document.groups, level.group ?? '');
  if (!group) return null;
  return (
    <Stack gap={6}>
      {group[side].map(({ name, title = name }) => (
        <Group key={name} gap={4} wrap="nowrap">
          <TextInput
            key={title}
            size="xs"
            flex={1}
            aria-label={t('inspector.socketName', { name })}
            defaultValue={title}
            maxLength={200}
            onBlur={(event) => {
              const written = event.currentTarget.value;
              if (written !== title) studio.edit(changingSocket(level, side, name, written), 'edit.rename');
            }}
          />
          <Tooltip label={t('inspector.removeSocket')} openDelay={400}>
            <ActionIcon
              variant="subtle"
              color="gray"
              aria-label={`${t('inspector.removeSocket')}: ${title}`}
              onClick={() => studio.edit(changingSocket(level, side, name), 'edit.remove')}
            >
              <IconTrash size={15} />
            </ActionIcon>
          </Tooltip>
        </Group>
      ))}
      <Text size="xs" c="dimmed">
        {t('inspector.newSocket')}
      </Text>
    </Stack>
  );
}
