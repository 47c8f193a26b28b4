import { describe, expect, it } from 'vitest';
import { fromAxisAngle } from '../../math/quat.ts';
import { dot, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import type { DomeFilm } from '../../scene/film/film.ts';
import type { FilmEvent, FilmedDome } from '../../scene/film/seenFilm.ts';
import { domeAxes } from '../../scene/lights/latLong.ts';
import type { FilmFrame, OpenFilmFrames } from './filmFrames.ts';
import { FilmPanorama } from './filmPanorama.ts';

const RATE = 10;
const [C, T] = [10, 4.02];

interface GreyFilm {
  readonly frames: number;
  readonly width: number;
  readonly height: number;
  readonly repeats?: boolean;
}

/** Turned about a slanted axis; the film began at −1 s. */
function greyDome({ frames, width, height, repeats = false }: GreyFilm): FilmedDome {
  const file = { name: 'grey.mp4', handle: new Uint8Array() };
  const times = Float64Array.from({ length: frames }, (_, i) => i / RATE);
  const track = { file, bytes: 0, width, height, times, end: frames / RATE };
  const film: DomeFilm = { track, layout: {}, start: -1, speed: 1, repeats };
  const texels = { width, height, data: new Uint8Array(4 * width * height), colorSpace: 'srgb' } as const;
  return {
    ...{ kind: 'dome', path: '/grey', color: [1, 1, 1], film },
    texture: { name: 'grey.mp4', ...texels, filter: 'linear', wrapS: 'repeat', wrapT: 'clamp' },
    orientation: fromAxisAngle(normalize([1, 2, -1]), 2),
  };
}

/** Paints frame k as level k, but its first pixel as 255 − k; notes which were asked for. */
function greyDecoder(asked: number[], given: Partial<FilmFrame> = {}): OpenFilmFrames {
  return ({ width, height }) => ({
    frame: async (index) => {
      asked.push(index);
      const data = new Uint8Array(4 * width * height).fill(index);
      data[0] = 255 - index;
      return { width, height, data, ...given };
    },
    close: () => void asked.push(-1),
  });
}

/** The level of red that a texel should have; −1 where a frame just begins. */
function levelAt(dome: FilmedDome, { t, position, speedOfLight }: FilmEvent, texel: number): number {
  const { width, height } = dome.texture;
  const { start, repeats, track } = dome.film;
  const count = track.times.length;
  const down = (Math.PI * (Math.floor(texel / width) + 0.5)) / height;
  const left = Math.PI * (1 - (2 * ((texel % width) + 0.5)) / width);
  const own: Vec3 = [Math.sin(down) * Math.sin(left), Math.cos(down), Math.sin(down) * Math.cos(left)];
  const ahead = domeAxes(dome).reduce((sum, axis, k) => sum + own[k]! * dot(axis, position), 0);
  const played = (t + ahead / speedOfLight - start) * RATE;
  if (Math.abs(played - Math.round(played)) < 1e-6) return -1;
  const index = Math.floor(played);
  const frame = repeats ? ((index % count) + count) % count : Math.min(Math.max(index, 0), count - 1);
  return texel === 0 ? 255 - frame : frame;
}

const expected = (dome: FilmedDome, here: FilmEvent): number[] =>
  Array.from({ length: dome.texture.width * dome.texture.height }, (_, texel) => levelAt(dome, here, texel));

const reds = ({ data }: { readonly data: Uint8Array | Uint16Array }): number[] =>
  Array.from(data).filter((_, i) => i % 4 === 0);

const event = (t: number, position: Vec3): FilmEvent => ({ t, position, speedOfLight: C });
const EVENTS: readonly FilmEvent[] = [
  event(T, [0, 0, 0]),
  event(T, [5, 0, 0]),
  event(T, [0, -20, 7]),
  event(T, [300, 0, 0]),
  event(-3, [9, 9, 9]),
  event(99, [-9, 1, 9]),
  event(T, scale(normalize([1, 1, 1]), 0.1)),
];

describe('the panorama of a film', () => {
  it.each([
    [false, 60],
    [true, 60],
    [true, 3],
  ] as const)('has in each direction n the frame of t + n·x/c; repeats: %s, %i frames', async (repeats, frames) => {
    const dome = greyDome({ frames, width: 32, height: 16, repeats });
    const panorama = new FilmPanorama(dome, greyDecoder([]));
    for (const here of EVENTS) {
      const picture = await panorama.seenAt(here);
      expect([picture.width, picture.height, picture.name]).toEqual([32, 16, 'grey.mp4']);
      const found = reds(picture);
      const wanted = expected(dome, here);
      expect(found.filter((level, i) => wanted[i] !== -1 && level !== wanted[i])).toEqual([]);
      expect(wanted.filter((level) => level === -1).length).toBeLessThan(8);
    }
  });

  it('is the same object for events that see the same, and a frame is decoded once', async () => {
    const asked: number[] = [];
    const panorama = new FilmPanorama(greyDome({ frames: 60, width: 16, height: 8 }), greyDecoder(asked));
    const first = await panorama.seenAt(event(1.01, [0, 0, 0]));
    expect(await panorama.seenAt(event(1.01, [0, 0, 0]))).toBe(first);
    // Another time within frame 20, and a place from which nothing else is seen.
    expect(await panorama.seenAt(event(1.05, [0.1, 0.2, 0]))).toBe(first);
    expect(asked).toEqual([20]);
    const next = await panorama.seenAt(event(1.15, [0, 0, 0]));
    expect([reds(first)[1], reds(next)[1]]).toEqual([20, 21]);
    expect(await panorama.seenAt(event(1.01, [0, 0, 0]))).toEqual(first);
    const off = await panorama.seenAt(event(1.01, [3, 0, 0]));
    expect(await panorama.seenAt(event(1.01, [3, 0, 0]))).toBe(off);
    expect(await panorama.seenAt(event(1.01, [3, 0, 0.1]))).not.toBe(off);
    expect(new Set(asked).size).toBe(asked.length);
    panorama.close();
    expect(asked.at(-1)).toBe(-1);
  });

  it('keeps no frame that a picture was given away with', async () => {
    const panorama = new FilmPanorama(greyDome({ frames: 60, width: 16, height: 8 }), greyDecoder([]));
    const here = event(1.01, [0, 0, 0]);
    const picture = await panorama.seenAt(here);
    structuredClone(picture, { transfer: [picture.data.buffer] });
    await panorama.seenAt(event(1.15, [0, 0, 0]));
    expect(reds(await panorama.seenAt(here)).slice(1)).toEqual(Array(127).fill(20));
  });

  it('is right also where not all of its frames can be kept, which are then decoded again', async () => {
    const [width, height] = [4096, 2048];
    const asked: number[] = [];
    // Each takes 32 MiB, of 256 that are kept.
    const dome = greyDome({ frames: 60, width, height });
    const panorama = new FilmPanorama(dome, greyDecoder(asked));
    for (const x of [6, -6, 6]) {
      const here = event(2.013, [x, 0, 0]);
      const { data } = await panorama.seenAt(here);
      const places = Array.from({ length: 5000 }, (_, i) => (i * 1_000_003) % (width * height));
      const off = places.filter((place) => ![data[4 * place], -1].includes(levelAt(dome, here, place)));
      expect(off).toEqual([]);
    }
    // 13 frames of 1.2 s, three times.
    expect(asked.length).toBeGreaterThan(13);
    expect(new Set(asked).size).toBeLessThan(asked.length);
  });

  it('is refused where a frame has another size, and is readable again after that', async () => {
    const dome = greyDome({ frames: 60, width: 16, height: 8 });
    let size: Partial<FilmFrame> = { width: 32, height: 16, data: new Uint8Array(4 * 32 * 16) };
    const panorama = new FilmPanorama(dome, (track) => ({
      frame: (index) => greyDecoder([], size)(track).frame(index),
      close: () => undefined,
    }));
    const refused = panorama.seenAt(event(1.01, [0, 0, 0]));
    await expect(refused).rejects.toMatchObject({ diagnostic: { code: 'film.undecodable', place: 'grey.mp4' } });
    await expect(refused).rejects.toThrow('its frame 20 is no panorama of the size of the first');
    size = { width: 16, height: 9, data: new Uint8Array(4 * 16 * 9) };
    await expect(panorama.seenAt(event(1.01, [0, 0, 0]))).rejects.toThrow('its frame 20 is no panorama');
    size = {};
    expect(reds(await panorama.seenAt(event(1.01, [0, 0, 0])))[1]).toBe(20);
  });

  it('may have frames that begin anywhere in memory', async () => {
    const dome = greyDome({ frames: 60, width: 16, height: 8 });
    const odd = (index: number): Uint8Array => new Uint8Array(4 * 128 + 3).fill(index).subarray(3);
    const panorama = new FilmPanorama(dome, () => ({
      frame: async (index) => ({ width: 16, height: 8, data: odd(index) }),
      close: () => undefined,
    }));
    const here = event(T, [5, 0, 0]);
    const wanted = expected(dome, here);
    const found = reds(await panorama.seenAt(here));
    expect(found.filter((level, i) => i > 0 && wanted[i] !== -1 && level !== wanted[i])).toEqual([]);
  });
});
