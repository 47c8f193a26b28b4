import { extensionOf } from '../../formats/files/fileSource.ts';
import { observerPathFrom } from '../../scene/view/observerPath.ts';
import { frameTimes, type ImageOutput, type VideoOutput } from '../project/outputFiles.ts';
import { spacedFrames } from './frameSpacing.ts';
import { initialBeta, pictureCamera, renderSettings } from './renderSettings.ts';
import type { PictureSequence } from './sequence.ts';

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
  const spacing = file.kind === 'video' ? file.spacing : 'world';
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
  };
}
