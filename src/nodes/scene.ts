import { normalize } from '../math/vec3.ts';
import type { DistantLight, DomeLight, Scene } from '../scene/types.ts';
import { defineNode } from './define.ts';

/** Composes what is observed: what was read, with light where it has none. */
export const scene = defineNode({
  id: 'scene',
  title: 'node.scene',
  help: 'node.scene.help',
  category: 'composition',
  params: {
    daylight: { kind: 'boolean', title: 'param.daylight', help: 'param.daylight.help', default: true },
  },
  inputs: { scene: { type: 'scene' } },
  outputs: { scene: { type: 'scene' } },
  evaluate({ scene: loaded }, { daylight }) {
    const lit = !daylight || loaded.scene.lights.length > 0;
    return { scene: lit ? loaded : { ...loaded, scene: withDaylight(loaded.scene) } };
  },
});

/** A high sun over the viewer's left shoulder and a pale sky. */
function withDaylight(scene: Scene): Scene {
  const sun: DistantLight = {
    kind: 'distant',
    path: '/daylight/sun',
    direction: normalize(scene.upAxis === 'Y' ? [0.45, -0.8, -0.4] : [0.45, 0.4, -0.8]),
    color: [2.6, 2.5, 2.3],
  };
  const sky: DomeLight = { kind: 'dome', path: '/daylight/sky', color: [0.38, 0.45, 0.56] };
  return { ...scene, lights: [sun, sky] };
}
