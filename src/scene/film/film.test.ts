import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { direction, uniform } from '../../../tests/support/physicsArbitraries.ts';
import { fromAxisAngle, IDENTITY, multiply, toMatrix } from '../../math/quat.ts';
import { dot, scale, type Vec3 } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { dopplerFactor } from '../../physics/optics/doppler.ts';
import { makeScene } from '../defaults.ts';
import { retime } from '../motion/retime.ts';
import type { DomeLight, DomePicture, Scene } from '../types.ts';
import { DEFAULT_SETTINGS } from '../view/view.ts';
import type { View } from '../views/views.ts';
import { type DomeFilm, filmDuration, frameAt } from './film.ts';
import {
  type FilmEvent,
  type FilmedDome,
  filmEventOf,
  filmedDome,
  filmTimeOf,
  framesSeen,
  onlyFrameSeen,
  withDomePicture,
  withoutFilm,
} from './seenFilm.ts';

/** Ticks a second: those of 24, 25 and 30 frames a second. */
const TICKS = 600;

/** A film whose frames begin at ticks, exactly. */
interface TickedFilm {
  readonly begins: readonly number[];
  readonly end: number;
}

const tickedFilm = fc
  .tuple(fc.nat(2000), fc.array(fc.integer({ min: 1, max: 90 }), { minLength: 1, maxLength: 25 }))
  .map(([first, lasts]): TickedFilm => {
    let end = first;
    const begins = lasts.map((last) => {
      end += last;
      return end - last;
    });
    return { begins, end };
  });
const even = (frames: number, rate: number): TickedFilm => ({
  begins: Array.from({ length: frames }, (_, i) => (i * TICKS) / rate),
  end: (frames * TICKS) / rate,
});

const made = ({ begins, end }: TickedFilm, how: Partial<DomeFilm> = {}): DomeFilm => ({
  track: {
    file: { name: 'film.mp4', handle: new Uint8Array() },
    bytes: 0,
    width: 16,
    height: 8,
    times: Float64Array.from(begins, (tick) => tick / TICKS),
    end: end / TICKS,
  },
  layout: {},
  start: 0,
  speed: 1,
  repeats: false,
  ...how,
});

/** By counting, in whole numbers: the frame `tick` ticks after the first began. */
function frameByTick({ begins, end }: TickedFilm, tick: number, repeats: boolean): number {
  const [first] = begins as [number];
  const round = end - first;
  const shown = repeats ? ((tick % round) + round) % round : tick;
  return Math.max(0, begins.filter((begin) => begin - first <= shown).length - 1);
}

const speeds = fc.constantFrom(1, 2, 0.5, 3, 1 / 3, 0.1, 29.97);

describe('the frame in the origin', () => {
  it('is the last that has begun, also at the very time at which it begins, whatever its start and speed', () => {
    const times = fc.record({
      tick: fc.oneof(fc.integer({ min: -4000, max: 8000 }), fc.integer({ min: -6e7, max: 6e7 })),
      start: fc.oneof(fc.constant(0), uniform(-1000, 1000), fc.constantFrom(0.1, 1 / 3, -7.7, 86400.3)),
    });
    fc.assert(
      fc.property(tickedFilm, times, speeds, fc.boolean(), (ticked, { tick, start }, speed, repeats) => {
        const film = made(ticked, { start, speed, repeats });
        expect(frameAt(film, start + tick / (TICKS * speed))).toBe(frameByTick(ticked, tick, repeats));
      }),
      { numRuns: 3000 },
    );
  });

  it.each([24, 25, 30])('at %i frames a second each begins at its multiple, in every round', (rate) => {
    const film = made(even(7, rate), { repeats: true });
    const found = Array.from({ length: 20_000 }, (_, i) => frameAt(film, i / rate));
    expect(found.filter((frame, i) => frame !== i % 7)).toEqual([]);
    const before = Array.from({ length: 700 }, (_, i) => frameAt(film, -i / rate));
    expect(before.filter((frame, i) => frame !== (7 - (i % 7)) % 7)).toEqual([]);
  });

  it('is the first before it starts and the last after it ends, or it repeats, as it is told', () => {
    const ticked: TickedFilm = { begins: [60, 120, 300], end: 360 };
    // Rounds of 0.5 s, of which the frames take 0.1, 0.3 and 0.1.
    const at = (repeats: boolean, ...times: number[]) =>
      times.map((time) => frameAt(made(ticked, { start: 10, repeats }), time));
    expect(at(false, -99, 9.99, 10, 10.09, 10.1, 10.39, 10.4, 10.49, 10.5, 99)).toEqual([0, 0, 0, 0, 1, 1, 2, 2, 2, 2]);
    expect(at(true, 9.5, 9.61, 9.95, 10, 10.05, 10.5, 10.55, 10.65, 1010.05, -989.55)).toEqual([
      0, 1, 2, 0, 0, 0, 0, 1, 0, 2,
    ]);
  });

  it('lasts for its part of the duration, which is shorter at speed', () => {
    expect(filmDuration(made({ begins: [60, 120, 300], end: 360 }, { start: 5 }))).toBeCloseTo(0.5, 12);
    expect(filmDuration(made({ begins: [60, 120, 300], end: 360 }, { speed: 4 }))).toBeCloseTo(0.125, 12);
  });
});

