import { Button, Notification, Stack, Text } from '@mantine/core';
import { IconAlertTriangle, IconCheck } from '@tabler/icons-react';
import { type ReactNode, useEffect, useRef } from 'react';
import { useTexts } from '../i18n/i18n.ts';
import { sceneName } from '../loading/localFiles.ts';
import { shownTitle } from '../panels/nodeTitle.ts';
import { Remedy } from '../panels/Remedy.tsx';
import { SavingCard } from '../saving/SavingCard.tsx';
import { useStudio, useStudioState } from '../state/context.tsx';
import type { Notice } from '../state/studio.ts';

const INFO_LASTS = 4000; // [ms]
/** To read a letter [ms]. */
const LETTER = 50;

/** Of missing files; the Scene panel lists all. */
const MOST_NAMED = 3;

const COLORS = { error: 'red', warning: 'yellow', info: 'teal' } as const;

/** What went wrong, where, and what to do; each until it is put right or put away. */
export function Notices(): ReactNode {
  useRemarks();
  const notices = useStudioState((state) => state.notices);
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

/** Says what a newly opened file lacks, for as long as it is open; else that its reader had something to remark. */
function useRemarks(): void {
  const { t } = useTexts();
  const studio = useStudio();
  const say = useRef(t);
  say.current = t;
  const source = useStudioState((state) => state.opened.source);
  useEffect(() => {
    const scene = studio.store.getState().picture?.scene;
    if (!source || !scene) return;
    const missing = [...new Set(scene.diagnostics.flatMap(({ missing: file }) => (file ? [file.name] : [])))];
    const remarks = scene.diagnostics.filter(({ severity }) => severity !== 'info');
    const warn = (text: string) => {
      const id = studio.notify({ kind: 'warning', text });
      return () => studio.dismiss(id);
    };
    if (missing.length > 0) {
      const files = [...missing.slice(0, MOST_NAMED), ...(missing.length > MOST_NAMED ? ['…'] : [])].join(', ');
      return warn(say.current('notice.missing', { count: missing.length, files }));
    }
    if (scene.objects.length === 0) return warn(say.current('notice.empty', { name: sceneName(source) }));
    if (remarks.length > 0)
      studio.notify({ kind: 'info', text: say.current('notice.warnings', { count: remarks.length }) });
  }, [studio, source]);
}

function NoticeCard({ notice }: { readonly notice: Notice }): ReactNode {
  const { t, said } = useTexts();
  const studio = useStudio();
  const kept = useStudioState((state) => state.picture !== undefined);
  const place = usePlace(notice);
  const error = notice.kind === 'error';
  useEffect(() => {
    if (notice.kind !== 'info' || notice.action) return;
    const timer = setTimeout(() => studio.dismiss(notice.id), Math.max(INFO_LASTS, LETTER * notice.text.length));
    return () => clearTimeout(timer);
  }, [studio, notice]);
  return (
    <Notification
      withBorder
      color={COLORS[notice.kind]}
      icon={notice.kind === 'info' ? <IconCheck size={18} /> : <IconAlertTriangle size={18} />}
      title={error ? t('notice.error') : undefined}
      role={error ? 'alert' : 'status'}
      closeButtonProps={{ 'aria-label': t('close') }}
      onClose={() => studio.dismiss(notice.id)}
    >
      <Stack gap={6}>
        {place && (
          <Text size="xs" ff="monospace" className="sl-place">
            {place}
          </Text>
        )}
        <Text size="sm" c="var(--mantine-color-text)">
          {said(notice.text)}
        </Text>
        {notice.remedy && <Remedy remedy={notice.remedy} />}
        {notice.action && (
          <Button
            size="compact-xs"
            variant="light"
            className="sl-remedy"
            onClick={() => {
              studio.dismiss(notice.id);
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

/** A node by what it is called in the graph. */
function usePlace({ place }: Notice): string | undefined {
  const { any, said } = useTexts();
  const title = useStudioState(({ history }) => (place ? shownTitle(history.document, place) : undefined));
  return title ? any(title) : place && said(place);
}
