import { BufferTarget, EncodedPacket, EncodedVideoPacketSource, Mp4OutputFormat, Output } from 'mediabunny';

export interface Mp4Options {
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
  /** Its index in the order in which they are seen. */
  readonly index: number;
}

/** An MP4 file of frames that are encoded already, in the order in which they are decoded; what a player needs stands before the first of them. */
export class Mp4File {
  private readonly fps: number;
  private readonly target = new BufferTarget();
  private readonly output = new Output({ format: new Mp4OutputFormat({ fastStart: 'reserve' }), target: this.target });
  private readonly frames: EncodedVideoPacketSource;

  static async begin(kind: Mp4Options): Promise<Mp4File> {
    const file = new Mp4File(kind);
    await file.output.start();
    return file;
  }

  private constructor({ codec, fps, count }: Mp4Options) {
    this.fps = fps;
    this.frames = new EncodedVideoPacketSource(codec);
    this.output.addVideoTrack(this.frames, { frameRate: fps, maximumPacketCount: count });
  }

  /** `metadata`: as the encoder gives it, with the first at least. */
  async add({ data, key, index }: EncodedFrame, metadata?: EncodedVideoChunkMetadata): Promise<void> {
    const packet = new EncodedPacket(data, key ? 'key' : 'delta', index / this.fps, 1 / this.fps);
    await this.frames.add(packet, metadata);
  }

  async finish(): Promise<ArrayBuffer> {
    await this.output.finalize();
    return this.target.buffer!;
  }
}
