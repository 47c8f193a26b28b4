import { Modal, SimpleGrid, Stack, Text } from '@mantine/core';
import { lazy, type ReactNode, Suspense } from 'react';
import { useTexts } from '../i18n/i18n.ts';
import type { TextKey } from '../i18n/texts.ts';
import { useEditor, useEditorState } from '../state/context.tsx';
import { type KeyRow, KeySection } from './KeySection.tsx';

/** Loaded with the graph's code. */
const GraphKeys = lazy(() => import('../graph/commands/GraphKeys.tsx'));

type KeyGroup = readonly [title: TextKey, rows: readonly KeyRow[]];

const COLUMNS: readonly (readonly KeyGroup[])[] = [
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

/** All keyboard shortcuts, over the picture. */
export function Help(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const opened = useEditorState((state) => state.dialog === 'help');
  return (
    <Modal
      opened={opened}
      onClose={() => editor.update({ dialog: undefined })}
      size="min(820px, 94vw)"
      centered
      title={t('help.title')}
      closeButtonProps={{ 'aria-label': t('close') }}
    >
      <SimpleGrid cols={{ base: 1, sm: 2 }} spacing="xl" verticalSpacing="lg">
        {COLUMNS.map((sections) => (
          <Stack key={sections[0]?.[0]} gap="lg">
            {sections.map(([title, rows]) => (
              <KeySection key={title} title={title} rows={rows} />
            ))}
          </Stack>
        ))}
      </SimpleGrid>
      <Suspense>
        <GraphKeys />
      </Suspense>
      <Text size="xs" c="dimmed" mt="lg">
        {t('help.gamepad')}
      </Text>
    </Modal>
  );
}
