import { i420 } from '../../formats/image/i420.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import { Mp4File } from './mp4File.ts';

/** Bits per pixel and frame: high quality, since films are kept. */
const BITS_PER_PIXEL = 0.25;
const MAX_BITRATE = 2e8;
/** Interval of keyframes [s]. */
const KEYFRAME_INTERVAL = 2;
/** Frames that may be queued in the encoder. */
const MAX_QUEUED_FRAMES = 4;

/** Codecs, in order of preference. */
const CODECS = ['avc1.640034', 'avc1.64003e', 'avc1.42003e', 'vp09.00.51.08', 'vp09.00.62.08'];

/** Encodes pictures into an MP4 film, if the browser can; no frame is dropped, and each has its exact duration. */
export class Mp4Encoder {
  private readonly frameSize: PictureSize;
  private readonly fps: number;
  private readonly encoder: VideoEncoder;
  private readonly file: Mp4File;
  /** Resolves when the last encoded chunk is in the file. */
  private filed: Promise<void> = Promise.resolve();
  private readonly fail: (error: unknown) => void;
  /** Never resolves; rejects with an error of the encoder. */
  private readonly failed: Promise<never>;
  private count = 0;
  private bytes = 0;

  /** Undefined if the browser has no encoder for that size; `count`: number of frames. */
  static async open(size: PictureSize, fps: number, count: number): Promise<Mp4Encoder | undefined> {
    // Missing in old browsers and on insecure pages, despite its type.
    if (typeof VideoEncoder === 'undefined') return undefined;
    for (const codec of CODECS) {
      const config: VideoEncoderConfig = {
        ...size,
        codec,
        framerate: fps,
        bitrate: Math.min(MAX_BITRATE, Math.ceil(BITS_PER_PIXEL * size.width * size.height * Math.max(fps, 1))),
        latencyMode: 'quality',
        ...(codec.startsWith('avc1') && { avc: { format: 'avc' } }),
      };
      const { supported } = await VideoEncoder.isConfigSupported(config).catch(() => ({ supported: false }));
      if (!supported) continue;
      const file = await Mp4File.begin({ codec: codec.startsWith('avc1') ? 'avc' : 'vp9', fps, count });
      return new Mp4Encoder(size, fps, config, file);
    }
    return undefined;
  }

  private constructor(size: PictureSize, fps: number, config: VideoEncoderConfig, file: Mp4File) {
    this.frameSize = size;
    this.fps = fps;
    this.file = file;
    let fail: (error: unknown) => void = () => {};
    this.failed = new Promise((_, reject) => {
      fail = reject;
    });
    this.failed.catch(() => {});
    this.fail = fail;
    this.encoder = new VideoEncoder({ output: (chunk, metadata) => this.take(chunk, metadata), error: fail });
    this.encoder.configure(config);
  }

  /** Encoded size [bytes]. */
  get size(): number {
    return this.bytes;
  }

  /** RGBA8, rows from the top. */
  async add(rgba: Uint8Array): Promise<void> {
    const { width, height } = this.frameSize;
    const frame = new VideoFrame(i420(width, height, rgba), {
      format: 'I420',
      codedWidth: width,
      codedHeight: height,
      timestamp: this.timeOf(this.count),
      duration: this.timeOf(1),
      colorSpace: { primaries: 'bt709', transfer: 'bt709', matrix: 'bt709', fullRange: false },
    });
    const keyFrame = this.count++ % Math.max(1, Math.round(KEYFRAME_INTERVAL * this.fps)) === 0;
    if (this.encoder.state === 'configured') this.encoder.encode(frame, { keyFrame });
    frame.close();
    while (this.encoder.state !== 'configured' || this.encoder.encodeQueueSize > MAX_QUEUED_FRAMES)
      await Promise.race([this.failed, this.dequeued()]);
  }

  /** Finishes the film. */
  async finish(): Promise<ArrayBuffer> {
    await Promise.race([this.failed, this.encoder.flush()]);
    await Promise.race([this.failed, this.filed]);
    this.close();
    return this.file.finish();
  }

  close(): void {
    if (this.encoder.state !== 'closed') this.encoder.close();
  }

  private dequeued(): Promise<unknown> {
    return new Promise((resolve) => this.encoder.addEventListener('dequeue', resolve, { once: true }));
  }

  /** [µs] */
  private timeOf(place: number): number {
    return Math.round((place * 1e6) / this.fps);
  }

  private take(chunk: EncodedVideoChunk, metadata: EncodedVideoChunkMetadata | undefined): void {
    const data = new Uint8Array(chunk.byteLength);
    chunk.copyTo(data);
    const frame = { data, key: chunk.type === 'key', index: Math.round((chunk.timestamp * this.fps) / 1e6) };
    this.bytes += data.length;
    this.filed = this.filed.then(() => this.file.add(frame, metadata));
    this.filed.catch(this.fail);
  }
}
