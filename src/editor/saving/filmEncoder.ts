import { i420 } from '../../formats/i420.ts';
import { type EncodedFrame, type FilmCodec, mp4 } from '../../formats/mp4.ts';
import type { Size } from '../../nodes/drawing/painter.ts';

/** Bits for each pixel of each frame: films are kept, so they are to be good. */
const BITS = 0.25;
const MOST_BITS = 2e8;
/** Between frames that can be jumped to [s]. */
const KEYS = 2;
/** Frames that may wait for the encoder. */
const MOST_WAITING = 4;

/** What films can be encoded as, the best first. */
const CODECS = ['avc1.640034', 'avc1.64003e', 'avc1.42003e', 'vp09.00.51.08', 'vp09.00.62.08'];

/** Makes a film of pictures as they come, where the browser can: every one of them is in it, for as long as it is to be seen. */
export class FilmEncoder {
  readonly #size: Size;
  readonly #fps: number;
  readonly #config: VideoEncoderConfig;
  readonly #encoder: VideoEncoder;
  readonly #frames: EncodedFrame[] = [];
  #description: Uint8Array | undefined;
  /** Never comes to anything but the encoder's error. */
  readonly #failed: Promise<never>;
  #count = 0;
  #bytes = 0;

  /** Undefined where this browser has no encoder for films of that size. */
  static async open(size: Size, fps: number): Promise<FilmEncoder | undefined> {
    // Absent from old browsers, and from pages that are not secure, whatever its type says.
    if (typeof VideoEncoder === 'undefined') return undefined;
    for (const codec of CODECS) {
      const config: VideoEncoderConfig = {
        ...size,
        codec,
        framerate: fps,
        bitrate: Math.min(MOST_BITS, Math.ceil(BITS * size.width * size.height * Math.max(fps, 1))),
        latencyMode: 'quality',
        ...(codec.startsWith('avc1') && { avc: { format: 'avc' } }),
      };
      const { supported } = await VideoEncoder.isConfigSupported(config).catch(() => ({ supported: false }));
      if (supported) return new FilmEncoder(size, fps, config);
    }
    return undefined;
  }

  private constructor(size: Size, fps: number, config: VideoEncoderConfig) {
    this.#size = size;
    this.#fps = fps;
    this.#config = config;
    let fail: (error: Error) => void = () => {};
    this.#failed = new Promise((_, reject) => {
      fail = reject;
    });
    this.#failed.catch(() => {});
    this.#encoder = new VideoEncoder({ output: (chunk, metadata) => this.#take(chunk, metadata), error: fail });
    this.#encoder.configure(config);
  }

  /** What is encoded [bytes]. */
  get size(): number {
    return this.#bytes;
  }

  /** RGBA8, rows from the top. */
  async add(rgba: Uint8Array): Promise<void> {
    const { width, height } = this.#size;
    const frame = new VideoFrame(i420(width, height, rgba), {
      format: 'I420',
      codedWidth: width,
      codedHeight: height,
      timestamp: this.#timeOf(this.#count),
      duration: this.#timeOf(1),
      colorSpace: { primaries: 'bt709', transfer: 'bt709', matrix: 'bt709', fullRange: false },
    });
    const keyFrame = this.#count++ % Math.max(1, Math.round(KEYS * this.#fps)) === 0;
    if (this.#encoder.state === 'configured') this.#encoder.encode(frame, { keyFrame });
    frame.close();
    while (this.#encoder.state !== 'configured' || this.#encoder.encodeQueueSize > MOST_WAITING)
      await Promise.race([this.#failed, this.#dequeued()]);
  }

  /** The whole film, as the parts of a file. */
  async finish(): Promise<Uint8Array<ArrayBuffer>[]> {
    await Promise.race([this.#failed, this.#encoder.flush()]);
    this.close();
    return mp4({ ...this.#size, fps: this.#fps, codec: this.#codec(), frames: this.#frames });
  }

  close(): void {
    if (this.#encoder.state !== 'closed') this.#encoder.close();
  }

  #dequeued(): Promise<unknown> {
    return new Promise((resolve) => this.#encoder.addEventListener('dequeue', resolve, { once: true }));
  }

  #codec(): FilmCodec {
    const { codec } = this.#config;
    if (codec.startsWith('vp09')) return { kind: 'vp9', level: Number(codec.split('.')[2]) };
    if (!this.#description) throw new Error('the encoder does not tell how its film is to be read');
    return { kind: 'h264', description: this.#description };
  }

  /** [µs] */
  #timeOf(place: number): number {
    return Math.round((place * 1e6) / this.#fps);
  }

  #take(chunk: EncodedVideoChunk, metadata: EncodedVideoChunkMetadata | undefined): void {
    const data = new Uint8Array(chunk.byteLength);
    chunk.copyTo(data);
    const place = Math.round((chunk.timestamp * this.#fps) / 1e6);
    this.#bytes += data.length;
    this.#frames.push({ data, key: chunk.type === 'key', place });
    const told = metadata?.decoderConfig?.description;
    if (told)
      this.#description = ArrayBuffer.isView(told)
        ? new Uint8Array(told.buffer, told.byteOffset, told.byteLength).slice()
        : new Uint8Array(told).slice();
  }
}
