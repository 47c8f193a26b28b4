import { SimpleGrid, Stack, Text } from '@mantine/core';
import type { ReactNode } from 'react';
import { useTexts } from '../../i18n/i18n.ts';
import { type KeyRow, KeyRows, OR } from '../../shell/KeySection.tsx';
import { GRAPH_ACTIONS } from './actions.ts';
import { formatKeyBinding, type KeyBinding } from './keyBindings.ts';

/** Keys handled outside of the action table (useCanvasKeys.ts). */
const OTHERS: readonly KeyRow[] = [
  [['Tab'], 'graph.keys.next'],
  [['←', '→', '↑', '↓'], 'graph.keys.nudge'],
  [['key.escape'], 'graph.keys.back'],
];

const either = (keys: readonly KeyBinding[]): string[] =>
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
        {t('help.graph')}
      </Text>
      <SimpleGrid cols={{ base: 1, sm: 2 }} spacing="xl" verticalSpacing={8}>
        {[rows.slice(0, half), rows.slice(half)].map((part) => (
          <Stack key={part[0]?.[1]} gap={8}>
            <KeyRows rows={part} />
          </Stack>
        ))}
      </SimpleGrid>
    </Stack>
  );
}
