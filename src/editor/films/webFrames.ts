import { type Input, type VideoSample, VideoSampleSink } from 'mediabunny';
import { inputError } from '../../formats/diagnostics/inputError.ts';
import type { FilmFrame, FilmFrames, OpenFilmFrames } from '../../formats/film/filmFrames.ts';
import { filmInput, ReadBudget } from '../../formats/film/filmTrack.ts';
import { type Message, msg } from '../../messages/message.ts';
import { type FilmTrack, lastBefore } from '../../scene/film/film.ts';

/** Frames that are decoded and thrown away rather than that decoding starts anew at a later one. */
const MAX_SKIPPED = 24;

/** Decodes films by the browser, in a worker. */
export const openWebFrames: OpenFilmFrames = (track) => new WebFrames(track);

class WebFrames implements FilmFrames {
  private readonly track: FilmTrack;
  private readonly canvas: OffscreenCanvasRenderingContext2D;
  private readonly budget: ReadBudget;
  private opened: Promise<{ readonly input: Input; readonly sink: VideoSampleSink }> | undefined;
  /** Frames in the order in which they are shown, and the index of the next one. */
  private run: { readonly samples: AsyncGenerator<VideoSample>; next: number } | undefined;

  constructor(track: FilmTrack) {
    this.track = track;
    this.budget = new ReadBudget(track.bytes);
    const canvas = new OffscreenCanvas(track.width, track.height).getContext('2d', { willReadFrequently: true });
    if (!canvas) throw this.undecodable(msg`this browser gives no canvas of ${track.width} × ${track.height} pixels`);
    this.canvas = canvas;
  }

  async frame(index: number): Promise<FilmFrame> {
    const { times, end } = this.track;
    this.budget.renew();
    this.opened ??= this.open();
    const { sink } = await this.opened;
    if (!this.run || index < this.run.next || index > this.run.next + MAX_SKIPPED) {
      await this.stop();
      // Between two frames, so that rounding does not matter.
      this.run = { samples: sink.samples((times[index]! + (times[index + 1] ?? end)) / 2), next: index };
    }
    for (;;) {
      const { value: sample, done } = await this.run.samples.next().catch((error: unknown) => {
        this.run = undefined;
        throw this.undecodable(
          msg`its frame ${index} of ${times.length} cannot be decoded; the browser says: ${String(error)}`,
        );
      });
      if (done)
        throw this.undecodable(
          msg`its frame ${index} of ${times.length} cannot be decoded; the browser says: ${'nothing'}`,
        );
      const shown = lastBefore(times, sample.timestamp);
      this.run.next = shown + 1;
      try {
        if (shown >= index) return this.drawn(sample);
      } finally {
        sample.close();
      }
    }
  }

  close(): void {
    void this.stop().catch(() => {});
    void this.opened?.then(({ input }) => input.dispose()).catch(() => {});
    this.opened = undefined;
  }

  private drawn(sample: VideoSample): FilmFrame {
    const { width, height } = this.track;
    sample.draw(this.canvas, 0, 0, width, height);
    const { data } = this.canvas.getImageData(0, 0, width, height);
    return { width, height, data: new Uint8Array(data.buffer) };
  }

  private async stop(): Promise<void> {
    const { run } = this;
    this.run = undefined;
    await run?.samples.return(undefined);
  }

  private async open() {
    const input = filmInput(this.track, this.budget);
    const video = await input.getPrimaryVideoTrack();
    if (!video || !(await video.canDecode())) {
      const codec = (await video?.getCodec()) ?? '?';
      throw this.undecodable(
        msg`this browser does not decode ${codec}; use another browser, or convert it to H.264 or VP9`,
      );
    }
    return { input, sink: new VideoSampleSink(video) };
  }

  private undecodable(why: Message): Error {
    return inputError('film.undecodable', this.track.file.name, why);
  }
}
