import { BufferTarget, EncodedPacket, EncodedVideoPacketSource, Mp4OutputFormat, Output } from 'mediabunny';

export interface Mp4Options {
  readonly codec: 'avc' | 'vp9';
  /** Constant frame rate. */
  readonly fps: number;
  /** Expected number of frames. */
  readonly count: number;
}

export interface EncodedFrame {
  readonly data: Uint8Array;
  /** Whether it is a keyframe. */
  readonly key: boolean;
  /** Index in display order. */
  readonly index: number;
}

/**
 * Muxes encoded frames, given in decoding order, into an MP4 file; the metadata that a player needs precedes the
 * frames.
 */
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

  /** `metadata` from the encoder; required with the first frame. */
  async add({ data, key, index }: EncodedFrame, metadata?: EncodedVideoChunkMetadata): Promise<void> {
    const packet = new EncodedPacket(data, key ? 'key' : 'delta', index / this.fps, 1 / this.fps);
    await this.frames.add(packet, metadata);
  }

  async finish(): Promise<ArrayBuffer> {
    await this.output.finalize();
    return this.target.buffer!;
  }
}
