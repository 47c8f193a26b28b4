import { radians } from '../../math/angle.ts';
import { sub } from '../../math/vec3.ts';
import { lookAtOrientation } from '../../scene/camera.ts';
import { makeScene } from '../../scene/defaults.ts';
import { defineNode } from '../define.ts';
import { pathOf } from '../geometry/primitive.ts';
import { vector } from '../geometry/shared.ts';
import { nameParam } from './shine.ts';

/** A place to look from, at rest. */
export const cameraNode = defineNode({
  id: 'camera',
  title: 'node.cameraAt',
  help: 'node.cameraAt.help',
  category: 'composition',
  params: {
    name: nameParam('Camera'),
    position: vector('param.position', [3, 2, 6], 'm'),
    target: vector('param.target', [0, 0, 0], 'm'),
    fieldOfView: { kind: 'number', title: 'param.fieldOfView', unit: '°', default: 60, min: 5, max: 150, step: 1 },
  },
  inputs: {},
  outputs: { geometry: { type: 'geometry' } },
  evaluate(_inputs, { name, position, target, fieldOfView }, { node }) {
    const path = pathOf(name, node);
    const orientation = lookAtOrientation(sub(target, position), [0, 1, 0]);
    const camera = {
      path,
      motion: { kind: 'static', pose: { position, orientation } },
      fovY: radians(fieldOfView),
    } as const;
    return { geometry: { scene: makeScene({ name, cameras: [camera] }) } };
  },
});