const picture = (width: number, height: number): DomePicture => ({
  ...{ name: 'film.mp4', width, height, data: new Uint8Array(4 * width * height) },
  ...{ colorSpace: 'srgb', filter: 'linear', wrapS: 'repeat', wrapT: 'clamp' },
});
const dome = (film: DomeFilm, how: Partial<FilmedDome> = {}): FilmedDome => ({
  ...{ kind: 'dome', path: '/film', color: [1, 1, 1], film, texture: picture(16, 8), ...how },
});

/** Towards the middle of a texel, in the world: the top row is +Y of the dome, its middle column +Z, and to the left of that is +X. */
function directionOf({ orientation = IDENTITY, texture: { width, height } }: FilmedDome, texel: number): Vec3 {
  const [x, y] = [texel % width, Math.floor(texel / width)];
  const [down, left] = [(Math.PI * (y + 0.5)) / height, Math.PI * (1 - (2 * (x + 0.5)) / width)];
  const own: Vec3 = [Math.sin(down) * Math.sin(left), Math.cos(down), Math.sin(down) * Math.cos(left)];
  const m = toMatrix(orientation);
  return [0, 3, 6].map((row) => m[row]! * own[0] + m[row + 1]! * own[1] + m[row + 2]! * own[2]) as unknown as Vec3;
}

const orientations = fc
  .tuple(direction, uniform(0, 6), direction, uniform(0, 6))
  .map(([a, angle, b, other]) => multiply(fromAxisAngle(a, angle), fromAxisAngle(b, other)));
const sizes = fc.constantFrom([16, 8], [7, 5], [1, 1], [32, 3]);
const events: fc.Arbitrary<FilmEvent> = fc.record({
  t: uniform(-20, 20),
  position: fc.tuple(direction, fc.oneof(fc.constant(0), uniform(0, 0.5), uniform(0, 60))).map(([n, r]) => scale(n, r)),
  speedOfLight: fc.constantFrom(1, 10, 299792458),
});
const films = fc
  .record({ ticked: tickedFilm, start: uniform(-5, 5), speed: speeds, repeats: fc.boolean() })
  .map(({ ticked, ...how }) => ({ ticked, film: made(ticked, how) }));

/** Expects each texel once, with the frame of the film's tick that `at` tells of its direction. */
function expectFrames(filmed: FilmedDome, event: FilmEvent, at: (n: Vec3) => readonly [TickedFilm, number]): void {
  const { width, height } = filmed.texture;
  const { frames, texels, first } = framesSeen(filmed, event, { width, height });
  const shown = new Int32Array(width * height).fill(-1);
  frames.forEach((frame, i) => {
    for (const texel of texels.subarray(first[i], first[i + 1])) shown[texel] = frame;
  });
  const wrong = Array.from(shown).flatMap((frame, texel) => {
    const [ticked, tick] = at(directionOf(filmed, texel));
    // Where a frame begins, rounding decides.
    const isClear = Math.abs(tick - Math.round(tick)) > 1e-4;
    return frame < 0 || (isClear && frame !== frameByTick(ticked, tick, filmed.film.repeats)) ? [[texel, frame]] : [];
  });
  expect(wrong).toEqual([]);
  expect([texels.length, first.length, first.at(-1)]).toEqual([shown.length, frames.length + 1, shown.length]);
}

