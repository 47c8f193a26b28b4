import { type ChildProcessByStdio, execFile, spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Readable } from 'node:stream';
import { promisify } from 'node:util';
import { inputError } from '../../formats/diagnostics/inputError.ts';
import type { FilmFrame, FilmFrames, OpenFilmFrames } from '../../formats/film/filmFrames.ts';
import { msg } from '../../messages/message.ts';
import type { FilmTrack } from '../../scene/film/film.ts';
import { readRange } from '../../scene/streaming/storedNumbers.ts';
import { unavailable } from '../terminal/exitCodes.ts';
import { killWhenStopped } from './outputFile.ts';

/** Frames that are decoded and thrown away rather than that decoding starts anew at a later one. */
const MAX_SKIPPED = 24;

/** Most frames by which one is decoded before it is shown. */
const MAX_REORDERED = 16;

/** Decodes films with the program ffmpeg. */
export const openFfmpegFrames: OpenFilmFrames = (track) => new FfmpegFrames(track);

/** One that decodes frames in their order. */
interface Decoding {
  readonly process: ChildProcessByStdio<null, Readable, Readable>;
  readonly bytes: StreamReader;
  /** Index of the frame that comes next. */
  next: number;
  complaint: string;
  readonly forget: () => void;
}

class FfmpegFrames implements FilmFrames {
  private readonly track: FilmTrack;
  private decoding: Decoding | undefined;
  private matrix: Promise<string> | undefined;
  /** Of a film that is in memory. */
  private folder: string | undefined;

  constructor(track: FilmTrack) {
    this.track = track;
  }

  async frame(index: number): Promise<FilmFrame> {
    const { decoding } = this;
    const goesOn = decoding && index >= decoding.next && index <= decoding.next + MAX_SKIPPED;
    const current = goesOn ? decoding : await this.start(index);
    const { width, height } = this.track;
    for (;;) {
      const data = await current.bytes.read(4 * width * height);
      if (!data) throw this.undecodable(index, current.complaint);
      if (current.next++ === index) return { width, height, data };
    }
  }

  close(): void {
    this.end();
    if (this.folder) rmSync(this.folder, { recursive: true, force: true });
    this.folder = undefined;
  }

  private end(): void {
    this.decoding?.forget();
    this.decoding?.process.kill('SIGKILL');
    this.decoding = undefined;
  }

  private async start(index: number): Promise<Decoding> {
    this.end();
    const { file, times, width, height } = this.track;
    // Throws where the file has changed since.
    readRange(file, 0, 1);
    const path = this.path();
    this.matrix ??= colorMatrixOf(path, height);
    const rgba = `scale=${width}:${height}:in_color_matrix=${await this.matrix},format=rgba`;
    // By the clock of the file, and between two frames, so that rounding does not matter.
    const before = (frame: number): string => ((times[frame - 1]! + times[frame]!) / 2).toFixed(9);
    const filter = index > 0 ? `select='gte(t,${before(index)})',${rgba}` : rgba;
    // In fragmented MP4 ffmpeg seeks by the times at which frames are decoded, and would begin too late.
    const near = index - MAX_REORDERED;
    const from = near > 0 ? ['-seek_timestamp', '1', '-noaccurate_seek', '-ss', before(near)] : [];
    const input = ['-hide_banner', '-loglevel', 'error', '-nostdin', '-copyts', ...from, '-i', path];
    const output = ['-map', '0:V:0', '-fps_mode', 'passthrough', '-vf', filter, '-f', 'rawvideo', '-'];
    const decoder = spawn('ffmpeg', [...input, ...output], { stdio: ['ignore', 'pipe', 'pipe'] });
    const bytes = new StreamReader(decoder.stdout);
    const forget = killWhenStopped(decoder);
    const decoding: Decoding = { process: decoder, bytes, next: index, complaint: '', forget };
    decoder.stderr.on('data', (chunk: Buffer) => {
      decoding.complaint = (decoding.complaint + chunk.toString()).slice(-2000);
    });
    await spawned(decoder);
    this.decoding = decoding;
    return decoding;
  }

  /** On disk; a film in memory is written to a temporary file, because ffmpeg needs to go back and forth in it. */
  private path(): string {
    const { handle } = this.track.file;
    if (!(handle instanceof Uint8Array)) return (handle as { readonly path: string }).path;
    if (!this.folder) {
      this.folder = mkdtempSync(join(tmpdir(), 'slowlight-'));
      writeFileSync(join(this.folder, 'film'), handle);
    }
    return join(this.folder, 'film');
  }

  private undecodable(index: number, complaint: string): Error {
    const said = complaint.trim().split('\n').at(-1) || 'nothing';
    return inputError(
      'film.undecodable',
      this.track.file.name,
      msg`its frame ${index} of ${this.track.times.length} cannot be decoded; ffmpeg says: ${said}`,
    );
  }
}

async function spawned(process: ReturnType<typeof spawn>): Promise<void> {
  try {
    await once(process, 'spawn');
  } catch {
    throw unavailable(
      msg`films are decoded by the program ffmpeg, which is not on the PATH. On Debian or Ubuntu: apt-get install -y ffmpeg`,
    );
  }
}

/** How YCbCr becomes RGB, as the film says; what says nothing is BT.601 up to 576 rows and else BT.709, as browsers have it. */
async function colorMatrixOf(path: string, height: number): Promise<string> {
  const entries = ['-select_streams', 'V:0', '-show_entries', 'stream=color_space', '-of', 'json'];
  const told = await promisify(execFile)('ffprobe', ['-loglevel', 'error', ...entries, path]).catch(() => undefined);
  const space = told && JSON.parse(told.stdout).streams?.[0]?.color_space;
  if (space && space !== 'unknown') return 'auto';
  return height > 576 ? 'bt709' : 'bt601';
}

/** Takes a stream in parts of a size of one's own. */
class StreamReader {
  private readonly chunks: AsyncIterator<Buffer>;
  private rest: Uint8Array = new Uint8Array();

  constructor(stream: Readable) {
    this.chunks = stream[Symbol.asyncIterator]() as AsyncIterator<Buffer>;
  }

  /** The next `count` bytes; undefined where the stream ends before. */
  async read(count: number): Promise<Uint8Array | undefined> {
    const bytes = new Uint8Array(count);
    for (let done = 0; ; ) {
      const part = this.rest.subarray(0, count - done);
      bytes.set(part, done);
      done += part.length;
      this.rest = this.rest.subarray(part.length);
      if (done === count) return bytes;
      const next = await this.chunks.next();
      if (next.done) return undefined;
      this.rest = next.value;
    }
  }
}
