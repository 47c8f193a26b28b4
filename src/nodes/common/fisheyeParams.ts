import { msg } from '../../messages/message.ts';
import { USUAL_LENS } from '../../scene/view/lenses/lensChoice.ts';

/** Beside a param `lens`: the angle across the circle of fisheyes and domes, and the tilt of domes [°]. */
export const fisheyeParams = {
  aperture: {
    kind: 'number',
    title: msg`Angle of view`,
    help: msg`The angle across the circle.`,
    unit: '°',
    default: USUAL_LENS.aperture,
    min: 10,
    max: 360,
    step: 1,
    onlyWhen: { param: 'lens', is: ['fisheye', 'dome'] },
  },
  domeTilt: {
    kind: 'number',
    title: msg`Dome tilt`,
    help: msg`By how much the dome is tilted towards the front.`,
    unit: '°',
    default: USUAL_LENS.domeTilt,
    min: -90,
    max: 90,
    step: 1,
    onlyWhen: { param: 'lens', is: 'dome' },
  },
} as const;
