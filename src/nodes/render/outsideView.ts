import { radians } from '../../math/angle.ts';
import { msg } from '../../messages/message.ts';
import { upVector } from '../../scene/lights/sceneLights.ts';
import { orbitCamera } from '../../scene/view/outsideCamera.ts';
import { vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';

/** Looks at a view from outside, with the observer in it. */
export const outsideViewNode = defineNode({
  id: 'outside-view',
  title: msg`Outside view`,
  help: msg`Looks at the world from outside, from beside the observer or from a fixed place: as it is now, or where all that he sees was when its light left. It follows the observer live. The effect “Observer and light rings” draws him.`,
  category: 'render',
  params: {
    shows: {
      kind: 'choice',
      title: msg`Shows`,
      help: msg`The world now: where everything is at this moment of the world’s clocks. What is seen: each point where it was when the light left that the observer sees now.`,
      default: 'now',
      options: [
        { value: 'now', title: msg`The world now` },
        { value: 'seen', title: msg`What is seen` },
      ],
    },
    distance: {
      kind: 'number',
      title: msg`Distance`,
      unit: 'm',
      default: 30,
      min: 1e-3,
      max: 1e12,
      step: 0.1,
      scale: 'log',
    },
    azimuth: {
      kind: 'number',
      title: msg`Azimuth`,
      help: msg`0: behind one who looks ahead. Positive: to the right of him.`,
      unit: '°',
      default: 30,
      min: -180,
      max: 180,
      step: 1,
    },
    elevation: { kind: 'number', title: msg`Elevation`, unit: '°', default: 35, min: -90, max: 90, step: 1 },
    fieldOfView: { kind: 'number', title: msg`Field of view`, unit: '°', default: 45, min: 5, max: 150, step: 1 },
    follows: {
      kind: 'boolean',
      title: msg`Follows the observer`,
      help: msg`Off: it stays where it is, and looks at a place of the world.`,
      default: true,
    },
    target: { ...vectorParam(msg`Looks at`, [0, 0, 0], 'm'), onlyWhen: { param: 'follows', is: false } },
  },
  inputs: { view: { type: 'view' } },
  outputs: { view: { type: 'view' } },
  evaluate({ view }, { shows, distance, azimuth, elevation, fieldOfView, follows, target }) {
    const orbit = {
      distance,
      azimuth: radians(azimuth),
      elevation: radians(elevation),
      fovY: radians(fieldOfView),
    };
    const outside = orbitCamera(orbit, upVector(view.scene.upAxis), follows ? undefined : target);
    const seen = { view: 'light-cone', lightDelay: true, aberration: false } as const;
    return { view: { ...view, ...(shows === 'seen' ? seen : { view: 'galilean' as const }), outside } };
  },
});
