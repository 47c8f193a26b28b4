import { Button, type ButtonProps, FileButton, Group, Kbd, Slider, Stack, Text } from '@mantine/core';
import {
  IconCut,
  IconDownload,
  IconFolderOpen,
  IconMovie,
  IconPlayerPauseFilled,
  IconPlayerPlayFilled,
  IconPlayerRecordFilled,
  IconPlayerStopFilled,
} from '@tabler/icons-react';
import { type ReactNode, useState } from 'react';
import { cutFlight } from '../../../flight/recording/edit.ts';
import { FRAME_SPACINGS, type FrameSpacing } from '../../../flight/spacing.ts';
import { type Message, msg } from '../../../messages/message.ts';
import { messageOf } from '../../../messages/messageError.ts';
import { FLIGHT_EXTENSION, parseFlight, serializeFlight } from '../../../nodes/flights/flightFile.ts';
import { formatSeconds } from '../../format.ts';
import { useTexts } from '../../language/languageStore.ts';
import { fileName, projectName } from '../../projects/projectNames.ts';
import { useSaving } from '../../saving/savingState.ts';
import { useServices } from '../../services.tsx';
import { download } from '../../shell/download.ts';
import { useEditor } from '../../state/context.tsx';
import { DeckSelect } from './DeckSelect.tsx';
import type { DeckState, FlightDeck } from './deck.ts';
import { saveFilm } from './saveFilm.ts';

const SPACING_TITLES: Readonly<Record<FrameSpacing, Message>> = {
  proper: msg`even in your time`,
  world: msg`even in world time`,
};

/** One of the deck's lesser actions. */
const DeckButton = (
  props: ButtonProps & { readonly onClick?: () => void; readonly children: ReactNode },
): ReactNode => <Button size="compact-xs" variant="default" {...props} />;

interface RecorderProps {
  readonly deck: FlightDeck;
  readonly state: DeckState;
}

/** Records, replays, scrubs, cuts, saves and opens flights. */
export function FlightRecorderControls({ deck, state }: RecorderProps): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const { recording, flight } = state;
  const open = async (file: File | null): Promise<void> => {
    if (!file) return;
    try {
      deck.open(parseFlight(await file.text()));
    } catch (error) {
      editor.notify({ kind: 'error', place: msg`${file.name}`, text: messageOf(error) });
    }
  };
  return (
    <Stack gap={6} component="section" aria-label={t(msg`Recording`)}>
      <Group gap={6}>
        <Button
          size="compact-xs"
          variant={recording ? 'filled' : 'light'}
          color="red"
          leftSection={recording ? <IconPlayerStopFilled size={13} /> : <IconPlayerRecordFilled size={13} />}
          rightSection={<Kbd size="xs">K</Kbd>}
          onClick={() => deck.toggleRecording()}
        >
          {recording ? t(msg`Stop`) : t(msg`Record`)}
        </Button>
        <FileButton accept=".json,application/json" onChange={(file) => void open(file)}>
          {(props) => (
            <DeckButton {...props} leftSection={<IconFolderOpen size={13} />}>
              {t(msg`Open a flight`)}
            </DeckButton>
          )}
        </FileButton>
      </Group>
      {flight && !recording && <Replay deck={deck} state={state} />}
    </Stack>
  );
}

function Replay({ deck, state }: RecorderProps): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const { backend, observerController } = useServices();
  const busy = useSaving(({ job }) => job !== undefined);
  const [spacing, setSpacing] = useState<FrameSpacing>('proper');
  const { flight, duration, shown, replaying } = state;
  if (!flight) return null;
  const at = shown ?? 0;
  /** What is held is let go: a replay shows what its pilot saw. */
  const letGo = (): void => observerController.held?.end();
  const name = (extension: string): string => fileName(projectName(editor.store.getState()), extension);
  return (
    <>
      <Group gap={6} wrap="nowrap">
        <Button
          size="compact-xs"
          variant="light"
          leftSection={replaying ? <IconPlayerPauseFilled size={13} /> : <IconPlayerPlayFilled size={13} />}
          onClick={() => {
            letGo();
            deck.toggleReplay();
          }}
        >
          {replaying ? t(msg`Pause`) : t(msg`Replay`)}
        </Button>
        <Text size="xs" className="sl-figure">
          {t(msg`${formatSeconds(at)} of ${formatSeconds(duration)}`)}
        </Text>
        {shown !== undefined && <DeckButton onClick={() => deck.leave()}>{t(msg`Fly on from here`)}</DeckButton>}
      </Group>
      <Slider
        size="xs"
        min={0}
        max={duration}
        step={duration / 1000}
        label={null}
        thumbLabel={t(msg`Time of the flight`)}
        thumbValueText={formatSeconds(at)}
        value={at}
        onChange={(time) => {
          letGo();
          deck.show(time);
        }}
      />
      <Group gap={6}>
        <DeckButton
          leftSection={<IconCut size={13} />}
          disabled={at <= 0 || at >= duration}
          onClick={() => deck.open(cutFlight(flight, at, duration))}
        >
          {t(msg`Cut off before`)}
        </DeckButton>
        <DeckButton
          leftSection={<IconCut size={13} />}
          disabled={at <= 0 || at >= duration}
          onClick={() => deck.open(cutFlight(flight, 0, at))}
        >
          {t(msg`Cut off after`)}
        </DeckButton>
        <DeckButton
          leftSection={<IconDownload size={13} />}
          onClick={() =>
            download(new Blob([serializeFlight(flight)], { type: 'application/json' }), name(FLIGHT_EXTENSION))
          }
        >
          {t(msg`Save the flight`)}
        </DeckButton>
        <DeckButton
          leftSection={<IconMovie size={13} />}
          disabled={busy}
          onClick={() => void saveFilm({ editor, backend, flight, spacing, name: name('.mp4') })}
        >
          {t(msg`Save a film`)}
        </DeckButton>
        <DeckSelect
          aria-label={t(msg`Frames of the film follow`)}
          options={FRAME_SPACINGS.map((value) => [value, SPACING_TITLES[value]])}
          value={spacing}
          onChange={setSpacing}
        />
      </Group>
    </>
  );
}
