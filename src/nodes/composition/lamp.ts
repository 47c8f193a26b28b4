import { scale } from '../../math/vec3.ts';
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
  title: 'node.lamp',
  help: 'node.lamp.help',
  category: 'composition',
  params: {
    name: nameParam('Lamp'),
    shape: {
      kind: 'choice',
      title: 'param.lampShape',
      default: 'point',
      options: [
        { value: 'point', title: 'lamp.point' },
        { value: 'ball', title: 'lamp.ball' },
        { value: 'rect', title: 'lamp.rect' },
        { value: 'disk', title: 'lamp.disk' },
      ],
    },
    position: vectorParam('param.position', [0, 3, 0], 'm'),
    rotation: vectorParam('param.rotation', [-90, 0, 0], '°'),
    size: { ...lengthParam('param.lampSize', 1), help: 'param.lampSize.help' },
    color: lightColorParam,
    brightness: brightnessParam('param.lampBrightness', 10),
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
