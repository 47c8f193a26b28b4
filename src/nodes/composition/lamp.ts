import { scale } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { composeMotion } from '../../scene/compose/applyRigidMotion.ts';
import { motionFromPath } from '../../scene/compose/motionPaths.ts';
import { FOREVER } from '../../scene/defaults.ts';
import type { LocalLight, LocalLightBase } from '../../scene/types.ts';
import { rotationXYZ, vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { lengthParam } from '../geometry/primitives/definePrimitive.ts';
import { brightnessParam, emissionParam, lightBase, lightColorParam, nameParam } from './lightParams.ts';

/** A local light, which may move. Rectangle and disk lights emit towards −Z. */
export const lampNode = defineNode({
  id: 'lamp',
  title: msg`Lamp`,
  help: msg`A light at a position, which may move. Squares and discs emit towards their −Z.`,
  category: 'composition',
  params: {
    name: nameParam('Lamp'),
    shape: {
      kind: 'choice',
      title: msg`Shape`,
      default: 'point',
      options: [
        { value: 'point', title: msg`Point` },
        { value: 'ball', title: msg`Ball` },
        { value: 'rect', title: msg`Square` },
        { value: 'disk', title: msg`Disc` },
      ],
    },
    position: vectorParam(msg`Position`, [0, 3, 0], 'm'),
    rotation: vectorParam(msg`Rotation`, [-90, 0, 0], '°'),
    size: { ...lengthParam(msg`Size`, 1), help: msg`Width; a point has none.` },
    color: lightColorParam,
    brightness: brightnessParam(msg`Brightness`, 10),
    madeOf: emissionParam,
  },
  inputs: { spectrum: { type: 'spectrum', optional: true }, motion: { type: 'motion', optional: true } },
  outputs: { lights: { type: 'lights' } },
  evaluate({ spectrum, motion: course }, params, { node }) {
    const { name, shape, position, rotation: angles, size, color, brightness: strength, madeOf: preset } = params;
    const pose = { position, orientation: rotationXYZ(angles) };
    const motion = course
      ? composeMotion(motionFromPath(course, Math.hypot(...position) + size), pose)
      : ({ kind: 'static', pose } as const);
    const common = {
      ...lightBase(name, node, preset, spectrum),
      motion,
      lifetime: FOREVER,
      color: scale(color, strength),
    };
    return { lights: [{ ...common, ...SHAPES[shape](size) }] };
  },
});

type ShapeOf<L> = L extends LocalLight ? Omit<L, keyof LocalLightBase> : never;

/** By the options of `shape`; `size`: diameter or side [m]. */
const SHAPES = {
  point: () => ({ kind: 'sphere', radius: 0 }),
  ball: (size) => ({ kind: 'sphere', radius: size / 2 }),
  rect: (size) => ({ kind: 'rect', width: size, height: size }),
  disk: (size) => ({ kind: 'disk', radius: size / 2 }),
} as const satisfies Readonly<Record<string, (size: number) => ShapeOf<LocalLight>>>;