/** The frame of one texel. */
function frameOfTexel(filmed: FilmedDome, event: FilmEvent, texel: number): number {
  const { frames, texels, first } = framesSeen(filmed, event, filmed.texture);
  const place = texels.indexOf(texel);
  return frames[first.findIndex((from) => from > place) - 1]!;
}

describe('what an event sees', () => {
  it('is in each direction n the frame that was in the origin at t + n·x/c, and each texel is of one frame', () =>
    fc.assert(
      fc.property(films, events, orientations, sizes, ({ ticked, film }, event, orientation, [width, height]) => {
        const filmed = dome(film, { orientation, texture: picture(width, height) });
        expectFrames(filmed, event, (n) => {
          const time = event.t + dot(n, event.position) / event.speedOfLight;
          return [ticked, (time - film.start) * film.speed * TICKS];
        });
      }),
    ));

  it('has its frames in rising order, each once', () =>
    fc.assert(
      fc.property(films, events, orientations, ({ film }, event, orientation) => {
        const { frames, first } = framesSeen(dome(film, { orientation }), event, { width: 16, height: 8 });
        expect([...frames]).toEqual([...new Set(frames)].sort((a, b) => a - b));
        expect(frames.every((_, i) => first[i]! < first[i + 1]!)).toBe(true);
      }),
    ));

  it('is one frame everywhere where it is said to be', () => {
    let told = 0;
    fc.assert(
      fc.property(films, events, orientations, ({ film }, event, orientation) => {
        const only = onlyFrameSeen(film, event);
        if (only === undefined) return;
        told++;
        expect(framesSeen(dome(film, { orientation }), event, { width: 32, height: 16 }).frames).toEqual([only]);
      }),
      { numRuns: 2000 },
    );
    expect(told).toBeGreaterThan(400);
  });

  it('is one frame everywhere in the origin, and it is said to be', () =>
    fc.assert(
      fc.property(films, uniform(-20, 20), ({ film }, t) => {
        const event: FilmEvent = { t, position: [0, 0, 0], speedOfLight: 1 };
        if (film.track.times.length > 1) expect(onlyFrameSeen(film, event)).toBe(frameAt(film, t));
        expect(framesSeen(dome(film), event, { width: 8, height: 4 }).frames).toEqual([frameAt(film, t)]);
      }),
    ));

  it('is all of a film that repeats within the time that light takes past the origin', () => {
    const film = made(even(5, 25), { repeats: true });
    // A round takes 0.2 s, and light from one side is 0.4 s ahead of that from the other.
    const event: FilmEvent = { t: 3, position: [2, 0, 0], speedOfLight: 10 };
    expect(onlyFrameSeen(film, event)).toBeUndefined();
    expect(framesSeen(dome(film), event, { width: 64, height: 32 }).frames).toEqual([0, 1, 2, 3, 4]);
  });

  it('runs at 1 + β·n by the clocks of the world, and at the Doppler factor by the observer’s own', () =>
    fc.assert(
      fc.property(
        direction,
        uniform(-0.99, 0.99),
        fc.nat(16 * 8 - 1),
        orientations,
        (axis, speed, texel, orientation) => {
          const [c, rate] = [10, 25];
          const filmed = dome(made(even(1000, rate), { repeats: true }), { orientation });
          const beta = scale(axis, speed);
          const n = directionOf(filmed, texel);
          const frameSeen = (t: number): number =>
            frameOfTexel(filmed, { t, position: scale(beta, c * t), speedOfLight: c }, texel);
          // Of a film that is seen for 30 s of the world's time, at most 1500 frames.
          const step = 0.5 / rate;
          let [frames, before] = [0, frameSeen(0)];
          for (let i = 1; i <= 30 / step; i++) {
            const now = frameSeen(i * step);
            frames += (now - before + 1000) % 1000;
            before = now;
          }
          expect(Math.abs(frames / rate - 30 * (1 + dot(n, beta)))).toBeLessThan(1.01 / rate);
          const ownTime = 30 * Math.sqrt(1 - speed ** 2);
          const D = dopplerFactor(n, properVelocity(beta), [0, 0, 0]);
          expect(Math.abs(frames / rate - D * ownTime)).toBeLessThan(1.01 / rate);
        },
      ),
      { numRuns: 20 },
    ));
});

