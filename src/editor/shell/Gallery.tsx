import { Badge, Button, Group, Modal, SimpleGrid, Stack, Text, UnstyledButton } from '@mantine/core';
import { IconSchool } from '@tabler/icons-react';
import { type ReactNode, useEffect, useState } from 'react';
import { msg } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import { useTexts } from '../language/languageStore.ts';
import { useSceneTexts } from '../language/useSceneTexts.ts';
import { type Example, loadExamples } from '../loading/examples.ts';
import { Section } from '../panels/scene/Section.tsx';
import { isProject } from '../projects/projectNames.ts';
import { useOpenAddress } from '../projects/useOpenAddress.ts';
import { useEditor, useEditorState } from '../state/context.tsx';

/** Example scenes and projects, each with a thumbnail and what to look for. */
export default function Gallery(): ReactNode {
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
      title={t(msg`Scenes`)}
      closeButtonProps={{ 'aria-label': t(msg`Close`) }}
    >
      <Group justify="space-between" mb="md">
        <Text size="sm" c="dimmed">
          {t(msg`Each shows one relativistic effect.`)}
        </Text>
        <Button
          size="compact-sm"
          variant="light"
          leftSection={<IconSchool size={15} />}
          onClick={() => editor.update({ dialog: undefined, lesson: { step: 1 } })}
        >
          {t(msg`Lessons`)}
        </Button>
      </Group>
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
      editor.notify({ kind: 'error', text: messageOf(error) });
      setExamples([]);
    });
  }, [editor]);
  if (examples?.length === 0) return <Text>{t(msg`No example scenes were found. Open a file of your own.`)}</Text>;
  const choose = (source: string) => {
    open(source);
    onChosen();
  };
  const projects = examples?.filter(({ source }) => isProject(source)) ?? [];
  return (
    <Stack gap="md">
      <Grid examples={examples?.filter(({ source }) => !isProject(source)) ?? []} onChoose={choose} />
      {projects.length > 0 && (
        <Section title={t(msg`Projects`)}>
          <Text size="sm" c="dimmed">
            {t(msg`Graphs of nodes: open one, change it, save it as your own.`)}
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
              {t(msg`Open now`)}
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
