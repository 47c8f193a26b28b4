import { Button, Group, Text } from '@mantine/core';
import { type ReactNode, type RefObject, useState } from 'react';
import { length, ZERO } from '../../../math/vec3.ts';
import { msg } from '../../../messages/message.ts';
import { formatNumber } from '../../format.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useServices } from '../../services.tsx';
import { useFrames } from '../../viewport/useFrames.ts';
import { useInputDevice } from '../inputDevice.ts';

/** Says that what is seen is held still, how far one has walked, and how to come back. */
export default function HeldCard({ picture }: { readonly picture: RefObject<HTMLElement | null> }): ReactNode {
  const { t } = useTexts();
  const { observerController } = useServices();
  const device = useInputDevice();
  const [walked, setWalked] = useState(0);
  useFrames(({ view }) => setWalked(length(view.viewPoint.vantage ?? ZERO)));
  const back = t(msg`Back to your eye`);
  return (
    <Group className="sl-top-card" gap="xs" data-held>
      <Text size="xs" role="status">
        {t(msg`What you see is held still: walk about in it.`)}
      </Text>
      <Text size="xs" c="dimmed" className="sl-figure">
        {t(msg`${formatNumber(walked, 3)} m from your eye`)}
      </Text>
      <Button
        size="compact-xs"
        variant="default"
        aria-keyshortcuts="H"
        onClick={() => {
          observerController.held?.end();
          picture.current?.focus();
        }}
      >
        {device === 'touch' ? back : `${back} (H)`}
      </Button>
    </Group>
  );
}
