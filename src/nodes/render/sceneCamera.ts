import { NodeRefusal } from '../../graph/nodeType.ts';
import { radians } from '../../math/angle.ts';
import { listed, msg } from '../../messages/message.ts';
import { validate } from '../../scene/validation/validate.ts';
import { LENS_CHOICES, type LensChoice, panoramicLens, USUAL_LENS } from '../../scene/view/lenses/lensChoice.ts';
import { fisheyeParams } from '../common/fisheyeParams.ts';
import { nodeRefusal } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { pictureCamera } from '../pictures/renderSettings.ts';
import type { RelativisticScene } from '../socketValues.ts';

/** The camera that the scene is observed from. */
export const sceneCameraNode = defineNode({
  id: 'scene-camera',
  title: msg`Camera`,
  help: msg`The camera from which the scene is observed.`,
  category: 'render',
  params: {
    camera: { kind: 'text', title: msg`Camera`, default: '', choices: 'cameras' },
    ride: {
      kind: 'boolean',
      title: msg`Ride the camera`,
      help: msg`Follow the scene’s animated camera with its velocity. Any movement key detaches you.`,
      default: false,
    },
    smooth: {
      kind: 'boolean',
      title: msg`Smooth path`,
      help: msg`The ride goes through the camera’s keyframes on a curve, so that your velocity does not jump there, and with it all that you see. Off: along straight lines.`,
      default: true,
    },
    lens: {
      kind: 'choice',
      title: msg`Lens`,
      help: msg`How directions are shown. Equirectangular, cube and stereo pictures show all around; a dome master has the zenith in the middle and what is ahead at the bottom.`,
      default: USUAL_LENS.lens,
      options: Object.entries(LENS_CHOICES).map(([value, title]) => ({ value: value as LensChoice, title })),
    },
    ...fisheyeParams,
    eyeSeparation: {
      kind: 'number',
      title: msg`Distance of the eyes`,
      help: msg`In your rest frame. Far-off things look deep with eyes that are farther apart, as if the world were smaller.`,
      unit: 'm',
      default: USUAL_LENS.eyeSeparation,
      min: 0.001,
      max: 1e9,
      step: 0.001,
      slider: false,
      onlyWhen: { param: 'lens', is: 'stereo' },
    },
    fieldOfView: {
      kind: 'number',
      title: msg`Field of view`,
      help: msg`Vertical, in your rest frame.`,
      unit: '°',
      default: 60,
      min: 5,
      max: 150,
      step: 1,
      suggestion: 'fieldOfView',
      onlyWhen: { param: 'lens', is: 'perspective' },
    },
  },
  inputs: { relativity: { type: 'relativity' } },
  outputs: { view: { type: 'view' } },
  async evaluate({ relativity }, { camera, ride, smooth, fieldOfView, ...chosen }, { node }) {
    const { cameras } = relativity.scene;
    if (camera && !cameras.some(({ path }) => path === camera)) {
      const message = msg`there is no camera ${camera}; the scene has ${listed(cameras.map(({ path }) => path)) || msg`none`}`;
      const remedy = { node, param: 'camera', value: '' };
      throw new NodeRefusal({ severity: 'error', code: 'camera.missing', place: node, message, remedy });
    }
    if (ride) assertRideable(relativity, camera);
    const fovY = fieldOfView === undefined ? undefined : radians(fieldOfView);
    const panorama = panoramicLens(chosen);
    const view = { ...relativity, camera, ride, smooth, fovY, ...(panorama && { panorama }) };
    if (!smooth || !ride) return { view };
    const { smoothCourse } = await import('../../scene/view/cameraCourse.ts');
    const course = smoothCourse(pictureCamera(view).motion, relativity.speedOfLight);
    return { view: { ...view, ...(course && { course }) } };
  },
});

/** Throws if the camera that is ridden moves faster than light. */
function assertRideable({ scene, speedOfLight }: RelativisticScene, camera: string): void {
  const cameras = scene.cameras.filter(({ path }) => path === camera);
  const ridden = cameras[0] ?? scene.cameras[0]!;
  const found = validate({ ...scene, objects: [], lights: [], cameras: [ridden] }, speedOfLight);
  const fault = found.find(({ severity }) => severity === 'error');
  if (fault) throw nodeRefusal(fault.code, fault.place, fault.message);
}
