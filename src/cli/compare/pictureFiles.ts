import { readFile } from 'node:fs/promises';
import { decodeImage } from '../../formats/image/decodeImage.ts';
import { readExr } from '../../formats/image/readExr.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { type Message, msg } from '../../messages/message.ts';
import type { ChannelPicture } from '../../reference/compare/channels.ts';
import type { RgbImage } from '../../reference/compare/rgbImage.ts';
import type { PixelCanvas } from '../../reference/figures/pixelCanvas.ts';
import { encodeDisplay } from '../../reference/post/encodeDisplay.ts';
import { decodeSrgb } from '../../spectrum/display/srgb.ts';
import { toneMap } from '../../spectrum/display/toneMap.ts';
import { inputProblem } from '../terminal/exitCodes.ts';

/** A picture from a file: display-referred sRGB (PNG, JPEG) or linear channels (EXR). */
export type PictureFile = EncodedImageFile | ExrFile;

export interface EncodedImageFile {
  readonly kind: 'screen';
  readonly path: string;
  readonly width: number;
  readonly height: number;
  /** RGBA, sRGB. */
  readonly pixels: Uint8Array;
}
export interface ExrFile extends ChannelPicture {
  readonly kind: 'exr';
  readonly path: string;
}

/** Opens two pictures; throws unless they have the same size and kind. */
export async function openPair(pathA: string, pathB: string): Promise<readonly [PictureFile, PictureFile]> {
  const [a, b] = [await openPicture(pathA), await openPicture(pathB)];
  if (a.width !== b.width || a.height !== b.height) {
    const size = ({ path, width, height }: PictureFile): Message => msg`${path} has ${width} × ${height}`;
    throw inputProblem(
      msg`${size(a)} pixels, ${size(b)}: only pictures of one size can be compared; render both alike`,
    );
  }
  if (a.kind !== b.kind) {
    const [exr, screen] = a.kind === 'exr' ? [a, b] : [b, a];
    throw inputProblem(
      msg`${exr.path} holds linear light and ${screen.path} what a screen shows: give two .exr, or two .png or .jpg`,
    );
  }
  return [a, b];
}

const EXR_MAGIC = [0x76, 0x2f, 0x31, 0x01];

async function openPicture(path: string): Promise<PictureFile> {
  const bytes = await readBytes(path);
  if (EXR_MAGIC.some((byte, i) => bytes[i] !== byte)) {
    const { width, height, data } = decodeImage(bytes, path);
    return { kind: 'screen', path, width, height, pixels: data };
  }
  const { width, height, channels } = readExr(bytes, path);
  return { kind: 'exr', path, width, height, channels: new Map(channels.map(({ name, data }) => [name, data])) };
}

async function readBytes(path: string): Promise<Uint8Array> {
  try {
    return new Uint8Array(await readFile(path));
  } catch (error) {
    const code = (error as NodeJS.ErrnoException).code;
    if (code === 'ENOENT' || code === 'ENOTDIR') throw inputProblem(msg`${path}: there is no such file`);
    if (code === 'EISDIR') throw inputProblem(msg`${path} is a folder; name a picture`);
    throw error;
  }
}

/** sRGB-encoded values 0 … 1, composited over black. */
export function encodedRgb({ width, height, pixels }: EncodedImageFile): RgbImage {
  const rgb = new Float32Array(3 * width * height);
  for (let i = 0; i < rgb.length; i++) {
    const pixel = Math.floor(i / 3);
    rgb[i] = (pixels[i + pixel] / 255) * (pixels[4 * pixel + 3] / 255);
  }
  return { width, height, rgb };
}

/** Linear display light 0 … 1. */
export function displayedLinearRgb(file: EncodedImageFile): RgbImage {
  const { width, height, rgb } = encodedRgb(file);
  return { width, height, rgb: rgb.map(decodeSrgb) };
}

/** The channels R, G and B; throws if one is missing or not finite. */
export function linearRgb(file: ExrFile): RgbImage {
  const { path, width, height, channels } = file;
  const planes = ['R', 'G', 'B'].map((name) => {
    const plane = channels.get(name);
    if (!plane) throw inputProblem(msg`${path} has no channel ${name}; render it with --aov beauty,…`);
    return plane;
  });
  const rgb = Float32Array.from({ length: 3 * width * height }, (_, i) => planes[i % 3][Math.floor(i / 3)]);
  const bad = rgb.findIndex((value) => !Number.isFinite(value));
  if (bad >= 0) {
    const pixel = Math.floor(bad / 3);
    const where = `${pixel % width},${Math.floor(pixel / width)}`;
    throw inputProblem(
      msg`${path}: ${'RGB'[bad % 3] ?? ''} of pixel ${where} is ${String(rgb[bad])}, not a number to compare`,
    );
  }
  return { width, height, rgb };
}

/** The picture as displayed, for the triptych; `exposure` [EV] applies to EXR. */
export function displayCanvas(file: PictureFile, exposure: number): PixelCanvas {
  const { width, height } = file;
  if (file.kind === 'screen') return { width, height, pixels: file.pixels };
  const { rgb } = linearRgb(file);
  const shown = new Float32Array(rgb.length);
  for (let i = 0; i < rgb.length; i += 3) {
    const light: Vec3 = [rgb[i], rgb[i + 1], rgb[i + 2]];
    shown.set(toneMap(light, exposure, 'neutral'), i);
  }
  return { width, height, pixels: encodeDisplay(shown, width, height) };
}
