import { type ChildProcessByStdio, spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import type { Readable, Writable } from 'node:stream';
import { sphericalMp4Edit } from '../../formats/spherical/sphericalMp4.ts';
import { msg } from '../../messages/message.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { SphericalPicture } from '../../scene/view/sphericalPicture.ts';
import { applyFileEdit } from '../files/fileEdit.ts';
import { killWhenStopped, OutputFile } from '../files/outputFile.ts';
import { partedFile } from '../files/sceneFiles.ts';
import { inputProblem, unavailable } from '../terminal/exitCodes.ts';

/** Extension of the films that ffmpeg encodes. */
export const VIDEO_EXTENSION = 'mp4';

const missingEncoder = () =>
  unavailable(
    msg`mp4 needs the program ffmpeg, which is not on the PATH. On Debian or Ubuntu: apt-get install -y ffmpeg`,
  );

/** Throws if ffmpeg is missing; called before rendering. */
export function checkEncoder(): void {
  if (spawnSync('ffmpeg', ['-version'], { stdio: 'ignore' }).error) throw missingEncoder();
}

/** Encodes frames as an H.264 film in an mp4 file with a running ffmpeg. */
export class VideoWriter {
  private readonly file: OutputFile;
  private readonly encoder: ChildProcessByStdio<Writable, null, Readable>;
  private readonly ended: Promise<number | null>;
  private complaint = '';
  private readonly forget: () => void;

  private constructor(path: string, size: PictureSize, fps: number) {
    this.file = new OutputFile(path);
    this.encoder = spawn('ffmpeg', [...encoderArguments(size, fps), this.file.temporary], {
      stdio: ['pipe', 'ignore', 'pipe'],
    });
    this.forget = killWhenStopped(this.encoder);
    this.encoder.stderr.on('data', (chunk: Buffer) => {
      this.complaint = (this.complaint + chunk.toString()).slice(-2000);
    });
    // Writes after ffmpeg has ended: its exit status and messages are reported instead.
    this.encoder.stdin.on('error', () => {});
    this.ended = once(this.encoder, 'close').then(([code]) => code as number | null);
    this.ended.catch(() => {});
  }

  static async open(path: string, size: PictureSize, fps: number): Promise<VideoWriter> {
    const writer = new VideoWriter(path, size, fps);
    try {
      await once(writer.encoder, 'spawn');
    } catch {
      writer.discard();
      throw missingEncoder();
    }
    return writer;
  }

  /** RGBA8, rows from the top. */
  async add(rgba: Uint8Array): Promise<void> {
    if (this.encoder.stdin.write(rgba)) return;
    await Promise.race([once(this.encoder.stdin, 'drain'), this.ended]);
  }

  /** `spherical`: what the film says about the sphere of directions. */
  async finish(spherical?: SphericalPicture): Promise<void> {
    this.encoder.stdin.end();
    const code = await this.ended;
    this.forget();
    if (code === 0) {
      if (spherical) await this.mark(spherical);
      return this.file.commit();
    }
    this.file.discard();
    throw inputProblem(msg`${this.file.path}: ffmpeg failed: ${this.complaint.trim() || `exit ${code}`}`);
  }

  private async mark(spherical: SphericalPicture): Promise<void> {
    const { temporary, path } = this.file;
    applyFileEdit(temporary, await sphericalMp4Edit(await partedFile(temporary), path, spherical));
  }

  discard(): void {
    this.encoder.kill('SIGKILL');
    this.forget();
    this.file.discard();
  }
}

/** Frames arrive as raw sRGB pixels; players expect BT.709 in limited range. */
function encoderArguments({ width, height }: PictureSize, fps: number): string[] {
  const input = ['-f', 'rawvideo', '-pix_fmt', 'rgba', '-s', `${width}x${height}`, '-r', String(fps), '-i', '-'];
  const color = ['-colorspace', 'bt709', '-color_primaries', 'bt709', '-color_trc', 'bt709', '-color_range', 'tv'];
  const filter = ['-vf', 'scale=out_color_matrix=bt709:out_range=tv,format=yuv420p'];
  const codec = ['-c:v', 'libx264', '-crf', '16', '-preset', 'medium', '-movflags', '+faststart'];
  return ['-hide_banner', '-loglevel', 'error', '-y', ...input, ...filter, ...codec, ...color, '-f', 'mp4'];
}
