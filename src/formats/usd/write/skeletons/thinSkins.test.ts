import { expect, it } from 'vitest';
import { blendedArm } from '../../../../../tests/support/blendedArm.ts';
import { distance } from '../../../../math/vec3.ts';
import { makeObject } from '../../../../scene/defaults.ts';
import { pointSamples, vertexPosition } from '../../../../scene/motion/motion.ts';
import { thinSkins } from './thinSkins.ts';

it('skins that are too large as points are written at fewer times, each of them right', () => {
  const times = Float64Array.from({ length: 41 }, (_, k) => 0.1 * k);
  const { mesh, motion } = blendedArm(times);
  const object = makeObject({ path: '/Arm', mesh, motion });
  const objects = [object, { ...object, path: '/Other' }, { ...object, path: '/WithJoints' }];
  const keepsJoints = ({ path }: { readonly path: string }): boolean => path === '/WithJoints';
  const all = 2 * 24 * 41 * (mesh.positions.length / 3);
  expect(thinSkins(objects, keepsJoints, all)).toEqual({ objects });
  const { objects: fewer, lost } = thinSkins(objects, keepsJoints, all / 3);
  expect(lost).toBeDefined();
  expect(fewer[2]).toBe(objects[2]);
  for (const thin of fewer.slice(0, 2)) {
    const kept = pointSamples(thin.motion)!.times;
    expect([kept.length, kept[0], kept.at(-1)]).toEqual([13, 0, 4]);
    for (const t of kept)
      expect(distance(vertexPosition(thin, 9, t, 100), vertexPosition(object, 9, t, 100))).toBeLessThan(1e-9);
  }
});
