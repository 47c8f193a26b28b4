import { Badge, Group, Modal, SimpleGrid, Stack, Text, UnstyledButton } from '@mantine/core';
import { type ReactNode, useEffect, useState } from 'react';
import { useTexts } from '../i18n/i18n.ts';
import { useSceneTexts } from '../i18n/useSceneTexts.ts';
import { type Example, loadExamples } from '../loading/examples.ts';
import { Section } from '../panels/scene/Section.tsx';
import { isProject } from '../projects/projectNames.ts';
import { useOpenAddress } from '../projects/useOpenAddress.ts';
import { useEditor, useEditorState } from '../state/context.tsx';

/** Example scenes and projects, each with a thumbnail and what to look for. */
export function Gallery(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const opened = useEditorState((state) => state.dialog === 'gallery');
  const close = () => editor.update({ dialog: undefined });
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
  const editor = useEditor();
  const open = useOpenAddress();
  const [examples, setExamples] = useState<readonly Example[]>();
  useEffect(() => {
    loadExamples().then(setExamples, (error: unknown) => {
      editor.notify({ kind: 'error', text: error instanceof Error ? error.message : String(error) });
      setExamples([]);
    });
  }, [editor]);
  if (examples?.length === 0) return <Text>{t('gallery.empty')}</Text>;
  const choose = (source: string) => {
    open(source);
    onChosen();
  };
  const projects = examples?.filter(({ source }) => isProject(source)) ?? [];
  return (
    <Stack gap="md">
      <Grid examples={examples?.filter(({ source }) => !isProject(source)) ?? []} onChoose={choose} />
      {projects.length > 0 && (
        <Section title={t('gallery.projects')}>
          <Text size="sm" c="dimmed">
            {t('gallery.projectsIntro')}
          </Text>
          <Grid examples={projects} onChoose={choose} />
        </Section>
      )}
    </Stack>
  );
}

interface GridProps {
  readonly examples: readonly Example[];
  readonly onChoose: (source: string) => void;
}

function Grid({ examples, onChoose }: GridProps): ReactNode {
  return (
    <SimpleGrid cols={{ base: 1, xs: 2, md: 3 }} spacing="md">
      {examples.map((example) => (
        <Card key={example.source} example={example} onChoose={() => onChoose(example.source)} />
      ))}
    </SimpleGrid>
  );
}

function Card({ example, onChoose }: { readonly example: Example; readonly onChoose: () => void }): ReactNode {
  const { t } = useTexts();
  const current = useEditorState(
    ({ pictureSource: { origin, source } }) =>
      (isProject(example.source) ? origin : origin === '' && source) === example.source,
  );
  const texts = useSceneTexts(example.source, example);
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
