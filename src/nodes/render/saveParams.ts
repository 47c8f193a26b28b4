import { extensionOf } from '../../formats/files/fileSource.ts';
import type { NumberParam, ParamSpec } from '../../graph/nodeType.ts';
import { type LocalizedText, msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { assertLensShape, fittedSize } from '../../scene/view/lenses/lensChoice.ts';
import type { Lens } from '../../scene/view/lenses/lenses.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import { nodeRefusal } from '../common/params.ts';
import { pictureLens } from '../pictures/renderSettings.ts';
import type { ImageSpec, PictureSpec } from '../socketValues.ts';
import { buildPictureAt } from './pictureFor.ts';

/** Throws a NodeRefusal unless a picture has the shape that its lens makes. */
export function assertShape(lens: Lens, size: PictureSize, node: string): void {
  try {
    assertLensShape(lens, size);
  } catch (error) {
    if (!(error instanceof MessageError)) throw error;
    const { width, height } = fittedSize(lens, { width: size.width, height: MAX_SIDE });
    const remedy = width === size.width ? { node, param: 'height', value: height } : undefined;
    throw nodeRefusal('picture.shape', `${node}.height`, error.text, remedy);
  }
}

const MAX_SIDE = 16384;

const pixelParam = (title: LocalizedText, value: number): NumberParam => ({
  kind: 'number',
  title,
  unit: 'px',
  default: value,
  min: 1,
  max: MAX_SIDE,
  step: 1,
  integer: true,
  slider: false,
});

/** Parameters of all nodes that save pictures. */
export const pictureSizeParams = {
  width: pixelParam(msg`Width`, 1280),
  height: pixelParam(msg`Height`, 720),
} as const satisfies Readonly<Record<string, ParamSpec>>;

/** Samples along each side of a pixel. */
export const samplesParam = (value: number): NumberParam => ({
  kind: 'number',
  title: msg`Samples`,
  help: msg`Along each side of a pixel: 4 means 16 per pixel. If the rasterizer’s antialiasing is off, a pixel shows what is at its centre.`,
  default: value,
  min: 1,
  max: 16,
  step: 1,
  integer: true,
});

/** The picture to write as `name`, in a shape that its lens makes; false colours are for display formats only. */
export function pictureToSave(image: ImageSpec, name: string, size: PictureSize, node: string): PictureSpec {
  const picture = buildPictureAt(image, node);
  assertShape(pictureLens(picture), size, node);
  if (extensionOf(name) !== 'exr' || picture.falseColor === 'none') return picture;
  const message = msg`false colours are for a screen, and an .exr holds light; save them as .png`;
  const remedy = { node, param: 'name', value: name.replace(/\.exr$/i, '.png') };
  throw nodeRefusal('file.falseColour', `${node}.name`, message, remedy);
}
