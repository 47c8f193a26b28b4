import { NodeRefusal } from '../../graph/nodeType.ts';
import { radians } from '../../math/angle.ts';
import { defineNode } from '../defineNode.ts';

/** The camera that the scene is observed from. */
export const sceneCameraNode = defineNode({
  id: 'scene-camera',
  title: 'node.camera',
  help: 'node.camera.help',
  category: 'render',
  params: {
    camera: { kind: 'text', title: 'param.camera', default: '', choices: 'cameras' },
    ride: { kind: 'boolean', title: 'param.ride', help: 'param.ride.help', default: false },
    fieldOfView: {
      kind: 'number',
      title: 'param.fieldOfView',
      help: 'param.fieldOfView.help',
      unit: '°',
      default: 60,
      min: 5,
      max: 150,
      step: 1,
      suggestion: 'fieldOfView',
    },
  },
  inputs: { relativity: { type: 'relativity' } },
  outputs: { view: { type: 'view' } },
  evaluate({ relativity }, { camera, ride, fieldOfView }, { node }) {
    const { cameras } = relativity.scene;
    if (camera && !cameras.some(({ path }) => path === camera)) {
      const message = `there is no camera ${camera}; the scene has ${cameras.map(({ path }) => path).join(', ') || 'none'}`;
      const remedy = { node, param: 'camera', value: '' };
      throw new NodeRefusal({ severity: 'error', code: 'camera.missing', place: node, message, remedy });
    }
    const fovY = fieldOfView === undefined ? undefined : radians(fieldOfView);
    return { view: { ...relativity, camera, ride, fovY } };
  },
});
