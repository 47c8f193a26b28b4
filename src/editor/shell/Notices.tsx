import { Button, Notification, Stack, Text } from '@mantine/core';
import { IconAlertTriangle, IconCheck } from '@tabler/icons-react';
import { type ReactNode, useEffect } from 'react';
import { inEnglish, type Message, msg } from '../../messages/message.ts';
import { isDomeLight } from '../../scene/lights/lightKinds.ts';
import { useTexts } from '../language/languageStore.ts';
import { sceneName } from '../loading/localFiles.ts';
import { placeTitle } from '../panels/nodeTitle.ts';
import { Remedy } from '../panels/Remedy.tsx';
import { SavingCard } from '../saving/SavingCard.tsx';
import { useEditor, useEditorState } from '../state/context.tsx';
import type { Notice } from '../state/editor.ts';

const INFO_DURATION = 4000; // [ms]
/** Additional time per character [ms]. */
const READING_TIME_PER_CHARACTER = 50;

/** Number of missing files named; the Scene panel lists all. */
const MAX_NAMED_FILES = 3;

const COLORS = { error: 'red', warning: 'yellow', info: 'teal' } as const;

/** Notices: what went wrong, where, and what to do; each stays until solved or dismissed. */
export function Notices(): ReactNode {
  useSceneNotices();
  const notices = useEditorState((state) => state.notices);
  return (
    <Stack className="sl-notices" gap="xs">
      <SavingCard />
      <Stack gap="xs" aria-live="polite">
        {notices.map((notice) => (
          <NoticeCard key={notice.id} notice={notice} />
        ))}
      </Stack>
    </Stack>
  );
}

/** Reports missing files of a newly opened scene while it is open; otherwise its diagnostics, if any. */
function useSceneNotices(): void {
  const editor = useEditor();
  const source = useEditorState((state) => state.pictureSource.source);
  useEffect(() => {
    const scene = editor.store.getState().picture?.scene;
    if (!source || !scene) return;
    const missing = [...new Set(scene.diagnostics.flatMap(({ missing: file }) => (file ? [file.name] : [])))];
    const remarks = scene.diagnostics.filter(({ severity }) => severity !== 'info');
    const warn = (text: Message) => {
      const id = editor.notify({ kind: 'warning', text });
      return () => editor.dismiss(id);
    };
    if (missing.length > 0) {
      const files = [...missing.slice(0, MAX_NAMED_FILES), ...(missing.length > MAX_NAMED_FILES ? ['…'] : [])].join(
        ', ',
      );
      return warn(
        msg`Missing files: ${missing.length} (${files}). What needs them is left out or grey. Drop them on the page, or the folder that contains all of them.`,
      );
    }
    if (scene.objects.length === 0 && !scene.lights.some((light) => isDomeLight(light) && light.texture))
      return warn(
        msg`There are no objects in ${sceneName(source)}, so only the sky is visible. Check what was exported; the Scene panel may say more.`,
      );
    if (remarks.length > 0)
      editor.notify({
        kind: 'info',
        text: msg`Diagnostics for this file: ${remarks.length}. See the Scene panel`,
      });
  }, [editor, source]);
}

function NoticeCard({ notice }: { readonly notice: Notice }): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const kept = useEditorState((state) => state.picture !== undefined);
  const place = usePlace(notice);
  const error = notice.kind === 'error';
  const { length } = t(notice.text);
  useEffect(() => {
    if (notice.kind !== 'info' || notice.action) return;
    const timer = setTimeout(
      () => editor.dismiss(notice.id),
      Math.max(INFO_DURATION, READING_TIME_PER_CHARACTER * length),
    );
    return () => clearTimeout(timer);
  }, [editor, notice, length]);
  return (
    <Notification
      withBorder
      color={COLORS[notice.kind]}
      icon={notice.kind === 'info' ? <IconCheck size={18} /> : <IconAlertTriangle size={18} />}
      title={error ? t(msg`Operation failed`) : undefined}
      role={error ? 'alert' : 'status'}
      closeButtonProps={{ 'aria-label': t(msg`Close`) }}
      onClose={() => editor.dismiss(notice.id)}
    >
      <Stack gap={6}>
        {place && (
          <Text size="xs" ff="monospace" className="sl-place">
            {place}
          </Text>
        )}
        <Text size="sm" c="var(--mantine-color-text)">
          {t(notice.text)}
        </Text>
        {notice.remedy && <Remedy remedy={notice.remedy} />}
        {notice.action && (
          <Button
            size="compact-xs"
            variant="light"
            className="sl-remedy"
            onClick={() => {
              editor.dismiss(notice.id);
              notice.action?.act();
            }}
          >
            {t(notice.action.text)}
          </Button>
        )}
        {error && notice.ofDocument && kept && (
          <Text size="xs" c="dimmed">
            {t(msg`The last valid scene is still shown.`)}
          </Text>
        )}
      </Stack>
    </Notification>
  );
}

/** Titles of the node, and its parameter, that a notice refers to. */
function usePlace({ place }: Notice): string | undefined {
  const { t } = useTexts();
  const document = useEditorState(({ history }) => history.document);
  const title = place && placeTitle(document, inEnglish(place));
  return title ? t(title) : place && t(place);
}
