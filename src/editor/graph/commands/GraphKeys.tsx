import { SimpleGrid, Stack, Text } from '@mantine/core';
import type { ReactNode } from 'react';
import { type LocalizedText, msg } from '../../../messages/message.ts';
import { useTexts } from '../../language/languageStore.ts';
import { type KeyRow, KeyRows, OR } from '../../shell/KeySection.tsx';
import { GRAPH_ACTIONS } from './actions.ts';
import { formatKeyBinding, type KeyBinding } from './keyBindings.ts';

/** Keys handled outside of the action table (useCanvasKeys.ts). */
const OTHERS: readonly KeyRow[] = [
  [['Tab'], msg`Next node; with ⇧ the previous one`],
  [['←', '→', '↑', '↓'], msg`Move the selection; with ⇧ farther`],
  [[msg`Esc`], msg`Clear the selection; then leave the group`],
];

const either = (keys: readonly KeyBinding[]): LocalizedText[] =>
  keys.flatMap((each, i) => [...(i > 0 ? [OR] : []), ...formatKeyBinding(each)]);

/** Key bindings of the graph panel for the help, from its action table. */
export default function GraphKeyHelp(): ReactNode {
  const { t } = useTexts();
  const rows = [
    ...OTHERS,
    ...GRAPH_ACTIONS.filter(({ keys }) => keys.length > 0).map(({ keys, title }): KeyRow => [either(keys), title]),
  ];
  const half = Math.ceil(rows.length / 2);
  return (
    <Stack gap={8} mt="lg">
      <Text component="h3" size="xs" fw={600} c="dimmed" className="sl-section-title">
        {t(msg`Node graph, while it has the focus`)}
      </Text>
      <SimpleGrid cols={{ base: 1, sm: 2 }} spacing="xl" verticalSpacing={8}>
        {[rows.slice(0, half), rows.slice(half)].map((part) => (
          <Stack key={part[0]?.[1].template} gap={8}>
            <KeyRows rows={part} />
          </Stack>
        ))}
      </SimpleGrid>
    </Stack>
  );
}
