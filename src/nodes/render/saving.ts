import { extensionOf } from '../../formats/source.ts';
import type { NumberParam, ParamSpec } from '../../graph/nodeType.ts';
import type { Image, Picture } from '../define.ts';
import { refusal } from '../geometry/shared.ts';
import { pictureFor } from './pictureFor.ts';

const MOST_PIXELS = 16384;

const pixels = (title: string, value: number): NumberParam => ({
  kind: 'number',
  title,
  unit: 'px',
  default: value,
  min: 1,
  max: MOST_PIXELS,
  step: 1,
  integer: true,
  slider: false,
});

/** What every node that saves pictures asks for. */
export const saving = {
  width: pixels('param.width', 1280),
  height: pixels('param.height', 720),
} as const satisfies Readonly<Record<string, ParamSpec>>;

/** Along each side of a pixel. */
export const samples = (value: number): NumberParam => ({
  kind: 'number',
  title: 'param.samples',
  help: 'param.samples.help',
  default: value,
  min: 1,
  max: 16,
  step: 1,
  integer: true,
});

/** The picture that is to be written under `name`; colours that stand for numbers are for a screen. */
export function savedPicture(image: Image, name: string, node: string): Picture {
  const picture = pictureFor(image, node);
  if (extensionOf(name) !== 'exr' || picture.falseColor === 'none') return picture;
  const message = 'false colours are for a screen, and an .exr holds light; save them as .png';
  const remedy = { node, param: 'name', value: name.replace(/\.exr$/i, '.png') };
  throw refusal('file.falseColour', `${node}.name`, message, remedy);
}
