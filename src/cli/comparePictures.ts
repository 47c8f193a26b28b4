import { readFile } from 'node:fs/promises';
import { readExr } from '../formats/exrRead.ts';
import { decodeImage } from '../formats/images.ts';
import type { Vec3 } from '../math/vec3.ts';
import type { Canvas } from '../reference/compare/canvas.ts';
import type { ChannelPicture } from '../reference/compare/channels.ts';
import type { Picture } from '../reference/compare/picture.ts';
import { toScreen } from '../reference/display.ts';
import { decodeSrgb } from '../spectrum/srgb.ts';
import { toneMap } from '../spectrum/toneMap.ts';
import { inputProblem } from './exit.ts';

/** A picture from a file: what a screen shows (PNG, JPEG), or channels of linear numbers (EXR). */
export type PictureFile = ScreenFile | ExrFile;

export interface ScreenFile {
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

/** Both, and that they can be compared at all. */
export async function openPair(pathA: string, pathB: string): Promise<readonly [PictureFile, PictureFile]> {
  const [a, b] = [await openPicture(pathA), await openPicture(pathB)];
  if (a.width !== b.width || a.height !== b.height) {
    const size = ({ path, width, height }: PictureFile): string => `${path} has ${width} × ${height}`;
    throw inputProblem(`${size(a)} pixels, ${size(b)}: only pictures of one size can be compared; render both alike`);
  }
  if (a.kind !== b.kind) {
    const [exr, screen] = a.kind === 'exr' ? [a, b] : [b, a];
    throw inputProblem(
      `${exr.path} holds linear light and ${screen.path} what a screen shows: give two .exr, or two .png or .jpg`,
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
    if (code === 'ENOENT' || code === 'ENOTDIR') throw inputProblem(`${path}: there is no such file`);
    if (code === 'EISDIR') throw inputProblem(`${path} is a folder; name a picture`);
    throw error;
  }
}

/** sRGB values 0 … 1 as they are in the file; what is transparent lies over black. */
export function encodedPicture({ width, height, pixels }: ScreenFile): Picture {
  const rgb = new Float32Array(3 * width * height);
  for (let i = 0; i < rgb.length; i++) {
    const pixel = Math.floor(i / 3);
    rgb[i] = (pixels[i + pixel] / 255) * (pixels[4 * pixel + 3] / 255);
  }
  return { width, height, rgb };
}

/** The light that a screen sends for it, linear, 0 … 1. */
export function shownPicture(file: ScreenFile): Picture {
  const { width, height, rgb } = encodedPicture(file);
  return { width, height, rgb: rgb.map(decodeSrgb) };
}

/** R, G and B, which must be there and be numbers. */
export function lightPicture(file: ExrFile): Picture {
  const { path, width, height, channels } = file;
  const planes = ['R', 'G', 'B'].map((name) => {
    const plane = channels.get(name);
    if (!plane) throw inputProblem(`${path} has no channel ${name}; render it with --aov beauty,…`);
    return plane;
  });
  const rgb = Float32Array.from({ length: 3 * width * height }, (_, i) => planes[i % 3][Math.floor(i / 3)]);
  const bad = rgb.findIndex((value) => !Number.isFinite(value));
  if (bad >= 0) {
    const pixel = Math.floor(bad / 3);
    const where = `${pixel % width},${Math.floor(pixel / width)}`;
    throw inputProblem(`${path}: ${'RGB'[bad % 3]} of pixel ${where} is ${rgb[bad]}, not a number to compare`);
  }
  return { width, height, rgb };
}

/** As it looks, to be shown beside its error. */
export function toShow(file: PictureFile, exposure: number): Canvas {
  const { width, height } = file;
  if (file.kind === 'screen') return { width, height, pixels: file.pixels };
  const { rgb } = lightPicture(file);
  const shown = new Float32Array(rgb.length);
  for (let i = 0; i < rgb.length; i += 3) {
    const light: Vec3 = [rgb[i], rgb[i + 1], rgb[i + 2]];
    shown.set(toneMap(light, exposure, 'neutral'), i);
  }
  return { width, height, pixels: toScreen(shown, width, height) };
}
