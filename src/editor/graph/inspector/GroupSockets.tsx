import { ActionIcon, Group, Stack, Text, TextInput, Tooltip } from '@mantine/core';
import { IconTrash } from '@tabler/icons-react';
import type { ReactNode } from 'react';
import type { GraphLevel } from '../../../graph/analysis/sockets.ts';
import { own } from '../../../graph/document/document.ts';
import { msg } from '../../../messages/message.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useEditor } from '../../state/context.tsx';
import { changeSocketCommand } from '../commands/edits.ts';

interface GroupSocketsProps {
  readonly level: GraphLevel;
  readonly side: 'inputs' | 'outputs';
}

/** The sockets of the entered group, to rename and remove; new ones are made by drawing edges. */
export function GroupSockets({ level, side }: GroupSocketsProps): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
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
            aria-label={t(msg`Name of the socket ${name}`)}
            defaultValue={title}
            maxLength={200}
            onBlur={(event) => {
              const written = event.currentTarget.value;
              if (written !== title) editor.edit(changeSocketCommand(level, side, name, written), msg`rename`);
            }}
          />
          <Tooltip label={t(msg`Remove the socket`)} openDelay={400}>
            <ActionIcon
              variant="subtle"
              color="gray"
              aria-label={`${t(msg`Remove the socket`)}: ${title}`}
              onClick={() => editor.edit(changeSocketCommand(level, side, name), msg`delete`)}
            >
              <IconTrash size={15} />
            </ActionIcon>
          </Tooltip>
        </Group>
      ))}
      <Text size="xs" c="dimmed">
        {t(msg`Draw an edge to “new” to add a socket.`)}
      </Text>
    </Stack>
  );
}
