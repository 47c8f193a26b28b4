import { Button, Modal, SimpleGrid, Stack, Text } from '@mantine/core';
import { lazy, type ReactNode, Suspense } from 'react';
import { type Message, msg } from '../../messages/message.ts';
import { useInputDevice } from '../flight/inputDevice.ts';
import { useTexts } from '../language/languageStore.ts';
import { useEditor, useEditorState } from '../state/context.tsx';
import { type KeyRow, KeySection } from './KeySection.tsx';

/** Loaded with the graph's code. */
const GraphKeys = lazy(() => import('../graph/commands/GraphKeys.tsx'));

type KeyGroup = readonly [title: Message, rows: readonly KeyRow[]];

const TOUCH: KeyGroup = [
  msg`Touch`,
  [
    [[msg`Thrust pad`], msg`Accelerate; beyond its rim at full speed`],
    [[msg`Slider`], msg`Keep a speed, or a thrust, without a finger`],
    [[msg`Drag`], msg`Look around`],
    [[msg`Tap`], msg`Inspect what is seen`],
    [[msg`Rest a finger`], msg`Menu of what is there`],
    [[msg`Spread two fingers`], msg`Zoom: the field of view`],
    [[msg`Twist two fingers`], msg`Roll, as the way of flying allows`],
    [[msg`The bar below`], msg`Lock, cruise, way of flying`],
  ],
];

const COLUMNS: readonly (readonly KeyGroup[])[] = [
  [
    [
      msg`Flying`,
      [
        [['W', 'A', 'S', 'D'], msg`Accelerate; release to brake`],
        [['Q', 'E'], msg`Down, up`],
        [['⇧ Shift'], msg`Full speed`],
        [[msg`Drag`], msg`Look around (also the arrow keys)`],
        [[msg`Right click`], msg`Menu of what is there (also the menu key)`],
        [[msg`Double-click`], msg`Capture the mouse; Esc releases it`],
        [['Tab'], msg`Next lock: free, look, fly`],
        [['C'], msg`Cruise: keep the velocity`],
        [['T'], msg`Next way of flying: velocity, drive, thrust …`],
        [['Z'], msg`Brake`],
        [[',', '.'], msg`Roll left, right`],
        [['H'], msg`Hold what you see, and walk about in it`],
        [['O'], msg`Look at yourself and the world from outside`],
        [['K'], msg`Record the flight, or stop`],
        [['R'], msg`Back to the start of the scene`],
        [['B'], msg`Stop, and turn back to the scene`],
      ],
    ],
  ],
  [
    [
      msg`Picture`,
      [
        [[msg`Space`], msg`Play or pause`],
        [['V'], msg`Next view`],
        [['G'], msg`Reference grid`],
        [['X'], msg`Next false colour`],
        [['P'], msg`Value at the crosshair`],
        [['I'], msg`Inspect what is seen`],
        [['M'], msg`Measure lengths`],
        [['F'], msg`Only the picture`],
        [[msg`Esc`], msg`Leave the picture`],
      ],
    ],
    [
      msg`Program`,
      [
        [['Ctrl', 'Z'], msg`Undo`],
        [['Ctrl', '⇧', 'Z'], msg`Redo`],
        [['Ctrl', 'S'], msg`Save project`],
        [['Ctrl', '⇧', 'S'], msg`Save picture`],
        [['?', 'F1'], msg`Keys and help`],
      ],
    ],
  ],
];

/** All keyboard shortcuts, over the picture. */
export default function Help(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const opened = useEditorState((state) => state.dialog === 'help');
  const device = useInputDevice();
  return (
    <Modal
      opened={opened}
      onClose={() => editor.update({ dialog: undefined })}
      size="min(820px, 94vw)"
      centered
      title={t(msg`Keys`)}
      closeButtonProps={{ 'aria-label': t(msg`Close`) }}
    >
      <SimpleGrid cols={{ base: 1, sm: 2 }} spacing="xl" verticalSpacing="lg">
        {(device === 'touch' ? [[TOUCH], ...COLUMNS] : COLUMNS).map((sections) => (
          <Stack key={sections[0]?.[0].template} gap="lg">
            {sections.map(([title, rows]) => (
              <KeySection key={title.template} title={title} rows={rows} />
            ))}
          </Stack>
        ))}
      </SimpleGrid>
      <Suspense>
        <GraphKeys />
      </Suspense>
      <Button
        size="compact-sm"
        variant="light"
        mt="lg"
        onClick={() => editor.update({ dialog: undefined, lesson: { step: 1 } })}
      >
        {t(msg`Lessons: guided pages beside the picture`)}
      </Button>
      <Text size="xs" c="dimmed" mt="lg">
        {t(
          msg`Gamepad: left stick flies, right stick looks, bumpers go down and up, triggers brake and allow full speed, left and right roll, A plays, Y changes the lock.`,
        )}
      </Text>
    </Modal>
  );
}
