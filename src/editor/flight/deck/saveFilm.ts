import { FlightPlayback } from '../../../flight/recording/playback.ts';
import type { FlightRecording } from '../../../flight/recording/recording.ts';
import type { FrameSpacing } from '../../../flight/spacing.ts';
import { msg } from '../../../messages/message.ts';
import { MessageError } from '../../../messages/messageError.ts';
import { filmClockOf } from '../../../nodes/flights/flightPath.ts';
import { saveFile } from '../../saving/useSaveFile.ts';
import type { EditorServices } from '../../services.tsx';
import type { Editor } from '../../state/editor.ts';

/** As "Save video" has it. */
const FILM = { width: 1280, height: 720, samples: 2, fps: 24 } as const;

interface FilmOptions extends Pick<EditorServices, 'backend'> {
  readonly editor: Editor;
  readonly flight: FlightRecording;
  /** By which clock its frames follow each other. */
  readonly spacing: FrameSpacing;
  readonly name: string;
}

/** Films a flight through the scene that is shown, and downloads it. */
export const saveFilm = ({ editor, backend, flight, spacing, name }: FilmOptions): Promise<void> =>
  saveFile({
    node: name,
    editor,
    backend,
    request: () => {
      const { picture } = editor.store.getState();
      if (!picture) throw new MessageError(msg`there is no picture to film`);
      return {
        kind: 'video',
        name,
        picture,
        ...FILM,
        from: 0,
        to: filmClockOf(new FlightPlayback(flight), spacing).duration,
        spacing,
        stayInPlace: false,
        flight,
      };
    },
  });
