import { BufferTarget, EncodedPacket, EncodedVideoPacketSource, Mp4OutputFormat, Output } from 'mediabunny';

export interface FilmKind {
  readonly codec: 'avc' | 'vp9';
  /** Frames per second, all of one length. */
  readonly fps: number;
  /** How many there are to be. */
  readonly count: number;
}

export interface EncodedFrame {
  readonly data: Uint8Array;
  /** Can be decoded by itself. */
  readonly key: boolean;
  /** Its place in the order in which they are seen. */
  readonly place: number;
}

/** An MP4 file of frames that are encoded already, in the order in which they are decoded; what a player needs stands before the first of them. */
export class FilmFile {
  readonly #fps: number;
  readonly #target = new BufferTarget();
  readonly #output = new Output({ format: new Mp4OutputFormat({ fastStart: 'reserve' }), target: this.#target });
  readonly #frames: EncodedVideoPacketSource;

  static async begin(kind: FilmKind): Promise<FilmFile> {
    const file = new FilmFile(kind);
    await file.#output.start();
    return file;
  }

  private constructor({ codec, fps, count }: FilmKind) {
    this.#fps = fps;
    this.#frames = new EncodedVideoPacketSource(codec);
    this.#output.addVideoTrack(this.#frames, { frameRate: fps, maximumPacketCount: count });
  }

  /** `metadata`: as the encoder gives it, with the first at least. */
  async add({ data, key, place }: EncodedFrame, metadata?: EncodedVideoChunkMetadata): Promise<void> {
    const packet = new EncodedPacket(data, key ? 'key' : 'delta', place / this.#fps, 1 / this.#fps);
    await this.#frames.add(packet, metadata);
  }

  async finish(): Promise<ArrayBuffer> {
    await this.#output.finalize();
    return this.#target.buffer!;
  }
}
