import { Button, Group, Text } from '@mantine/core';
import type { ReactNode, RefObject } from 'react';
import { msg } from '../../messages/message.ts';
import { useInputDevice } from '../flight/inputDevice.ts';
import { useTexts } from '../language/languageStore.ts';
import { useServices } from '../services.tsx';

/** Shown to one who has left the scene: the ways back. The focus stays where it is while it appears, and goes to the picture from its buttons. */
export default function OutsideCard({ picture }: { readonly picture: RefObject<HTMLElement | null> }): ReactNode {
  const { t } = useTexts();
  const { observerController } = useServices();
  const device = useInputDevice();
  const ways = [
    [msg`Turn back`, 'B', () => observerController.turnBack()],
    [msg`Back to the start`, 'R', () => observerController.restart()],
  ] as const;
  return (
    <Group className="sl-top-card" gap="xs" data-outside>
      <Text size="xs">{t(msg`You have left the scene.`)}</Text>
      {ways.map(([title, key, go]) => (
        <Button
          key={key}
          size="compact-xs"
          variant="default"
          aria-keyshortcuts={key}
          onClick={() => {
            go();
            picture.current?.focus();
          }}
        >
          {device === 'touch' ? t(title) : `${t(title)} (${key})`}
        </Button>
      ))}
    </Group>
  );
}
