import { type NodeProblem, NodeRefusal } from '../../graph/nodeType.ts';
import { length, normalize, scale } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { fly, isAtOrBelow, tooLargeToFly } from '../../scene/motion/fly.ts';
import { fastestVertex } from '../../scene/motion/motion.ts';
import type { Scene } from '../../scene/types.ts';
import { authoredInParam, timeParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import type { FastestScenePoint } from '../services.ts';
import type { RelativisticScene } from '../socketValues.ts';

/** Makes an object fly along a straight line, replacing its motion. */
export const flyNode = defineNode({
  id: 'fly',
  title: msg`Flight`,
  help: msg`Makes an object, with everything below it, fly along a straight line. Rigid objects keep their pose and lose their own motion; deforming objects keep deforming, and its velocity is added to theirs in the world frame.`,
  category: 'geometry',
  params: {
    object: {
      kind: 'text',
      title: msg`What flies`,
      help: msg`An object, or a group with its whole content.`,
      default: '',
    },
    speed: {
      kind: 'number',
      title: msg`Speed`,
      help: msg`In units of the speed of light.`,
      unit: 'c',
      default: 0.8,
      min: 0,
      max: 0.999999,
      step: 0.000001,
      scale: 'approach',
    },
    direction: {
      kind: 'vector',
      title: msg`Direction`,
      help: msg`In the axes of the scene; its length does not matter.`,
      default: [1, 0, 0],
    },
    at: {
      ...timeParam(msg`Passes its position at`, 0),
      help: msg`World time at which it is where it would be without the flight.`,
    },
    authoredIn: authoredInParam('rest'),
  },
  inputs: { relativity: { type: 'relativity' } },
  outputs: { relativity: { type: 'relativity' } },
  evaluate({ relativity }, { object: path, speed, direction, at, authoredIn }, { node }) {
    if (path === '') return { relativity };
    const { scene, speedOfLight: c } = relativity;
    assertCanFly(scene, path, direction, node);
    const flown = fly(
      scene,
      { path, beta: scale(normalize(direction), speed), at, authoredIn: authoredIn as 'rest' },
      c,
    );
    const fast = fastestAfter(relativity, flown, path);
    if (fast && fast.speed >= c) throw refusal(superluminalProblem(fast, relativity, path, node));
    return { relativity: { ...relativity, scene: flown, fastest: fast } };
  },
});

const refusal = (problem: Omit<NodeProblem, 'severity'>) => new NodeRefusal({ severity: 'error', ...problem });

function assertCanFly(scene: Scene, path: string, direction: readonly [number, number, number], node: string): void {
  const [large] = tooLargeToFly(scene, path);
  if (!scene.objects.some((object) => isAtOrBelow(object.path, path))) {
    throw refusal({
      code: 'fly.missing',
      place: path,
      message: msg`the scene has no such object; choose another`,
    });
  }
  if (length(direction) === 0) {
    const remedy = { node, param: 'direction', value: [1, 0, 0] };
    throw refusal({
      code: 'fly.direction',
      place: path,
      message: msg`the direction 0, 0, 0 is not a direction`,
      remedy,
    });
  }
  if (large !== undefined) {
    const message = msg`it deforms, and has too many samples to be carried along; let the file move it`;
    throw refusal({ code: 'fly.too-large', place: large, message });
  }
}

/**
 * The faster of the flying objects and the rest; the fastest point of the rest is known unless it was one of those that
 * now fly.
 */
function fastestAfter({ fastest: before, scene, speedOfLight: c }: RelativisticScene, flown: Scene, path: string) {
  const unchanged = before && !isAtOrBelow(before.path, path) ? before : undefined;
  const changed = new Set(scene.objects);
  let best: FastestScenePoint | undefined = unchanged;
  for (const object of flown.objects) {
    const isCandidate = isAtOrBelow(object.path, path) || (before && !unchanged && changed.has(object));
    if (!isCandidate) continue;
    const { speed, from } = fastestVertex(object, c, [flown.startTime, flown.endTime], best?.speed);
    if (speed > (best?.speed ?? 0))
      best = { path: object.path, speed, time: Number.isFinite(from) ? from : flown.startTime };
  }
  return best;
}

function superluminalProblem(
  { path: place, speed, time }: FastestScenePoint,
  { scene, speedOfLight: c }: RelativisticScene,
  path: string,
  node: string,
): Omit<NodeProblem, 'severity'> {
  const during = [scene.startTime, scene.endTime] as const;
  const own = scene.objects.reduce(
    (best, object) =>
      isAtOrBelow(object.path, path) ? Math.max(best, fastestVertex(object, c, during, best).speed) : best,
    0,
  );
  // Velocities add in the world frame, so this suffices in every direction.
  const value = Math.max(0, Math.floor(990 * (1 - own / c)) / 1000);
  const message = msg`with its own motion the flight makes it ${(speed / c).toPrecision(3)} c at t = ${time.toFixed(2)} s; fly slower, or raise the speed of light`;
  return { code: 'motion.superluminal', place, message, remedy: { node, param: 'speed', value } };
}
