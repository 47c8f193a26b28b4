// PNG → WebP by ffmpeg: the same bytes for the same picture and version of ffmpeg.
import { run } from './setup.mjs';

/** Renderings lose what is not seen; data shown as colours is kept exactly. The picture's metadata is not kept. */
export function toWebp(png, webp, { exact = false } = {}) {
  const quality = exact ? ['-lossless', '1', '-quality', '100'] : ['-quality', '92'];
  const codec = ['-map_metadata', '-1', '-c:v', 'libwebp', '-compression_level', '6', ...quality];
  run('ffmpeg', ['-v', 'error', '-y', '-i', png, ...codec, webp]);
}
