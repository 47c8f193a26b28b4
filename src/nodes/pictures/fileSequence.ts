import { FlightPlayback } from '../../flight/recording/playback.ts';
import type { FlightRecording } from '../../flight/recording/recording.ts';
import { extensionOf } from '../../formats/files/fileSource.ts';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { perspective } from '../../scene/view/lens.ts';
import { type ObserverPath, observerPathFrom } from '../../scene/view/observerPath.ts';
import { flightPath, flightSpeedOfLight } from '../flights/flightPath.ts';
import { frameTimes, type ImageOutput, type VideoOutput } from '../project/outputFiles.ts';
import type { PictureSpec } from '../socketValues.ts';
import { initialBeta, pictureCamera, renderSettings } from './renderSettings.ts';
import type { PictureSequence } from './sequence.ts';

/** The path of a flight. Throws if it was flown at another speed of light than the picture's. */
function flownPath(flight: FlightRecording, picture: PictureSpec): ObserverPath {
  const c = flightSpeedOfLight(flight);
  if (c !== picture.speedOfLight)
    throw new MessageError(
      msg`the flight was flown at ${c} m/s, and light has ${picture.speedOfLight} m/s now; set it back to that for the film`,
    );
  return flightPath(new FlightPlayback(flight), perspective(picture.fovY ?? pictureCamera(picture).fovY));
}

/** The pictures to render for a file, with the observer that its project describes. */
export function pictureSequence(file: ImageOutput | VideoOutput): PictureSequence {
  const { name, picture, width, height, samples } = file;
  const { fovY, falseColor, metering, speedOfLight } = picture;
  const frames = frameTimes(file);
  const beta = initialBeta(picture, file.kind === 'video');
  const standpoint = {
    camera: pictureCamera(picture),
    hold: file.kind === 'video' && file.hold,
    ...(beta && { beta }),
    ...(fovY !== undefined && { fovY }),
  };
  const { flight } = { flight: undefined, ...file };
  const standing = observerPathFrom(standpoint, speedOfLight, frames[0]!.t);
  const observer = flight ? flownPath(flight, picture) : standing;
  return {
    settings: renderSettings(picture, 0),
    metering,
    size: { width, height },
    samples: picture.antialiasing ? samples : 1,
    aovs: extensionOf(name) === 'exr' ? ['beauty'] : [],
    ...(falseColor !== 'none' && { falseColour: falseColor }),
    views: (t) => [observer(t)],
    frames,
  };
}
