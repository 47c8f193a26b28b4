// Paints the film of examples/projects/clocksAround.ts: clocks in all directions whose hands go round once while it lasts.
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { root, SetupError } from './setup.mjs';

const [WIDTH, HEIGHT, FRAMES, RATE, SAMPLES] = [1024, 512, 48, 6, 2];
/** Angular radius of a clock [°], and its colours. */
const RADIUS = 8.5;
const [FACE, RIM, HAND] = [
  [236, 232, 220],
  [196, 142, 44],
  [24, 24, 30],
];

/** By latitude [°], how many clocks there are, and the direction of the first one [°]. */
const RINGS = [
  [0, 16, 0],
  [32, 12, 15],
  [-32, 12, 15],
  [62, 6, 0],
  [-62, 6, 0],
];
const clocks = RINGS.flatMap(([latitude, count, first]) =>
  Array.from({ length: count }, (_, i) => ({ latitude, longitude: first + (360 * i) / count })),
);

const radians = (degrees) => (degrees * Math.PI) / 180;

/** Colour in a direction of a frame: of a clock, or of the sky. */
function colorAt(longitude, latitude, turn) {
  for (const clock of clocks) {
    if (Math.abs(latitude - clock.latitude) > RADIUS) continue;
    const apart = radians(((longitude - clock.longitude + 540) % 360) - 180);
    const [a, b] = [radians(latitude), radians(clock.latitude)];
    // In the plane that touches the sphere in the middle of the clock.
    const [x, y, z] = [
      Math.cos(a) * Math.sin(apart),
      Math.sin(a) * Math.cos(b) - Math.cos(a) * Math.cos(apart) * Math.sin(b),
      Math.sin(a) * Math.sin(b) + Math.cos(a) * Math.cos(apart) * Math.cos(b),
    ];
    const r = Math.acos(Math.min(1, z)) / radians(RADIUS);
    if (r > 1) continue;
    if (r > 0.86) return RIM;
    const angle = Math.atan2(x, y) / (2 * Math.PI);
    const fromHand = Math.abs(((angle - turn + 1.5) % 1) - 0.5) * 2 * Math.PI * r;
    if (fromHand < 0.09 && r < 0.78 && Math.abs(((angle - turn + 1.5) % 1) - 0.5) < 0.25) return HAND;
    const fromHour = Math.abs(((12 * angle + 12.5) % 1) - 0.5) * ((2 * Math.PI) / 12) * r;
    if (r > 0.68 && fromHour < 0.035) return [70, 70, 78];
    return FACE;
  }
  const height = Math.sin(radians(latitude));
  return height > 0 ? [30 + 30 * height, 44 + 34 * height, 84 + 60 * height] : [30 - 8 * height, 30 - 4 * height, 40];
}

function paint(frame) {
  const rgb = new Uint8Array(3 * WIDTH * HEIGHT);
  for (let y = 0; y < HEIGHT; y++)
    for (let x = 0; x < WIDTH; x++) {
      const sum = [0, 0, 0];
      for (let k = 0; k < SAMPLES * SAMPLES; k++) {
        const [u, v] = [
          (x + ((k % SAMPLES) + 0.5) / SAMPLES) / WIDTH,
          (y + (Math.floor(k / SAMPLES) + 0.5) / SAMPLES) / HEIGHT,
        ];
        colorAt(360 * (u - 0.5), 180 * (0.5 - v), frame / FRAMES).forEach((value, i) => {
          sum[i] += value;
        });
      }
      rgb.set(
        sum.map((value) => Math.round(value / SAMPLES ** 2)),
        3 * (y * WIDTH + x),
      );
    }
  return rgb;
}

/** Writes the film. */
export function paintClockFilm(path) {
  const input = ['-f', 'rawvideo', '-pix_fmt', 'rgb24', '-s', `${WIDTH}x${HEIGHT}`, '-r', `${RATE}`, '-i', '-'];
  const color = ['-colorspace', 'bt709', '-color_primaries', 'bt709', '-color_trc', 'bt709', '-color_range', 'tv'];
  const filter = ['-vf', 'scale=out_color_matrix=bt709:out_range=tv,format=yuv420p'];
  const codec = ['-c:v', 'libx264', '-crf', '15', '-preset', 'veryslow', '-g', '12', '-movflags', '+faststart'];
  const frames = Buffer.concat(Array.from({ length: FRAMES }, (_, frame) => paint(frame)));
  const made = spawnSync(
    'ffmpeg',
    ['-loglevel', 'error', '-y', ...input, ...filter, ...codec, ...color, join(root, path)],
    {
      input: frames,
      encoding: 'utf8',
    },
  );
  if (made.status !== 0) throw new SetupError(`ffmpeg: ${made.stderr || made.error}`);
}
