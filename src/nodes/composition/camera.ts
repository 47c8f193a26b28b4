import { radians } from '../../math/angle.ts';
import { sub } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { makeScene } from '../../scene/defaults.ts';
import { lookAtOrientation } from '../../scene/view/camera.ts';
import { vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { rootPrimPath } from '../geometry/primitives/definePrimitive.ts';
import { nameParam } from './lightParams.ts';

/** A camera at rest. */
export const cameraNode = defineNode({
  id: 'camera',
  title: msg`Camera`,
  help: msg`A camera at rest.`,
  category: 'composition',
  params: {
    name: nameParam('Camera'),
    position: vectorParam(msg`Position`, [3, 2, 6], 'm'),
    target: vectorParam(msg`Looks at`, [0, 0, 0], 'm'),
    fieldOfView: { kind: 'number', title: msg`Field of view`, unit: '°', default: 60, min: 5, max: 150, step: 1 },
  },
  inputs: {},
  outputs: { geometry: { type: 'geometry' } },
  evaluate(_inputs, { name, position, target, fieldOfView }, { node }) {
    const path = rootPrimPath(name, node);
    const orientation = lookAtOrientation(sub(target, position), [0, 1, 0]);
    const camera = {
      path,
      motion: { kind: 'static', pose: { position, orientation } },
      fovY: radians(fieldOfView),
    } as const;
    return { geometry: { scene: makeScene({ name, cameras: [camera] }) } };
  },
});
