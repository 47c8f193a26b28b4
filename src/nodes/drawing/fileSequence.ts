import { extensionOf } from '../../formats/source.ts';
import { observerPathFrom } from '../../scene/observerPath.ts';
import { framesOf, type ImageFile, type VideoFile } from '../files.ts';
import { cameraOf, renderSettings, startingBeta } from '../picture.ts';
import type { Sequence } from './sequence.ts';

/** What is to be drawn for a file, seen by the observer that its project describes. */
export function sequenceOf(file: ImageFile | VideoFile): Sequence {
  const { name, picture, width, height, samples } = file;
  const { fovY, falseColor, metering, speedOfLight } = picture;
  const frames = framesOf(file);
  const beta = startingBeta(picture, file.kind === 'video');
  const standpoint = {
    camera: cameraOf(picture),
    hold: file.kind === 'video' && file.hold,
    ...(beta && { beta }),
    ...(fovY !== undefined && { fovY }),
  };
  return {
    settings: renderSettings(picture, 0),
    metering,
    size: { width, height },
    samples: picture.antialiasing ? samples : 1,
    aovs: extensionOf(name) === 'exr' ? ['beauty'] : [],
    ...(falseColor !== 'none' && { falseColour: falseColor }),
    observer: observerPathFrom(standpoint, speedOfLight, frames[0]!.t),
    frames,
  };
}
