import { Button, Container, List, Stack, Text, Title } from '@mantine/core';
import type { ReactNode } from 'react';
import { msg } from '../../messages/message.ts';
import { useTexts } from '../language/languageStore.ts';
import { Logo } from './Logo.tsx';

/** Shown if the browser cannot render: why, and what to do. */
export function Unsupported(): ReactNode {
  const { t } = useTexts();
  return (
    <Container size="sm" py={80} component="main">
      <Stack gap="lg">
        <Logo />
        <Title order={1} size="h2">
          {t(msg`Slowlight needs WebGPU or WebGL 2`)}
        </Title>
        <Text>{t(msg`This browser offers neither, so nothing can be rendered. One of these usually helps:`)}</Text>
        <List spacing="sm">
          <List.Item>{t(msg`Use a current Chrome, Edge, Firefox or Safari.`)}</List.Item>
          <List.Item>
            {t(
              msg`Turn on “Use graphics acceleration when available” in the browser’s system settings, then restart it.`,
            )}
          </List.Item>
          <List.Item>{t(msg`Update the graphics driver.`)}</List.Item>
          <List.Item>{t(msg`Or render without a screen: slowlight render scene.usda -o picture.png`)}</List.Item>
        </List>
        <Button onClick={() => location.reload()} w="fit-content">
          {t(msg`Try again`)}
        </Button>
      </Stack>
    </Container>
  );
}
