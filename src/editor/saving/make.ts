import { zipSync } from 'fflate';
import { extensionOf } from '../../formats/source.ts';
import { CancelledError } from '../../graph/evaluate.ts';
import { NodeRefusal } from '../../graph/nodeType.ts';
import { exrPicture, frameName, pngPicture } from '../../nodes/drawing/encode.ts';
import { sequenceOf } from '../../nodes/drawing/fileSequence.ts';
import { type Frame, framesOfSequence, type Sequence } from '../../nodes/drawing/sequence.ts';
import type { ImageFile, ProjectFile, SceneFile, VideoFile } from '../../nodes/files.ts';
import { writtenScene } from '../../nodes/writtenScene.ts';
import type { Backend } from '../../render/settings.ts';
import { MOST, NotHere } from './notHere.ts';
import { PagePainter } from './pagePainter.ts';

/** A file as it is handed to the person. */
export interface MadeFile {
  readonly name: string;
  readonly content: Blob;
  /** What the file cannot hold. */
  readonly losses?: readonly string[];
}

export interface Making {
  readonly node: string;
  readonly backend: Backend | 'auto';
  readonly signal: AbortSignal;
  /** Hears which part is done, 0 … 1. */
  readonly progress: (part: number) => void;
}

/** What a node asks for; of several files a zip. Throws a NotHere, a NodeRefusal, or a CancelledError. */
export async function makeFile(file: ProjectFile, making: Making): Promise<MadeFile> {
  if (file.kind === 'scene') return sceneFile(file, making);
  const picture = sequenceOf(file);
  if (extensionOf(file.name) !== 'mp4') return pictureFile(file, picture, making);
  const { FilmEncoder } = await import('./filmEncoder.ts');
  const encoder = await FilmEncoder.open(picture.size, file.kind === 'video' ? file.fps : 1, picture.frames.length);
  if (!encoder) throw new NotHere('notice.noFilm');
  try {
    await drawn(file, picture, making, async (frame) => {
      await encoder.add(frame.painted.pixels);
      checkSize(encoder.size);
    });
    return { name: file.name, content: new Blob([await encoder.finish()], { type: 'video/mp4' }) };
  } finally {
    encoder.close();
  }
}

async function sceneFile(file: SceneFile, { node }: Making): Promise<MadeFile> {
  if (extensionOf(file.name) === 'usdc') {
    const message =
      'binary USD is written by Pixar’s own library, which no browser has; the same scene as .usdz holds all of it';
    const remedy = { node, param: 'name', value: file.name.replace(/\.usdc$/i, '.usdz') };
    throw new NodeRefusal({ severity: 'error', code: 'file.binary', place: `${node}.name`, message, remedy });
  }
  const { files, diagnostics } = await writtenScene(file, file.name);
  const losses = diagnostics.filter(({ severity }) => severity !== 'info');
  const told = losses.map(({ place, message }) => `${place.replace(`${file.name}: `, '')}: ${message}`);
  return { ...together(file.name, files), losses: told };
}

async function pictureFile(file: ImageFile | VideoFile, sequence: Sequence, making: Making): Promise<MadeFile> {
  const files = new Map<string, Uint8Array>();
  let size = 0;
  const isLight = sequence.aovs.length > 0;
  await drawn(file, sequence, making, async (frame) => {
    const { painted, number = 0 } = frame;
    const bytes = isLight
      ? exrPicture(sequence.size, painted, frame, file.picture.scene)
      : pngPicture(sequence.size, painted, frame);
    files.set(frameName(file.name, number), bytes);
    size += bytes.length;
    checkSize(size);
  });
  return together(file.name, files);
}

/** Draws frame by frame, as long as nobody cancels. */
async function drawn(
  { picture }: ImageFile | VideoFile,
  sequence: Sequence,
  { backend, signal, progress }: Making,
  take: (frame: Frame) => Promise<void>,
): Promise<void> {
  const painter = await PagePainter.open(backend, picture.scenes, sequence.size);
  const count = sequence.frames.length;
  try {
    endIfCancelled(signal);
    for await (const frame of framesOfSequence(painter, sequence, (done) => progress(done / count))) {
      endIfCancelled(signal);
      await take(frame);
    }
  } finally {
    painter.close();
  }
}

function checkSize(bytes: number): void {
  if (bytes > MOST) throw new NotHere('notice.tooLarge');
}

function endIfCancelled(signal: AbortSignal): void {
  if (signal.aborted) throw new CancelledError();
}

/** One file as it is; several, what is packed already among them, as a zip. */
function together(name: string, files: ReadonlyMap<string, Uint8Array>): MadeFile {
  const [only] = files.values();
  if (files.size === 1 && only) return { name: [...files.keys()][0]!, content: new Blob([only.slice()]) };
  const zip = zipSync(Object.fromEntries(files), { level: 0 });
  return {
    name: `${name.replace(/[._-]?#*\.\w+$/, '')}.zip`,
    content: new Blob([zip.slice()], { type: 'application/zip' }),
  };
}
