import { ActionIcon, Group, Slider, Text, Tooltip } from '@mantine/core';
import { IconPlayerPauseFilled, IconPlayerPlayFilled, IconPlayerSkipBackFilled, IconRepeat } from '@tabler/icons-react';
import type { ReactNode } from 'react';
import { msg } from '../../messages/message.ts';
import { filmedDome } from '../../scene/film/seenFilm.ts';
import { isStatic } from '../../scene/motion/motion.ts';
import { formatSeconds } from '../format.ts';
import { useTexts } from '../language/languageStore.ts';
import { useServices } from '../services.tsx';
import { useEditor, useEditorState, useTelemetry } from '../state/context.tsx';
import { computedUntil } from '../state/simulationRuns.ts';

/** World time: play, pause, scrub, loop. */
export function Timeline(): ReactNode {
  const { t } = useTexts();
  return (
    <Group component="section" className="sl-timeline" gap="xs" wrap="nowrap" px="sm" aria-label={t(msg`Timeline`)}>
      <PlayButtons />
      <Scrubber />
      <LoopButton />
    </Group>
  );
}

function PlayButtons(): ReactNode {
  const { t } = useTexts();
  const { observerController } = useServices();
  const playing = useEditorState((state) => state.playing);
  const start = useEditorState((state) => state.picture?.scene.startTime ?? 0);
  const label = playing ? t(msg`Pause`) : t(msg`Play`);
  return (
    <Group gap={2} wrap="nowrap">
      <ActionIcon
        variant="subtle"
        color="gray"
        aria-label={t(msg`Back to the start`)}
        onClick={() => observerController.seek(start)}
      >
        <IconPlayerSkipBackFilled size={14} />
      </ActionIcon>
      <Tooltip label={label} openDelay={400}>
        <ActionIcon variant="light" aria-label={label} onClick={() => observerController.togglePlaying()}>
          {playing ? <IconPlayerPauseFilled size={15} /> : <IconPlayerPlayFilled size={15} />}
        </ActionIcon>
      </Tooltip>
    </Group>
  );
}

function Scrubber(): ReactNode {
  const { t } = useTexts();
  const { observerController } = useServices();
  const time = useTelemetry((live) => live.t);
  const start = useEditorState((state) => state.picture?.scene.startTime ?? 0);
  const end = useEditorState((state) => state.picture?.scene.endTime ?? 0);
  const opened = useEditorState(({ picture }) => picture !== undefined);
  const moves = useEditorState(({ picture }) => {
    const scene = picture?.scene;
    return scene && (scene.objects.some(({ motion }) => !isStatic(motion)) || filmedDome(scene) !== undefined);
  });
  // End of the computed part, if the motion is incomplete.
  const until = useEditorState(({ interim, results }) => (interim ? computedUntil(results) : end));
  return (
    <>
      <Text size="xs" className="sl-figure sl-clock" data-status="world-time">
        t = {formatSeconds(time)}
      </Text>
      {end > start ? (
        <Slider
          className="sl-scrubber"
          size="xs"
          min={start}
          max={end}
          step={(end - start) / 1000}
          label={null}
          marks={until < end ? [{ value: until }] : []}
          value={Math.min(end, Math.max(start, time))}
          onChange={(value) => observerController.seek(value)}
          thumbLabel={t(msg`World time`)}
          thumbValueText={formatSeconds(time)}
        />
      ) : (
        <Text size="xs" c="dimmed" className="sl-scrubber">
          {opened && t(moves ? msg`Time goes on without an end in this scene` : msg`Nothing moves in this scene`)}
        </Text>
      )}
      {end > start && (
        <Text size="xs" c="dimmed" className="sl-figure">
          {formatSeconds(end)}
        </Text>
      )}
    </>
  );
}

function LoopButton(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const loop = useEditorState((state) => state.loop);
  return (
    <Tooltip label={t(msg`Loop`)} openDelay={400}>
      <ActionIcon
        variant={loop ? 'light' : 'subtle'}
        color={loop ? undefined : 'gray'}
        aria-label={t(msg`Loop`)}
        aria-pressed={loop}
        onClick={() => editor.update({ loop: !loop })}
      >
        <IconRepeat size={15} />
      </ActionIcon>
    </Tooltip>
  );
}
