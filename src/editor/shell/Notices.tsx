import { Button, Notification, Stack, Text } from '@mantine/core';
import { IconAlertTriangle, IconCheck } from '@tabler/icons-react';
import { type ReactNode, useEffect, useRef } from 'react';
import { useTexts } from '../i18n/i18n.ts';
import { sceneName } from '../loading/localFiles.ts';
import { displayTitle } from '../panels/nodeTitle.ts';
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
  const { t } = useTexts();
  const editor = useEditor();
  const say = useRef(t);
  say.current = t;
  const source = useEditorState((state) => state.pictureSource.source);
  useEffect(() => {
    const scene = editor.store.getState().picture?.scene;
    if (!source || !scene) return;
    const missing = [...new Set(scene.diagnostics.flatMap(({ missing: file }) => (file ? [file.name] : [])))];
    const remarks = scene.diagnostics.filter(({ severity }) => severity !== 'info');
    const warn = (text: string) => {
      const id = editor.notify({ kind: 'warning', text });
      return () => editor.dismiss(id);
    };
    if (missing.length > 0) {
      const files = [...missing.slice(0, MAX_NAMED_FILES), ...(missing.length > MAX_NAMED_FILES ? ['…'] : [])].join(
        ', ',
      );
      return warn(say.current('notice.missing', { count: missing.length, files }));
    }
    if (scene.objects.length === 0) return warn(say.current('notice.empty', { name: sceneName(source) }));
    if (remarks.length > 0)
      editor.notify({ kind: 'info', text: say.current('notice.warnings', { count: remarks.length }) });
  }, [editor, source]);
}

function NoticeCard({ notice }: { readonly notice: Notice }): ReactNode {
  const { t, translateMessage } = useTexts();
  const editor = useEditor();
  const kept = useEditorState((state) => state.picture !== undefined);
  const place = usePlace(notice);
  const error = notice.kind === 'error';
  useEffect(() => {
    if (notice.kind !== 'info' || notice.action) return;
    const timer = setTimeout(
      () => editor.dismiss(notice.id),
      Math.max(INFO_DURATION, READING_TIME_PER_CHARACTER * notice.text.length),
    );
    return () => clearTimeout(timer);
  }, [editor, notice]);
  return (
    <Notification
      withBorder
      color={COLORS[notice.kind]}
      icon={notice.kind === 'info' ? <IconCheck size={18} /> : <IconAlertTriangle size={18} />}
      title={error ? t('notice.error') : undefined}
      role={error ? 'alert' : 'status'}
      closeButtonProps={{ 'aria-label': t('close') }}
      onClose={() => editor.dismiss(notice.id)}
    >
      <Stack gap={6}>
        {place && (
          <Text size="xs" ff="monospace" className="sl-place">
            {place}
          </Text>
        )}
        <Text size="sm" c="var(--mantine-color-text)">
          {translateMessage(notice.text)}
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
            {notice.action.text}
          </Button>
        )}
        {error && notice.ofDocument && kept && (
          <Text size="xs" c="dimmed">
            {t('notice.sceneKept')}
          </Text>
        )}
      </Stack>
    </Notification>
  );
}

/** Title of the node that a notice refers to. */
function usePlace({ place }: Notice): string | undefined {
  const { textOrKey, translateMessage } = useTexts();
  const title = useEditorState(({ history }) => (place ? displayTitle(history.document, place) : undefined));
  return title ? textOrKey(title) : place && translateMessage(place);
}
