import { Button, NumberInput, Slider, Stack, Switch, Text } from '@mantine/core';
import { type ReactNode, useMemo } from 'react';
import { useStore } from 'zustand';
import type { CollisionKind } from '../../../flight/collision/collide.ts';
import { ATTITUDES, type Attitude } from '../../../flight/controls.ts';
import { FLIGHT_MODES } from '../../../flight/modes/modes.ts';
import type { Vec3 } from '../../../math/vec3.ts';
import { type Message, msg } from '../../../messages/message.ts';
import { isSolid } from '../../../nodes/flights/sceneObstacles.ts';
import { captureCommand, isCaptured, removeCaptureCommand } from '../../../nodes/project/captureCommands.ts';
import { STANDARD_GRAVITY } from '../../../physics/constants.ts';
import { formatNumber } from '../../format.ts';
import { useTexts } from '../../language/languageStore.ts';
import { ObjectSelect } from '../../panels/ObjectSelect.tsx';
import { useServices } from '../../services.tsx';
import { useEditor, useEditorState } from '../../state/context.tsx';
import { ComfortControls } from '../comfort/ComfortControls.tsx';
import { toggleHold } from '../hold/hold.ts';
import { DeckSelect } from './DeckSelect.tsx';
import { DeviceLookSwitch } from './DeviceLookSwitch.tsx';
import { CONTACT_TEXTS, type FlightDeck as Deck, type DeckState } from './deck.ts';
import { FlightRecorderControls } from './FlightRecorderControls.tsx';
import { FrameRateSelect } from './FrameRateSelect.tsx';
import { MAX_THRUST, MODE_NAMES } from './flightSettings.ts';
import { openDeck } from './openDeck.ts';
import { followable, placeBefore } from './targets.ts';

const ATTITUDE_TITLES: Readonly<Record<Attitude, Message>> = {
  hand: msg`By hand`,
  motion: msg`Into the motion`,
  against: msg`Against the motion`,
  push: msg`Where the engine pushes`,
};

/** Modes of flying with their settings, and the recorder. */
export default function FlightDeck(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const { observerController } = useServices();
  const deck = useMemo(() => openDeck(editor, observerController), [editor, observerController]);
  const state = useStore(deck.store);
  const held = useEditorState((editorState) => editorState.held);
  const outsideView = useEditorState((editorState) => editorState.outsideView);
  const document = useEditorState(({ history }) => history.document);
  const { mode } = state;
  return (
    <Stack gap="xs" w="min(290px, calc(100vw - 64px))" data-flight-deck>
      <DeckSelect
        label={t(msg`Way of flying`)}
        description={t(FLIGHT_MODES[mode].help)}
        options={MODE_NAMES.map((value) => [value, FLIGHT_MODES[value].title])}
        value={mode}
        onChange={(value) => deck.choose(value)}
      />
      {mode === 'follow' && <Followed deck={deck} state={state} />}
      {mode === 'autopilot' && <Destination deck={deck} state={state} />}
      {(mode === 'thrust' || mode === 'vehicle' || mode === 'autopilot') && (
        <Thrust title={msg`Thrust along the nose`} value={state.along} onChange={(along) => deck.set({ along })} />
      )}
      {(mode === 'thrust' || mode === 'vehicle') && (
        <Thrust title={msg`Thrust across`} value={state.across} onChange={(across) => deck.set({ across })} />
      )}
      {(mode === 'thrust' || mode === 'follow' || mode === 'autopilot') && (
        <DeckSelect
          label={t(msg`The nose points`)}
          options={ATTITUDES.map((value) => [value, ATTITUDE_TITLES[value]])}
          value={state.attitude}
          onChange={(attitude) => deck.set({ attitude })}
        />
      )}
      <Switch
        size="xs"
        label={t(msg`Keep the horizon level`)}
        checked={state.level}
        onChange={({ currentTarget }) => deck.set({ level: currentTarget.checked })}
      />
      {mode === 'drive' && <GroundControls deck={deck} state={state} />}
      <Switch
        size="xs"
        label={t(msg`Hold what you see, and walk about in it`)}
        checked={held ?? false}
        onChange={() => toggleHold(editor, observerController)}
      />
      <Switch
        size="xs"
        label={t(msg`Look at yourself and the world from outside`)}
        checked={outsideView ?? false}
        onChange={({ currentTarget }) => editor.update({ outsideView: currentTarget.checked })}
      />
      <Switch
        size="xs"
        label={t(msg`Image-based: drawn once for all velocities`)}
        checked={isCaptured(document)}
        onChange={({ currentTarget: { checked } }) =>
          checked
            ? editor.edit(captureCommand(document), msg`draw once for all velocities`)
            : editor.edit(removeCaptureCommand(document), msg`draw at each velocity`)
        }
      />
      <DeviceLookSwitch />
      <ComfortControls />
      <FrameRateSelect />
      <WallControls deck={deck} state={state} />
      <FlightRecorderControls deck={deck} state={state} />
    </Stack>
  );
}

