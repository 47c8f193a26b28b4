import { zipSync } from 'fflate';
import { partOf } from '../../formats/diagnostics/diagnosticLog.ts';
import { formatBytes } from '../../formats/diagnostics/inputError.ts';
import { extensionOf } from '../../formats/files/fileSource.ts';
import { withSphericalMp4 } from '../../formats/spherical/sphericalMp4.ts';
import { CancelledError } from '../../graph/evaluation/evaluator.ts';
import { type LocalizedText, msg } from '../../messages/message.ts';
import { encodeExrPicture, encodePngPicture, frameName } from '../../nodes/pictures/encode.ts';
import { pictureSequence } from '../../nodes/pictures/fileSequence.ts';
import { type PictureFrame, type PictureSequence, renderPictureSequence } from '../../nodes/pictures/sequence.ts';
import { sphericalFileOf } from '../../nodes/pictures/sphericalFile.ts';
import { exportSceneFile } from '../../nodes/project/exportSceneFile.ts';
import type { ImageOutput, RequestedFile, SceneOutput, VideoOutput } from '../../nodes/project/outputFiles.ts';
import { openSession } from '../../pipelines/openSession.ts';
import { interactivePipeline } from '../../pipelines/registry.ts';
import type { Backend } from '../../render/settings.ts';
import type { SphericalPicture } from '../../scene/view/sphericalPicture.ts';
import { pageHost } from '../pipelines/pageHost.ts';
import { MAX_PAGE_BYTES, UnsupportedInPage } from './unsupportedInPage.ts';

/** A file for download. */
export interface MadeFile {
  readonly name: string;
  readonly content: Blob;
  /** Features that the file format cannot hold. */
  readonly losses?: readonly LocalizedText[];
}

export interface MakeFileOptions {
  readonly backend: Backend | 'auto';
  readonly signal: AbortSignal;
  /** Called with the completed fraction, 0 … 1. */
  readonly progress: (part: number) => void;
}

/** Makes what a node requests; several files become a zip. Throws UnsupportedInPage or CancelledError. */
export async function makeFile(file: RequestedFile, options: MakeFileOptions): Promise<MadeFile> {
  if (file.kind === 'scene') return sceneFile(file);
  const picture = pictureSequence(file);
  const format = extensionOf(file.name);
  if (format === 'gif') return gifFile(file, picture, options);
  if (format !== 'mp4') return pictureFile(file, picture, options);
  const { Mp4Encoder } = await import('./mp4Encoder.ts');
  const encoder = await Mp4Encoder.open(picture.size, file.kind === 'video' ? file.fps : 1, picture.frames.length);
  if (!encoder)
    throw new UnsupportedInPage(
      (command) =>
        msg`This browser cannot encode films of that size. Save frames instead (a name like film.####.png), or save the project and run: ${command}`,
    );
  try {
    let spherical: SphericalPicture | undefined;
    await renderFrames(file, picture, options, async (frame) => {
      spherical ??= sphericalFileOf(frame.views, picture.size);
      await encoder.add(frame.rendered.pixels);
      checkSize(encoder.size);
    });
    const film = await encoder.finish();
    const marked = spherical ? await withSphericalMp4(new Uint8Array(film), file.name, spherical) : film;
    return { name: file.name, content: new Blob([marked], { type: 'video/mp4' }) };
  } finally {
    encoder.close();
  }
}

async function sceneFile(file: SceneOutput): Promise<MadeFile> {
  const { files, diagnostics } = await exportSceneFile(file, file.name);
  const losses = diagnostics.filter(({ severity }) => severity !== 'info');
  const told = losses.map(({ place, message }) => msg`${partOf(file.name, place)}: ${message}`);
  return { ...bundleFiles(file.name, files), losses: told };
}

/** Loaded when one is saved. */
async function gifFile(
  file: ImageOutput | VideoOutput,
  sequence: PictureSequence,
  options: MakeFileOptions,
): Promise<MadeFile> {
  const { GifEncoder } = await import('../../formats/image/gif/encodeGif.ts');
  const encoder = new GifEncoder(sequence.size, file.kind === 'video' ? file.fps : 1);
  const parts: BlobPart[] = [];
  let size = 0;
  await renderFrames(file, sequence, options, async ({ rendered }) => {
    const bytes = encoder.add(rendered.pixels);
    parts.push(bytes.slice());
    size += bytes.length;
    checkSize(size);
  });
  return { name: file.name, content: new Blob([...parts, encoder.finish().slice()], { type: 'image/gif' }) };
}

async function pictureFile(
  file: ImageOutput | VideoOutput,
  sequence: PictureSequence,
  options: MakeFileOptions,
): Promise<MadeFile> {
  const files = new Map<string, Uint8Array>();
  let size = 0;
  const isLight = sequence.aovs.length > 0;
  await renderFrames(file, sequence, options, async (frame) => {
    const { rendered, number = 0 } = frame;
    const bytes = isLight
      ? encodeExrPicture(sequence.size, rendered, frame, file.picture.scene)
      : encodePngPicture(sequence.size, rendered, frame);
    files.set(frameName(file.name, number), bytes);
    size += bytes.length;
    checkSize(size);
  });
  return bundleFiles(file.name, files);
}

/** Renders frame by frame until done or cancelled. */
async function renderFrames(
  { picture }: ImageOutput | VideoOutput,
  sequence: PictureSequence,
  { backend, signal, progress }: MakeFileOptions,
  take: (frame: PictureFrame) => Promise<void>,
): Promise<void> {
  const { scenes } = picture;
  const request = {
    scenes: [scenes[0]!, ...scenes.slice(1)],
    size: sequence.size,
    speedOfLight: sequence.settings.speedOfLight,
    options: {},
  } as const;
  const session = await openSession(interactivePipeline(), request, pageHost(backend));
  const count = sequence.frames.length;
  try {
    throwIfCancelled(signal);
    for await (const frame of renderPictureSequence(session, sequence, (done) => progress(done / count))) {
      throwIfCancelled(signal);
      await take(frame);
    }
  } finally {
    await session.close();
  }
}

const tooLargeForPage = () =>
  new UnsupportedInPage(
    (command) =>
      msg`This exceeds the ${formatBytes(MAX_PAGE_BYTES)} that a page can hold. Save the project and run: ${command}`,
  );

function checkSize(bytes: number): void {
  if (bytes > MAX_PAGE_BYTES) throw tooLargeForPage();
}

function throwIfCancelled(signal: AbortSignal): void {
  if (signal.aborted) throw new CancelledError();
}

/** A single file as it is; several as an uncompressed zip, since their formats are compressed already. */
function bundleFiles(name: string, files: ReadonlyMap<string, Uint8Array>): MadeFile {
  const [only] = files.values();
  if (files.size === 1 && only) return { name: [...files.keys()][0]!, content: new Blob([only.slice()]) };
  const zip = zipSync(Object.fromEntries(files), { level: 0 });
  return {
    name: `${name.replace(/[._-]?#*\.\w+$/, '')}.zip`,
    content: new Blob([zip.slice()], { type: 'application/zip' }),
  };
}
