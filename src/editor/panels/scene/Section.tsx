import { Stack, Text } from '@mantine/core';
import { type ReactNode, useId } from 'react';

/** A section with a heading. */
export function Section({ title, children }: { readonly title: string; readonly children: ReactNode }): ReactNode {
  const id = useId();
  return (
    <Stack gap="sm" component="section" aria-labelledby={id}>
      <Text id={id} component="h2" size="xs" fw={600} c="dimmed" className="sl-section-title">
        {title}
      </Text>
      {children}
    </Stack>
  );
}
