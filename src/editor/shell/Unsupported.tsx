import { Button, Container, List, Stack, Text, Title } from '@mantine/core';
import type { ReactNode } from 'react';
import { useTexts } from '../i18n/i18n.ts';
import { Logo } from './Logo.tsx';

/** Shown if the browser cannot render: why, and what to do. */
export function Unsupported(): ReactNode {
  const { t } = useTexts();
  return (
    <Container size="sm" py={80} component="main">
      <Stack gap="lg">
        <Logo />
        <Title order={1} size="h2">
          {t('unsupported.title')}
        </Title>
        <Text>{t('unsupported.body')}</Text>
        <List spacing="sm">
          <List.Item>{t('unsupported.update')}</List.Item>
          <List.Item>{t('unsupported.acceleration')}</List.Item>
          <List.Item>{t('unsupported.driver')}</List.Item>
          <List.Item>{t('unsupported.cli')}</List.Item>
        </List>
        <Button onClick={() => location.reload()} w="fit-content">
          {t('unsupported.retry')}
        </Button>
      </Stack>
    </Container>
  );
}
