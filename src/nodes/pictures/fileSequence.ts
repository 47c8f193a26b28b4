import { FlightPlayback } from '../../flight/recording/playback.ts';
import type { FlightRecording } from '../../flight/recording/recording.ts';
import { extensionOf } from '../../formats/files/fileSource.ts';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { perspective } from '../../scene/view/lens.ts';
import { observerPathFrom } from '../../scene/view/observerPath.ts';
import { filmClockOf, flightPath, flightSpeedOfLight } from '../flights/flightPath.ts';
import { frameTimes, type ImageOutput, type VideoOutput } from '../project/outputFiles.ts';
import { spacedFrames } from './frameSpacing.ts';
import { initialBeta, pictureCamera, renderSettings } from './renderSettings.ts';
import type { PictureSequence } from './sequence.ts';

/** What of a sequence a flight determines: frames in the pilot's time, and the path. Throws if it was flown at another speed of light than the picture's. */
function flown(file: VideoOutput, flight: FlightRecording): Pick<PictureSequence, 'frames' | 'views'> {
  const { picture } = file;
  const c = flightSpeedOfLight(flight);
  if (c !== picture.speedOfLight)
    throw new MessageError(
      msg`the flight was flown at ${c} m/s, and light has ${picture.speedOfLight} m/s now; set it back to that for the film`,
    );
  const playback = new FlightPlayback(flight);
  const clock = filmClockOf(playback, file.spacing);
  const observer = flightPath(playback, perspective(picture.fovY ?? pictureCamera(picture).fovY));
  const frames = frameTimes(file).map((frame) => ({ ...frame, t: clock.pilotTime(frame.t) }));
  return { frames, views: (t) => [observer(t)] };
}

/** The pictures to render for a file, with the observer that its project describes. */
export function pictureSequence(file: ImageOutput | VideoOutput): PictureSequence {
  const { name, picture, width, height, samples } = file;
  const { fovY, falseColor, metering, speedOfLight } = picture;
  const beta = initialBeta(picture, file.kind === 'video');
  const standpoint = {
    camera: pictureCamera(picture),
    hold: file.kind === 'video' && file.hold,
    ...(beta && { beta }),
    ...(fovY !== undefined && { fovY }),
  };
  const flight = file.kind === 'video' ? file.flight : undefined;
  const spacing = file.kind === 'video' && !flight ? file.spacing : 'world';
  const frames = spacedFrames(frameTimes(file), spacing, standpoint, speedOfLight);
  const observer = observerPathFrom(standpoint, speedOfLight, frames[0]!.t);
  return {
    settings: renderSettings(picture, 0),
    metering,
    size: { width, height },
    samples: picture.antialiasing ? samples : 1,
    aovs: extensionOf(name) === 'exr' ? ['beauty'] : [],
    ...(falseColor !== 'none' && { falseColour: falseColor }),
    views: (t) => [observer(t)],
    frames,
    ...(file.kind === 'video' && flight && flown(file, flight)),
  };
}
