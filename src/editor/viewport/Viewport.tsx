import { Button, Group, Progress, Stack, Text, UnstyledButton } from '@mantine/core';
import { IconX } from '@tabler/icons-react';
import { lazy, type ReactNode, type RefObject, Suspense, useEffect, useRef, useState } from 'react';
import { msg } from '../../messages/message.ts';
import { useInputDevice, useLastInput } from '../flight/inputDevice.ts';
import { useFlightControls } from '../flight/useFlightControls.ts';
import { useTexts } from '../language/languageStore.ts';
import { useOpenedTexts } from '../language/useSceneTexts.ts';
import { sceneName } from '../loading/localFiles.ts';
import { useEditor, useEditorState, useLegend, useTelemetry } from '../state/context.tsx';
import { STAGE_TITLES } from '../state/editor.ts';
import { loadPreferences, savePreferences } from '../state/preferences.ts';
import { Poster } from './Poster.tsx';
import { useViewportRenderer } from './useViewportRenderer.ts';

/** Loaded when they are first shown. */
const Legend = lazy(() => import('./legend/Legend.tsx'));
const OverlayLegend = lazy(() => import('./legend/OverlayLegend.tsx'));
const Vignette = lazy(() => import('../flight/comfort/Vignette.tsx'));
const HeldCard = lazy(() => import('../flight/hold/HeldCard.tsx'));
const OutsideView = lazy(() => import('../outside/OutsideView.tsx'));
const OutsideCard = lazy(() => import('./OutsideCard.tsx'));
const PictureTools = lazy(() => import('../inspect/PictureTools.tsx'));
const PictureMenu = lazy(() => import('../inspect/PictureMenu.tsx'));
const TouchControls = lazy(() => import('../flight/touch/TouchControls.tsx'));

/** The picture and its overlays. */
export function Viewport(): ReactNode {
  const { t } = useTexts();
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const generation = useViewportRenderer(canvas);
  const focused = useFlightControls(host);
  useLastInput();
  const device = useInputDevice();
  const tool = useEditorState((state) => state.tool);
  const menu = useEditorState((state) => state.pictureMenu);
  const vignette = useEditorState((state) => state.vignette);
  const held = useEditorState((state) => state.held);
  const outsideView = useEditorState((state) => state.outsideView);
  const colors = useLegend((state) => state.colors);
  const overlaid = useEditorState(({ picture }) => picture && (picture.pastFuture || picture.ghost !== 'none'));
  const shown = useEditorState(({ pictureSource }) => pictureSource.origin || pictureSource.source);
  return (
    <div className="sl-viewport" data-opened={shown}>
      <div
        ref={host}
        className="sl-picture"
        role="application"
        aria-label={t(
          device === 'touch'
            ? msg`Picture. Drag to look around, tap to inspect, rest for a menu; spread two fingers to zoom.`
            : msg`Picture. W A S D Q E fly, arrow keys look around, Tab changes the lock, Escape leaves the picture.`,
        )}
        data-viewport
      >
        {/* A canvas whose context was lost cannot be reused: each generation gets a new one. */}
        <canvas key={generation} ref={canvas} className="sl-canvas" />
        {vignette && (
          <Suspense>
            <Vignette />
          </Suspense>
        )}
      </div>
      <Poster />
      {!focused && <StartHint />}
      {colors && (
        <Suspense>
          <Legend colors={colors} />
        </Suspense>
      )}
      {held && (
        <Suspense>
          <HeldCard picture={host} />
        </Suspense>
      )}
      {outsideView && (
        <Suspense>
          <OutsideView />
        </Suspense>
      )}
      {overlaid && (
        <Suspense>
          <OverlayLegend />
        </Suspense>
      )}
      {tool && (
        <Suspense>
          <PictureTools key={tool} tool={tool} picture={host} />
        </Suspense>
      )}
      <Caption />
      {device === 'touch' && (
        <Suspense>
          <TouchControls picture={host} />
        </Suspense>
      )}
      {menu && (
        <Suspense>
          <PictureMenu at={menu} />
        </Suspense>
      )}
      <CompilingHint />
      <Outside picture={host} />
      <ActivityOverlay picture={host} />
    </div>
  );
}

function StartHint(): ReactNode {
  const { t } = useTexts();
  const device = useInputDevice();
  const open = useEditorState((state) => state.picture?.falseColor === 'none' && !state.loading);
  return open ? (
    <Text size="xs" className="sl-hint">
      {t(
        device === 'touch'
          ? msg`Drag to look around, fly with the pad`
          : msg`Fly with W A S D, drag to look, ? for all keys`,
      )}
    </Text>
  ) : null;
}

/** The scene's description: what to look for. A lesson asks first, and this may hold the answer. */
function Caption(): ReactNode {
  const { t } = useTexts();
  const [shown, setShown] = useState(() => loadPreferences().captions);
  const { title, lookFor } = useOpenedTexts();
  const asked = useEditorState((state) => state.lesson?.name !== undefined);
  const show = (captions: boolean) => {
    setShown(captions);
    savePreferences({ ...loadPreferences(), captions });
  };
  if (!lookFor || asked) return null;
  if (!shown) {
    return (
      <UnstyledButton className="sl-caption sl-caption-closed" onClick={() => show(true)}>
        <Text size="xs">{t(msg`What to look for`)}</Text>
      </UnstyledButton>
    );
  }
  return (
    <aside className="sl-caption" aria-label={t(msg`What to look for`)}>
      <Group justify="space-between" wrap="nowrap" align="start" gap="xs">
        <Text size="sm" fw={600}>
          {title}
        </Text>
        <UnstyledButton aria-label={t(msg`Hide`)} onClick={() => show(false)}>
          <IconX size={14} />
        </UnstyledButton>
      </Group>
      <LookFor key={lookFor} text={lookFor} />
    </aside>
  );
}

