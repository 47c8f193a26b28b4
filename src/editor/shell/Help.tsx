import { Group, Kbd, Modal, SimpleGrid, Stack, Text } from '@mantine/core';
import type { ReactNode } from 'react';
import { useTexts } from '../i18n/i18n.ts';
import type { MessageKey } from '../i18n/messages.ts';
import { useStudio, useStudioState } from '../state/context.tsx';

type Row = readonly [keys: readonly string[], what: MessageKey];
type Section = readonly [title: MessageKey, rows: readonly Row[]];

const COLUMNS: readonly (readonly Section[])[] = [
  [
    [
      'help.flying',
      [
        [['W', 'A', 'S', 'D'], 'help.move'],
        [['Q', 'E'], 'help.vertical'],
        [['⇧ Shift'], 'help.full'],
        [['help.drag'], 'help.lookAround'],
        [['help.doubleClick'], 'help.capture'],
        [['Tab'], 'help.lock'],
        [['C'], 'help.cruise'],
        [['R'], 'help.restart'],
      ],
    ],
  ],
  [
    [
      'help.picture',
      [
        [['key.space'], 'help.play'],
        [['V'], 'help.view'],
        [['G'], 'help.grid'],
        [['X'], 'help.falseColor'],
        [['P'], 'help.crosshair'],
        [['F'], 'help.maximize'],
        [['key.escape'], 'help.leave'],
      ],
    ],
    [
      'help.program',
      [
        [['Ctrl', 'Z'], 'header.undo'],
        [['Ctrl', '⇧', 'Z'], 'header.redo'],
        [['Ctrl', 'S'], 'project.save'],
        [['Ctrl', '⇧', 'S'], 'header.save'],
        [['?', 'F1'], 'header.help'],
      ],
    ],
  ],
];

/** All keys, over the picture. */
export function Help(): ReactNode {
  const { t } = useTexts();
  const studio = useStudio();
  const opened = useStudioState((state) => state.dialog === 'help');
  return (
    <Modal
      opened={opened}
      onClose={() => studio.change({ dialog: undefined })}
      size="min(820px, 94vw)"
      centered
      title={t('help.title')}
      closeButtonProps={{ 'aria-label': t('close') }}
    >
      <SimpleGrid cols={{ base: 1, sm: 2 }} spacing="xl" verticalSpacing="lg">
        {COLUMNS.map((sections) => (
          <Stack key={sections[0]?.[0]} gap="lg">
            {sections.map((section) => (
              <KeySection key={section[0]} section={section} />
            ))}
          </Stack>
        ))}
      </SimpleGrid>
      <Text size="xs" c="dimmed" mt="lg">
        {t('help.gamepad')}
      </Text>
    </Modal>
  );
}

function KeySection({ section: [title, rows] }: { readonly section: Section }): ReactNode {
  const { t, any } = useTexts();
  return (
    <Stack gap={8}>
      <Text component="h3" size="xs" fw={600} c="dimmed" className="sl-section-title">
        {t(title)}
      </Text>
      {rows.map(([keys, what]) => (
        <Group key={what} justify="space-between" wrap="nowrap" gap="md">
          <Text size="sm">{t(what)}</Text>
          <Group gap={4} wrap="nowrap">
            {keys.map((key) => (
              <Kbd key={key}>{any(key)}</Kbd>
            ))}
          </Group>
        </Group>
      ))}
    </Stack>
  );
}