/** Whether one keeps to the ground, and how high. */
function GroundControls({ deck, state: { ground, eyeHeight, contact } }: DeckProps): ReactNode {
  const { t } = useTexts();
  const { observerController } = useServices();
  return (
    <>
      <Switch
        size="xs"
        label={t(msg`Follow the ground`)}
        checked={ground}
        onChange={({ currentTarget }) => deck.set({ ground: currentTarget.checked })}
      />
      {ground && (
        <>
          <NumberInput
            size="xs"
            label={t(msg`Height of the eye above it [m]`)}
            hideControls
            min={0.001}
            decimalScale={3}
            value={eyeHeight}
            onChange={(value) => Number(value) > 0 && deck.set({ eyeHeight: Number(value) })}
          />
          <Button
            size="compact-xs"
            variant="default"
            disabled={contact === 'preparing'}
            onClick={() => {
              // Who holds what he sees goes on from his eye, and who rides a camera leaves it.
              observerController.held?.end();
              observerController.place({});
              deck.comeDown();
            }}
          >
            {t(msg`Come down to the ground`)}
          </Button>
        </>
      )}
    </>
  );
}

const COLLISIONS = ['off', 'stop', 'slide'] as const satisfies readonly (CollisionKind | 'off')[];
const COLLISION_TITLES: Readonly<Record<CollisionKind | 'off', Message>> = {
  off: msg`Fly through walls`,
  stop: msg`Stop before walls`,
  slide: msg`Slide along walls`,
};

/** What happens at walls, and what does just now. */
function WallControls({ deck, state }: DeckProps): ReactNode {
  const { t } = useTexts();
  const deforms = useEditorState(({ picture }) => picture?.scene.objects.some((object) => !isSolid(object)));
  const { collision, clearance, contact } = state;
  return (
    <>
      <DeckSelect
        label={t(msg`Collisions`)}
        options={COLLISIONS.map((value) => [value, COLLISION_TITLES[value]])}
        value={collision ?? 'off'}
        onChange={(value) => deck.set({ collision: value === 'off' ? undefined : value })}
      />
      {collision && (
        <NumberInput
          size="xs"
          label={t(msg`Distance from walls [m]`)}
          hideControls
          min={0.001}
          decimalScale={3}
          value={clearance}
          onChange={(value) => Number(value) > 0 && deck.set({ clearance: Number(value) })}
        />
      )}
      {/* The region is there before its text, else screen readers do not read it. */}
      <div role="status" data-contact={contact}>
        {contact && <Text size="xs">{t(CONTACT_TEXTS[contact])}</Text>}
      </div>
      {collision && deforms && (
        <Text size="xs" c="dimmed">
          {t(msg`What deforms is no wall.`)}
        </Text>
      )}
    </>
  );
}

interface ThrustProps {
  readonly title: Message;
  /** [c/s] */
  readonly value: number;
  readonly onChange: (value: number) => void;
}

function Thrust({ title, value, onChange }: ThrustProps): ReactNode {
  const { t } = useTexts();
  const c = useEditorState((state) => state.picture?.speedOfLight ?? 0);
  const size = value * c;
  const text = t(msg`${formatNumber(size, 3)} m/s² (${formatNumber(size / STANDARD_GRAVITY, 3)} g)`);
  return (
    <div>
      <Text size="xs">
        {t(title)}: <span className="sl-figure">{text}</span>
      </Text>
      <Slider
        size="xs"
        min={0.01}
        max={MAX_THRUST}
        step={0.01}
        label={null}
        thumbLabel={t(title)}
        thumbValueText={text}
        value={value}
        onChange={onChange}
      />
    </div>
  );
}

interface DeckProps {
  readonly deck: Deck;
  readonly state: DeckState;
}

function Followed({ deck, state }: DeckProps): ReactNode {
  const { t } = useTexts();
  const scene = useEditorState(({ picture }) => picture?.scene);
  const paths = useMemo(() => (scene ? followable(scene) : []), [scene]);
  if (paths.length === 0)
    return (
      <Text size="xs" c="dimmed">
        {t(msg`Nothing in this scene moves as a whole.`)}
      </Text>
    );
  return (
    <ObjectSelect
      label={t(msg`What you follow`)}
      data={paths}
      comboboxProps={{ withinPortal: false }}
      value={state.followed ?? null}
      onChange={(path) => deck.set({ followed: path ?? undefined })}
    />
  );
}

function Destination({ deck, state }: DeckProps): ReactNode {
  const { t } = useTexts();
  const { observerController } = useServices();
  const picture = useEditorState((editor) => editor.picture);
  const paths = useMemo(() => picture?.scene.objects.map(({ path }) => path) ?? [], [picture?.scene]);
  const place = state.destination ?? [0, 0, 0];
  const goTo = (path: string | null): void => {
    if (!picture || !path) return;
    const destination = placeBefore(picture.scene, path, observerController.observer, picture.speedOfLight);
    if (destination) deck.set({ destination });
  };
  return (
    <>
      <ObjectSelect
        label={t(msg`Fly to an object`)}
        data={paths}
        comboboxProps={{ withinPortal: false }}
        value={null}
        onChange={goTo}
      />
      <div className="sl-flight-place">
        {(['x', 'y', 'z'] as const).map((axis, k) => (
          <NumberInput
            key={axis}
            size="xs"
            label={t(msg`${axis} [m]`)}
            hideControls
            decimalScale={3}
            value={state.destination ? place[k] : ''}
            onChange={(value) => {
              const next = place.with(k, Number(value) || 0);
              deck.set({ destination: next as unknown as Vec3 });
            }}
          />
        ))}
      </div>
    </>
  );
}
