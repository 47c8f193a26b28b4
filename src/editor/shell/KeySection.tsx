import { Group, Kbd, Stack, Text } from '@mantine/core';
import type { ReactNode } from 'react';
import type { LocalizedText, Message } from '../../messages/message.ts';
import { useTexts } from '../language/languageStore.ts';

/** Keys and what they do; `OR` separates alternatives. */
export type KeyRow = readonly [keys: readonly LocalizedText[], what: Message];
export const OR = ' or ';

export function KeyRows({ rows }: { readonly rows: readonly KeyRow[] }): ReactNode {
  const { t } = useTexts();
  return rows.map(([keys, what]) => (
    <Group key={what.template} justify="space-between" wrap="nowrap" gap="md">
      <Text size="sm">{t(what)}</Text>
      <Group gap={4} wrap="nowrap">
        {keys.map((key, i) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: the same key may occur twice
          <Key key={i} name={key === OR ? OR : t(key)} />
        ))}
      </Group>
    </Group>
  ));
}

const Key = ({ name }: { readonly name: string }): ReactNode =>
  name === OR ? (
    <Text size="xs" c="dimmed">
      /
    </Text>
  ) : (
    <Kbd>{name}</Kbd>
  );

export function KeySection({ title, rows }: { readonly title: Message; readonly rows: readonly KeyRow[] }): ReactNode {
  const { t } = useTexts();
  return (
    <Stack gap={8}>
      <Text component="h3" size="xs" fw={600} c="dimmed" className="sl-section-title">
        {t(title)}
      </Text>
      <KeyRows rows={rows} />
    </Stack>
  );
}
