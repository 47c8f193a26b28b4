import { msg } from '../../messages/message.ts';
import { mergeScenes } from '../../scene/compose/mergeScenes.ts';
import { makeScene } from '../../scene/defaults.ts';
import { filmTimeOf } from '../../scene/film/seenFilm.ts';
import { isDomeLight } from '../../scene/lights/lightKinds.ts';
import type { Light, Scene } from '../../scene/types.ts';
import { framingCamera } from '../../scene/view/camera.ts';
import { toLoadedScene } from '../common/loadedScene.ts';
import { defineNode } from '../defineNode.ts';
import type { TimeRange } from '../socketValues.ts';

/**
 * Composes what is observed: objects, lights, time range and observer; adds a camera with everything in view if there
 * is none.
 */
export const sceneNode = defineNode({
  id: 'scene',
  title: msg`Scene`,
  help: msg`Composes what is observed. A sky or panorama that is connected replaces those of files.`,
  category: 'composition',
  params: {},
  inputs: {
    geometry: { type: 'geometry', many: true },
    lights: { type: 'lights', many: true, optional: true },
    observer: { type: 'observer', optional: true },
    time: { type: 'time', optional: true },
  },
  outputs: { scene: { type: 'scene' } },
  evaluate({ geometry, lights, observer, time }) {
    const [only] = geometry;
    const plain = geometry.length === 1 && lights.length === 0 && !time;
    const hasSky = lights.flat().some(isDomeLight);
    const parts = geometry.map(({ scene }) => (hasSky ? withoutDomes(scene) : scene));
    const merged = mergeScenes([...parts, ...lights.map(lightScene)]);
    const timed = withTimeRange(merged, time);
    const hinted = observer ? { ...timed, hints: { ...timed.hints, beta: observer } } : timed;
    const viewed = hinted.cameras.length > 0 ? hinted : { ...hinted, cameras: [framingCamera(hinted)] };
    return { scene: plain ? { ...only!, scene: viewed } : toLoadedScene(viewed) };
  },
});

const lightScene = (lights: readonly Light[]): Scene =>
  makeScene({ name: 'lights', lights, ...filmTimeOf({ lights }) });

/** A sky that is connected is seen in place of those of files. */
const withoutDomes = (scene: Scene): Scene => ({
  ...scene,
  lights: scene.lights.filter((light) => !isDomeLight(light)),
});

function withTimeRange(scene: Scene, time: TimeRange | undefined): Scene {
  if (!time) return scene;
  const { start, end, openAt } = time;
  return { ...scene, startTime: start, endTime: end, hints: { ...scene.hints, openAt } };
}
