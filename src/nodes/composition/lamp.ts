import { scale } from '../../math/vec3.ts';
import { carriedBy } from '../../scene/compose/moved.ts';
import { motionOf } from '../../scene/compose/paths.ts';
import { FOREVER } from '../../scene/defaults.ts';
import type { Lamp } from '../../scene/types.ts';
import { defineNode } from '../define.ts';
import { metres } from '../geometry/primitive.ts';
import { rotation, vector } from '../geometry/shared.ts';
import { brightness, lightColor, lightOf, madeOf, nameParam } from './shine.ts';

/** A lamp somewhere, which may move. A rectangle or disc shines towards its −Z. */
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
    position: vector('param.position', [0, 3, 0], 'm'),
    rotation: vector('param.rotation', [-90, 0, 0], '°'),
    size: { ...metres('param.lampSize', 1), help: 'param.lampSize.help' },
    color: lightColor,
    brightness: brightness('param.lampBrightness', 10),
    madeOf,
  },
  inputs: { spectrum: { type: 'spectrum', optional: true }, motion: { type: 'motion', optional: true } },
  outputs: { lights: { type: 'lights' } },
  evaluate({ spectrum, motion: course }, params, { node }) {
    const { name, shape, position, rotation: angles, size, color, brightness: strength, madeOf: preset } = params;
    const pose = { position, orientation: rotation(angles) };
    const motion = course
      ? carriedBy(motionOf(course, Math.hypot(...position) + size), pose)
      : ({ kind: 'static', pose } as const);
    const common = {
      ...lightOf(name, node, preset, spectrum),
      motion,
      lifetime: FOREVER,
      color: scale(color, strength),
    };
    return { lights: [{ ...common, ...shapeOf(shape, size) }] };
  },
});

type Shape =
  | { readonly kind: 'rect'; readonly width: number; readonly height: number }
  | { readonly kind: 'sphere' | 'disk'; readonly radius: number };

function shapeOf(shape: string, size: number): Shape & Pick<Lamp, 'kind'> {
  switch (shape) {
    case 'rect':
      return { kind: 'rect', width: size, height: size };
    case 'disk':
      return { kind: 'disk', radius: size / 2 };
    default:
      return { kind: 'sphere', radius: shape === 'ball' ? size / 2 : 0 };
  }
}