const withFilm = (film: DomeFilm, given: Partial<Scene> = {}): Scene =>
  makeScene({ name: 'filmed', lights: [dome(film)], ...filmTimeOf({ lights: [dome(film)] }), ...given });

describe('a scene with a film', () => {
  it('run k times as fast, at a speed of light of k c, shows what it showed', () => {
    const cases = fc.record({ offset: uniform(-9, 9), k: uniform(0.1, 9), startTime: uniform(-9, 9) });
    fc.assert(
      fc.property(films, events, cases, ({ ticked, film }, event, { offset, k, startTime }) => {
        const scene = withFilm(film, { startTime });
        const next = retime(scene, { offset, speed: k });
        const t = startTime + offset + (event.t - startTime) / k;
        const later = filmedDome(next)!;
        expect(filmDuration(later.film)).toBeCloseTo(filmDuration(film) / k, 9);
        expectFrames(later, { ...event, t, speedOfLight: k * event.speedOfLight }, (n) => {
          const time = event.t + dot(n, event.position) / event.speedOfLight;
          return [ticked, (time - film.start) * film.speed * TICKS];
        });
      }),
    );
  });

  it('has its time range, which is retimed with it', () => {
    const film = made({ begins: [60, 120, 300], end: 360 }, { start: 3, speed: 0.5 });
    const scene = withFilm(film);
    expect([scene.startTime, scene.endTime]).toEqual([3, 4]);
    const next = retime(scene, { offset: 2, speed: 4 });
    expect([next.startTime, next.endTime]).toEqual([5, 5.25]);
    expect(filmTimeOf(next)).toEqual({ startTime: 5, endTime: 5.25 });
    expect(filmTimeOf(makeScene({ name: 'none' }))).toEqual({});
  });

  it('has a dome with a film only where there is a picture of it, on its first dome', () => {
    const filmed = dome(made(even(2, 25)));
    const plain: DomeLight = { kind: 'dome', path: '/plain', color: [1, 1, 1] };
    const of = (...lights: DomeLight[]) => filmedDome({ lights });
    expect(of(filmed, plain)).toBe(filmed);
    expect(of(plain, filmed)).toBeUndefined();
    const { texture: _, ...bare } = filmed;
    expect(of(bare)).toBeUndefined();
    expect(of()).toBeUndefined();
  });

  it('gets another picture on its first dome, and can be without its film; nothing else of it changes', () => {
    const filmed = dome(made(even(2, 25)));
    const others = [
      { kind: 'distant', path: '/sun', direction: [0, -1, 0], color: [1, 1, 1] },
      filmed,
      { kind: 'dome', path: '/other', color: [1, 1, 1] },
    ] as const;
    const scene = makeScene({ name: 'three lights', lights: others });
    const next = picture(16, 8);
    expect(withDomePicture(scene, next)).toEqual({
      ...scene,
      lights: [others[0], { ...filmed, texture: next }, others[2]],
    });
    expect(filmedDome(withDomePicture(scene, next))!.texture).toBe(next);
    const { film: _, ...still } = filmed;
    const without = withoutFilm(scene);
    expect(without).toEqual({ ...scene, lights: [others[0], still, others[2]] });
    expect(filmedDome(without)).toBeUndefined();
    expect(withoutFilm(without)).toBe(without);
  });
});

describe('where an observer sees films', () => {
  it('is his event, and light takes no time in a picture of one instant of the world', () => {
    const here = { t: 3, position: [7, 0, 0] } as const;
    const seen = (view: View, lightDelay = true) =>
      filmEventOf(here, { ...DEFAULT_SETTINGS, speedOfLight: 10, view, lightDelay });
    expect(seen('light-cone')).toEqual({ ...here, speedOfLight: 10 });
    for (const instant of [seen('galilean'), seen('light-cone', false)]) {
      const film = made(even(5, 1));
      expect(onlyFrameSeen(film, instant)).toBe(3);
      expect(onlyFrameSeen(film, { ...instant, speedOfLight: 0.5 })).toBeUndefined();
    }
  });
});
