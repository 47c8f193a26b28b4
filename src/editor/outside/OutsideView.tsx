import { ActionIcon, Group, SegmentedControl, Switch, Text } from '@mantine/core';
import { IconMinus, IconPlus, IconX } from '@tabler/icons-react';
import {
  type KeyboardEvent,
  type PointerEvent,
  type ReactNode,
  useEffect,
  useRef,
  useState,
  type WheelEvent,
} from 'react';
import { msg } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import { OBSERVER_MARKS } from '../../scene/frameGraph/effects.ts';
import { OVERLAY_COLORS } from '../../spectrum/display/overlayColors.ts';
import { cssColor } from '../color.ts';
import { formatNumber } from '../format.ts';
import { useTexts } from '../language/languageStore.ts';
import { useEditor, useEditorState } from '../state/context.tsx';
import { useFrames } from '../viewport/useFrames.ts';
import { OutsideDrawer } from './outsideDrawer.ts';
import { firstLook, type OutsideLook, type OutsideShows, ringSeconds, turned } from './outsidePicture.ts';
import './outside.css';

const RADIANS_PER_PIXEL = 0.008;
const KEY_STEP = 0.1;
const NEARER = 1.25;
const KEYS: Readonly<Record<string, readonly [right: number, up: number, nearer: number]>> = {
  ArrowLeft: [-KEY_STEP, 0, 1],
  ArrowRight: [KEY_STEP, 0, 1],
  ArrowUp: [0, KEY_STEP, 1],
  ArrowDown: [0, -KEY_STEP, 1],
  '+': [0, 0, NEARER],
  '=': [0, 0, NEARER],
  '-': [0, 0, 1 / NEARER],
};

/** The outside view in the corner of the picture, with its controls. */
export default function OutsideView(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const canvas = useRef<HTMLCanvasElement>(null);
  const drawer = useRef<OutsideDrawer>(undefined);
  const scene = useEditorState(({ picture }) => picture?.scene);
  const c = useEditorState(({ picture }) => picture?.speedOfLight);
  const shown = useEditorState(({ pictureSource }) => pictureSource.origin || pictureSource.source);
  const [look, setLook] = useState<OutsideLook>();
  useEffect(() => {
    const made = new OutsideDrawer(canvas.current!, (error) =>
      editor.notify({ kind: 'error', text: messageOf(error) }),
    );
    drawer.current = made;
    return () => made.stop();
  }, [editor]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: it stays as it was turned while the scene grows, or light becomes faster
  useEffect(() => {
    if (scene && c) setLook(firstLook(scene, c));
  }, [shown]);
  useFrames((context, now) => {
    if (look) drawer.current?.tick(context, look, now);
  });
  const close = () => editor.update({ outsideView: false });
  const turn = (right: number, up: number, nearer = 1) =>
    setLook((before) => before && turned(before, right, up, nearer));
  const handleKey = (event: KeyboardEvent) => {
    const step = KEYS[event.key];
    if (event.key === 'Escape') close();
    else if (step) turn(...step);
    else return;
    event.preventDefault();
  };
  const drag = ({ buttons, movementX, movementY }: PointerEvent) => {
    if (buttons & 1) turn(-movementX * RADIANS_PER_PIXEL, movementY * RADIANS_PER_PIXEL);
  };
  const zoom = ({ deltaY }: WheelEvent) => turn(0, 0, 1.001 ** -deltaY);
  const shows = look?.shows ?? 'now';
  return (
    <section className="sl-outside" aria-label={t(msg`Outside view`)}>
      <Group justify="space-between" wrap="nowrap" gap={4}>
        <SegmentedControl
          size="xs"
          aria-label={t(msg`Shows`)}
          data={[
            { value: 'now', label: t(msg`The world now`) },
            { value: 'seen', label: t(msg`What is seen`) },
          ]}
          value={shows}
          onChange={(value) => setLook((before) => before && { ...before, shows: value as OutsideShows })}
        />
        <Group gap={2} wrap="nowrap">
          <Tool title={t(msg`Nearer`)} act={() => turn(0, 0, NEARER)} icon={<IconPlus size={14} />} />
          <Tool title={t(msg`Farther`)} act={() => turn(0, 0, 1 / NEARER)} icon={<IconMinus size={14} />} />
          <Tool title={t(msg`Close`)} act={close} icon={<IconX size={14} />} />
        </Group>
      </Group>
      <div
        className="sl-outside-picture"
        role="application"
        // biome-ignore lint/a11y/noNoninteractiveTabindex: it is turned by keys
        tabIndex={0}
        aria-label={t(msg`The world from outside. Arrow keys turn it, + and − come nearer and go away.`)}
        onKeyDown={handleKey}
        onPointerDown={({ currentTarget, pointerId }) => currentTarget.setPointerCapture(pointerId)}
        onPointerMove={drag}
        onWheel={zoom}
      >
        <canvas ref={canvas} />
      </div>
      <Mark color={OBSERVER_MARKS.body}>{t(msg`You, and how far you come from ring to ring`)}</Mark>
      {look && c && (
        <Mark color={OBSERVER_MARKS.ring}>
          {t(msg`Rings: ${formatNumber(ringSeconds(look.distance, c), 1)} s of light apart`)}
        </Mark>
      )}
      <Switch
        size="xs"
        checked={look?.contours ?? false}
        label={
          <Mark color={OVERLAY_COLORS.contour}>
            {t(shows === 'now' ? msg`Contours of what is seen, where it was` : msg`Contours of the world now`)}
          </Mark>
        }
        onChange={({ currentTarget: { checked } }) => setLook((before) => before && { ...before, contours: checked })}
      />
    </section>
  );
}

interface OutsideToolProps {
  readonly title: string;
  readonly act: () => void;
  readonly icon: ReactNode;
}

const Tool = ({ title, act, icon }: OutsideToolProps): ReactNode => (
  <ActionIcon size="sm" variant="subtle" color="gray" aria-label={title} title={title} onClick={act}>
    {icon}
  </ActionIcon>
);

interface MarkProps {
  readonly color: readonly [number, number, number];
  readonly children: ReactNode;
}

/** A line of the legend. */
const Mark = ({ color, children }: MarkProps): ReactNode => (
  <Text size="xs" component="span" className="sl-outside-mark">
    <span style={{ background: cssColor(color) }} aria-hidden />
    {children}
  </Text>
);
