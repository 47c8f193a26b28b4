import { describe, expect, it } from 'vitest';
import { panoramaProject } from '../../../tests/support/exampleGraphs.ts';
import { edited, set } from '../../../tests/support/graphKit.ts';
import { inputError } from '../../formats/diagnostics/inputError.ts';
import { Evaluator } from '../../graph/evaluation/evaluator.ts';
import { IDENTITY, rotate } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { makeObject, makeScene } from '../../scene/defaults.ts';
import { box } from '../../scene/mesh/primitives.ts';
import type { DomeLight, Scene, Texture } from '../../scene/types.ts';
import { DAYLIGHT } from '../../spectrum/sources/lightSpectrum.ts';
import { nodeLibrary } from '../library.ts';
import { evaluatedPicture } from '../pictures/renderSettings.ts';
import { type ReadRequest, workerServices } from '../services.ts';

const texture: Texture = {
  name: 'sky.png',
  width: 2,
  height: 1,
  data: new Uint8Array(8).fill(255),
  colorSpace: 'srgb',
  filter: 'linear',
  wrapS: 'repeat',
  wrapT: 'clamp',
};
const SKY: DomeLight = { kind: 'dome', path: '/sky', color: [1, 1, 1], texture, orientation: IDENTITY };
/** Of two seconds. */
const FILM: DomeLight = {
  ...SKY,
  film: {
    track: {
      file: { name: 'film.mp4', handle: new Uint8Array() },
      ...{ bytes: 0, width: 2, height: 1, times: Float64Array.of(0.5, 1.5), end: 2.5 },
    },
    ...{ layout: {}, start: 0, speed: 1, repeats: false },
  },
};
const FILES: Readonly<Record<string, Scene>> = {
  'film.mp4': makeScene({ name: 'film', objects: [], lights: [FILM], startTime: 0, endTime: 2 }),
  'long.usda': makeScene({
    name: 'long',
    objects: [makeObject({ path: '/Box', mesh: box([1, 1, 1]) })],
    startTime: 1,
    endTime: 9,
  }),
  'sky.png': makeScene({ name: 'sky', objects: [], lights: [SKY] }),
  'box.usda': makeScene({
    name: 'box',
    objects: [makeObject({ path: '/Box', mesh: box([1, 1, 1]) })],
    lights: [{ kind: 'dome', path: '/old', color: [0, 0, 1] }],
  }),
};

/** The lights of a scene of a file with a dome of its own and a panorama. */
async function lights(params: Parameters<typeof panoramaProject>[0], project = panoramaProject(params)) {
  const asked: ReadRequest['fisheye'][] = [];
  const readScene = async (source: string, { fisheye }: ReadRequest) => {
    if (source === 'sky.png') asked.push(fisheye);
    const scene = FILES[source];
    if (!scene) throw inputError('file.missing', source, msg`no such file`);
    return { scene };
  };
  const evaluation = await new Evaluator(nodeLibrary).evaluate(project, 'output', {
    ...workerServices,
    readScene,
  });
  const scene = evaluatedPicture(evaluation)?.scene;
  return { lights: scene?.lights as readonly DomeLight[] | undefined, scene, evaluation, asked };
}

const about = (v: Vec3) => v.map((x) => expect.closeTo(x, 9));

describe('the node Panorama', () => {
  it('is the sky of the scene, in place of the file’s', async () => {
    const { lights: found } = await lights({ source: 'sky.png', brightness: 2 });
    expect(found).toMatchObject([{ path: '/Panorama', color: [2, 2, 2], texture: { name: 'sky.png' } }]);
    expect(found![0].spectrum).toBeUndefined();
  });

  it('turns to the left, raises its middle, and stands on the ground of a scene whose zenith is Z', async () => {
    const ahead = async (params: Parameters<typeof panoramaProject>[0], from: Vec3 = [0, 0, -1]) =>
      rotate((await lights({ source: 'sky.png', ...params })).lights![0].orientation!, from);
    expect(await ahead({ rotation: 90 })).toEqual(about([-1, 0, 0]));
    expect(await ahead({ tilt: 90 })).toEqual(about([0, 1, 0]));
    expect(await ahead({ tilt: 90, rotation: 90 })).toEqual(about([0, 1, 0]));
    expect(await ahead({ up: 'Z' })).toEqual(about([0, 1, 0]));
    expect(await ahead({ up: 'Z' }, [0, 1, 0])).toEqual(about([0, 0, 1]));
    expect(await ahead({ up: 'Z', rotation: 90 })).toEqual(about([-1, 0, 0]));
  });

  it('tells the reader which fisheye a picture is, if asked to', async () => {
    const asked = async (params: Parameters<typeof panoramaProject>[0]) =>
      (await lights({ source: 'sky.png', ...params })).asked[0];
    expect(await asked({})).toBeUndefined();
    expect(await asked({ lens: 'fisheye', aperture: 360 })).toMatchObject({ aperture: 2 * Math.PI, elevation: 0 });
    expect(await asked({ lens: 'dome', domeTilt: 30 })).toMatchObject({
      aperture: Math.PI,
      elevation: expect.closeTo(Math.PI / 3, 12),
    });
  });

  it('its colours are a filter before a light, if asked to', async () => {
    expect((await lights({ source: 'sky.png', reading: 'filter' })).lights![0].spectrum).toBe(DAYLIGHT);
    const lamp = await lights({ source: 'sky.png', reading: 'filter', madeOf: 'tungsten' });
    expect(lamp.lights![0].spectrum).toMatchObject({ kind: 'thermal', temperature: 2856 });
  });

  it('a film starts when it is told to, holds or repeats, and is within the time of the scene', async () => {
    const still = await lights({ source: 'film.mp4' });
    expect(still.lights![0].film).toEqual(FILM.film);
    expect([still.scene!.startTime, still.scene!.endTime]).toEqual([0, 2]);
    const later = await lights({ source: 'film.mp4', filmStart: 5, filmEnd: 'repeat' });
    expect(later.lights![0].film).toEqual({ ...FILM.film, start: 5, repeats: true });
    // One that repeats has no end.
    expect([later.scene!.startTime, later.scene!.endTime]).toEqual([0, 0]);
    const held = await lights({ source: 'film.mp4', filmStart: 5 });
    expect([held.scene!.startTime, held.scene!.endTime]).toEqual([5, 7]);
    expect((await lights({ source: 'sky.png', filmStart: 5, filmEnd: 'repeat' })).lights![0].film).toBeUndefined();
  });

  it('a film makes the time of a scene longer, not shorter', async () => {
    const range = async (filmStart: number) => {
      const params = { source: 'film.mp4', filmStart };
      const project = edited(panoramaProject(params), set('read', 'source', 'long.usda'));
      const { scene } = await lights(params, project);
      return [scene!.startTime, scene!.endTime];
    };
    expect(await range(3)).toEqual([1, 9]);
    expect(await range(-4)).toEqual([-4, 9]);
    expect(await range(20)).toEqual([1, 22]);
  });

  it.each([
    ['no file', {}, 'panorama.none'],
    ['a file that is not there', { source: 'none.png' }, 'file.missing'],
  ])('is refused with %s', async (_, params, code) => {
    const { evaluation } = await lights(params);
    expect(evaluation.results.get('panorama')).toMatchObject({ problem: { code } });
  });
});
