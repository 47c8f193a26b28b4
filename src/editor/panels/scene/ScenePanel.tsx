import { Badge, ScrollArea, Stack, Table, Text } from '@mantine/core';
import type { ReactNode } from 'react';
import { inEnglish, msg, type Translate } from '../../../messages/message.ts';
import type { PictureSpec } from '../../../nodes/socketValues.ts';
import { isStatic } from '../../../scene/motion/motion.ts';
import type { Diagnostic } from '../../../scene/types.ts';
import { formatCount, formatLength, formatSeconds, formatSpeed } from '../../format.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useOpenedTexts } from '../../language/useSceneTexts.ts';
import { sceneName } from '../../loading/localFiles.ts';
import { useEditorState } from '../../state/context.tsx';
import { MissingFiles } from './MissingFiles.tsx';
import { MotionSection } from './MotionSection.tsx';
import { OtherScenes } from './OtherScenes.tsx';
import { Section } from './Section.tsx';
import { Variants } from './Variants.tsx';
import { wholes } from './wholes.ts';

/** Content of the open scene, its variants and motion, and the reader's diagnostics. */
export default function ScenePanel(): ReactNode {
  const { t } = useTexts();
  const picture = useEditorState((state) => state.picture);
  const source = useEditorState((state) => state.pictureSource.source);
  return (
    <ScrollArea h="100%" type="auto" scrollbarSize={8} className="sl-panel">
      {picture ? (
        <Stack gap="lg" p="md">
          <About source={source} />
          <OtherScenes source={source} />
          <MissingFiles notes={picture.scene.diagnostics} />
          <Variants sets={picture.scene.variants ?? []} />
          <Figures picture={picture} />
          <MotionSection picture={picture} />
          <Notes notes={picture.scene.diagnostics.filter(({ missing }) => !missing)} />
        </Stack>
      ) : (
        <Text p="md" size="sm" c="dimmed">
          {t(msg`No scene is open.`)}
        </Text>
      )}
    </ScrollArea>
  );
}

function About({ source }: { readonly source: string }): ReactNode {
  const { title, lookFor } = useOpenedTexts();
  return (
    <Stack gap={6}>
      <Text fw={600}>{title}</Text>
      {lookFor && (
        <Text size="sm" lh={1.5}>
          {lookFor}
        </Text>
      )}
      <Text size="xs" c="dimmed" className="sl-place">
        {sceneName(source)}
      </Text>
    </Stack>
  );
}

function Figures({ picture }: { readonly picture: PictureSpec }): ReactNode {
  const { t } = useTexts();
  const { scene, fastest } = picture;
  const triangles = scene.objects.reduce((sum, { mesh }) => sum + mesh.indices.length / 3, 0);
  const moving = wholes(scene.objects.filter(({ motion }) => !isStatic(motion))).size;
  const pieces = scene.objects.filter(({ pieceOf }) => pieceOf !== undefined).length;
  const time = fastest && msg`${formatSpeed(fastest.speed)} at t = ${unbroken(formatSeconds(fastest.time))}`;
  const paths = pathsRow(scene.pathError, t);
  const rows: (readonly [string, ReactNode])[] = [
    [t(msg`Objects`), formatCount(wholes(scene.objects).size)],
    ...(pieces > 0 ? [[t(msg`Pieces that take turns`), formatCount(pieces)] as const] : []),
    [t(msg`Moving`), formatCount(moving)],
    [t(msg`Triangles`), formatCount(triangles)],
    [t(msg`Time range`), `${formatSeconds(scene.startTime)} … ${formatSeconds(scene.endTime)}`],
    ...(time ? [[t(msg`Fastest point`), t(time)] as const] : []),
    ...(paths ? [[t(msg`Paths between samples`), paths] as const] : []),
  ];
  return (
    <Table verticalSpacing={4} horizontalSpacing={0} fz="sm" withRowBorders={false}>
      <Table.Tbody>
        {rows.map(([label, value]) => (
          <Table.Tr key={label}>
            <Table.Th fw={400} c="dimmed" className="sl-nowrap">
              {label}
            </Table.Th>
            <Table.Td ta="right" className="sl-figure">
              {value}
            </Table.Td>
          </Table.Tr>
        ))}
      </Table.Tbody>
    </Table>
  );
}

const unbroken = (text: string): string => text.replaceAll(' ', '\u00a0');

/** Below 1 nm it is rounding error. */
function pathsRow(error: number | undefined, t: Translate): string | undefined {
  if (error === undefined || !Number.isFinite(error)) return undefined;
  return error < 1e-9 ? t(msg`exact`) : t(msg`accurate to ${formatLength(error)}`);
}

const COLORS = { error: 'red', warning: 'yellow', info: 'gray' } as const;

function Notes({ notes }: { readonly notes: readonly Diagnostic[] }): ReactNode {
  const { t } = useTexts();
  if (notes.length === 0) return null;
  return (
    <Section title={t(msg`Diagnostics`)}>
      {notes.map((note) => (
        <Stack gap={2} key={`${note.code} ${inEnglish(note.place)} ${inEnglish(note.message)}`}>
          <Badge size="xs" variant="light" color={COLORS[note.severity]}>
            {note.code}
          </Badge>
          <Text size="xs" ff="monospace" className="sl-place">
            {t(note.place)}
          </Text>
          <Text size="xs">{t(note.message)}</Text>
        </Stack>
      ))}
    </Section>
  );
}
