import { FlightPlayback } from '../../flight/recording/playback.ts';
import type { FlightRecording } from '../../flight/recording/recording.ts';
import { extensionOf } from '../../formats/files/fileSource.ts';
import { withCourse } from '../../scene/view/cameraCourse.ts';
import { observerPathFrom } from '../../scene/view/observerPath.ts';
import { assertFlownAt, filmClockOf, flightPath } from '../flights/flightPath.ts';
import { type FrameTime, frameTimes, type ImageOutput, type VideoOutput } from '../project/outputFiles.ts';
import { spacedFrames } from './frameSpacing.ts';
import { initialBeta, pictureCamera, pictureLens, renderSettings } from './renderSettings.ts';
import type { PictureSequence } from './sequence.ts';

/** The pictures to render for a file, with the observer that its project describes, or in a flight. */
export function pictureSequence(file: ImageOutput | VideoOutput): PictureSequence {
  const { name, picture, width, height, samples } = file;
  const { falseColor, metering } = picture;
  return {
    settings: renderSettings(picture, 0),
    metering,
    size: { width, height },
    samples: picture.antialiasing ? samples : 1,
    aovs: extensionOf(name) === 'exr' ? ['beauty'] : [],
    ...(falseColor !== 'none' && { falseColour: falseColor }),
    ...(file.kind === 'video' && file.flight ? flown(file, file.flight) : observed(file)),
  };
}

type FramesAndViews = Pick<PictureSequence, 'frames' | 'views'>;

function observed(file: ImageOutput | VideoOutput): FramesAndViews {
  const { picture } = file;
  const { speedOfLight } = picture;
  const isFilm = file.kind === 'video';
  const beta = initialBeta(picture, isFilm);
  const camera = pictureCamera(picture);
  const standpoint = {
    // A course is for its velocity: with another one the camera is a place only.
    camera: picture.smooth && !beta ? withCourse(camera, speedOfLight) : camera,
    stayInPlace: isFilm && file.stayInPlace,
    ...(beta && { beta }),
    lens: pictureLens(picture),
  };
  const frames = spacedFrames(frameTimes(file), isFilm ? file.spacing : 'world', standpoint, speedOfLight);
  const observer = observerPathFrom(standpoint, speedOfLight, frames[0]!.t);
  return { frames, views: (t) => [observer(t)] };
}

/** Throws if the flight was flown at another speed of light than the picture's. */
function flown(file: VideoOutput, flight: FlightRecording): FramesAndViews {
  const { picture } = file;
  assertFlownAt(flight, picture.speedOfLight);
  const playback = new FlightPlayback(flight);
  const observer = flightPath(playback, pictureLens(picture));
  return { frames: flownFrames(file, playback), views: (t) => [observer(t)] };
}

/** Frames of a filmed flight, in the pilot's time. */
export function flownFrames(file: VideoOutput, playback: FlightPlayback): readonly FrameTime[] {
  const clock = filmClockOf(playback, file.spacing);
  return frameTimes(file).map((frame) => ({ ...frame, t: clock.pilotTime(frame.t) }));
}
