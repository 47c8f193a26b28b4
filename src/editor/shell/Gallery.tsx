import { Badge, Group, Modal, SimpleGrid, Text, UnstyledButton } from '@mantine/core';
import { type ReactNode, useEffect, useState } from 'react';
import { useTexts } from '../i18n/i18n.ts';
import { useSceneWords } from '../i18n/useSceneWords.ts';
import { type Example, loadExamples } from '../loading/examples.ts';
import { useStudio, useStudioState } from '../state/context.tsx';

/** The example scenes, each with a picture and what to look for. */
export function Gallery(): ReactNode {
  const { t } = useTexts();
  const studio = useStudio();
  const opened = useStudioState((state) => state.dialog === 'gallery');
  const close = () => studio.change({ dialog: undefined });
  return (
    <Modal
      opened={opened}
      onClose={close}
      size="min(1080px, 94vw)"
      centered
      title={t('gallery.title')}
      closeButtonProps={{ 'aria-label': t('close') }}
    >
      <Text size="sm" c="dimmed" mb="md">
        {t('gallery.intro')}
      </Text>
      {opened && <Cards onChosen={close} />}
    </Modal>
  );
}

function Cards({ onChosen }: { readonly onChosen: () => void }): ReactNode {
  const { t } = useTexts();
  const studio = useStudio();
  const [examples, setExamples] = useState<readonly Example[]>();
  useEffect(() => {
    loadExamples().then(setExamples, (error: unknown) => {
      studio.notify({ kind: 'error', text: error instanceof Error ? error.message : String(error) });
      setExamples([]);
    });
  }, [studio]);
  if (examples?.length === 0) return <Text>{t('gallery.empty')}</Text>;
  return (
    <SimpleGrid cols={{ base: 1, xs: 2, md: 3 }} spacing="md">
      {examples?.map((example) => (
        <Card
          key={example.source}
          example={example}
          onChoose={() => {
            studio.open(example.source);
            onChosen();
          }}
        />
      ))}
    </SimpleGrid>
  );
}

function Card({ example, onChoose }: { readonly example: Example; readonly onChoose: () => void }): ReactNode {
  const { t } = useTexts();
  const current = useStudioState((state) => state.openSource === example.source);
  const texts = useSceneWords(example.source, example);
  return (
    <UnstyledButton className="sl-card" onClick={onChoose} data-example={example.name}>
      {example.thumbnail ? (
        <img src={example.thumbnail} alt="" className="sl-thumbnail" loading="lazy" />
      ) : (
        <div className="sl-thumbnail" />
      )}
      <div className="sl-card-text">
        <Group gap={8} mb={4}>
          <Text fw={600} size="sm">
            {texts.title}
          </Text>
          {current && (
            <Badge size="xs" variant="default">
              {t('gallery.now')}
            </Badge>
          )}
        </Group>
        <Text size="xs" c="dimmed" lh={1.45} lineClamp={7}>
          {texts.lookFor}
        </Text>
      </div>
    </UnstyledButton>
  );
}