/** In a narrow viewport its first lines, until the rest is asked for. */
function LookFor({ text }: { readonly text: string }): ReactNode {
  const { t } = useTexts();
  const part = useRef<HTMLParagraphElement>(null);
  const [isCut, setCut] = useState(false);
  const [isWhole, setWhole] = useState(false);
  useEffect(() => {
    const element = part.current!;
    const observer = new ResizeObserver(() => setCut(element.scrollHeight > element.clientHeight + 1));
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  return (
    <>
      <Text ref={part} size="xs" lh={1.5} className="sl-caption-text" data-whole={isWhole || undefined}>
        {text}
      </Text>
      {(isCut || isWhole) && (
        <UnstyledButton className="sl-caption-more" aria-expanded={isWhole} onClick={() => setWhole(!isWhole)}>
          {t(isWhole ? msg`Less` : msg`More`)}
        </UnstyledButton>
      )}
    </>
  );
}

/** Where one is told to have left the scene. */
function Outside({ picture }: { readonly picture: RefObject<HTMLElement | null> }): ReactNode {
  const outside = useTelemetry((live) => live.outside);
  // The region is there before its text, else screen readers do not read it.
  return (
    <div role="status">
      {outside && (
        <Suspense>
          <OutsideCard picture={picture} />
        </Suspense>
      )}
    </div>
  );
}

/** Shown while shaders compile, if that takes long enough to be noticed (editor.css). */
function CompilingHint(): ReactNode {
  const { t } = useTexts();
  const preparing = useTelemetry((live) => live.preparing);
  const busy = useEditorState((state) => state.loading !== undefined || state.graphics === 'recovering');
  return preparing && !busy ? (
    <Text size="xs" className="sl-hint sl-preparing" role="status">
      {t(msg`Preparing the picture…`)}
    </Text>
  ) : null;
}

/** Running or stopped work. If the focused button disappears, the focus moves to the next one, or to the picture. */
function ActivityOverlay({ picture }: { readonly picture: RefObject<HTMLElement | null> }): ReactNode {
  const box = useRef<HTMLDivElement>(null);
  const within = useRef(false);
  const stage = useEditorState(({ loading, interim }) => (loading ? 'busy' : interim));
  // biome-ignore lint/correctness/useExhaustiveDependencies: these add and remove buttons
  useEffect(() => {
    if (!within.current || document.activeElement !== document.body) return;
    within.current = false;
    (box.current?.querySelector('button') ?? picture.current)?.focus();
  }, [stage, picture]);
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: it only tracks which of its buttons has the focus
    <div
      ref={box}
      onFocus={() => {
        within.current = true;
      }}
      onBlur={({ target }) => {
        // If the button still exists it was blurred; otherwise it lost the focus by its removal.
        queueMicrotask(() => {
          if (target.isConnected) within.current = false;
        });
      }}
    >
      <BusyCard />
      <StoppedCard />
    </div>
  );
}

/** Stages other than reading a scene, which may take minutes. */
const LONG_STAGES = { trace: msg`Reference render`, simulate: msg`Simulating` } as const;

/** A scene being read, or the device restarting. */
function BusyCard(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const loading = useEditorState((state) => state.loading);
  const graphics = useEditorState((state) => state.graphics);
  const shown = useEditorState(({ picture }) => picture !== undefined);
  const running = useEditorState(({ interim }) => interim === 'running');
  if (loading) {
    const { part, stage } = loading;
    const step = t(STAGE_TITLES[stage]);
    const long = stage === 'trace' || stage === 'simulate';
    return (
      <Stack className="sl-busy" gap={8} role="status" data-aside={(shown && long) || undefined}>
        <Text size="sm" fw={600}>
          {long ? t(LONG_STAGES[stage]) : t(msg`Opening ${sceneName(loading.source)}`)}
        </Text>
        {part === undefined ? (
          <div className="sl-working" role="progressbar" aria-label={step} />
        ) : (
          <Progress value={Math.round(100 * part)} size="sm" aria-label={step} transitionDuration={0} />
        )}
        <Group justify="space-between">
          <Text size="xs" c="dimmed">
            {part === undefined ? step : `${step}, ${Math.round(100 * part)} %`}
          </Text>
          <Button size="compact-xs" variant="default" onClick={editor.cancelLoading}>
            {t(running ? msg`Stop` : msg`Cancel`)}
          </Button>
        </Group>
      </Stack>
    );
  }
  const text =
    graphics === 'recovering'
      ? t(msg`The graphics device was lost. Restarting…`)
      : graphics === 'failed'
        ? t(msg`The graphics device keeps failing. Reload the page; if that does not help, update the graphics driver.`)
        : '';
  return text ? (
    <Text className="sl-busy" size="sm" role="status">
      {text}
    </Text>
  ) : null;
}

/** The picture shows an interim result of stopped work. */
function StoppedCard(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const stopped = useEditorState(({ interim, loading }) => interim === 'stopped' && !loading);
  return stopped ? (
    <Group className="sl-busy" justify="space-between" wrap="nowrap" role="status" data-aside>
      <Text size="xs">{t(msg`Stopped: interim results are shown.`)}</Text>
      <Button size="compact-xs" variant="default" onClick={editor.resumeWork}>
        {t(msg`Go on`)}
      </Button>
    </Group>
  ) : null;
}
