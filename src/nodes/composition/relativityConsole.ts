import { NodeRefusal } from '../../graph/nodeType.ts';
import { msg } from '../../messages/message.ts';
import { SPEED_OF_LIGHT } from '../../physics/constants.ts';
import { fastestInScene } from '../../scene/motion/fastestInScene.ts';
import { approachesC } from '../../scene/motion/motion.ts';
import { validate } from '../../scene/validation/validate.ts';
import { settingParams } from '../common/settingParams.ts';
import { defineNode } from '../defineNode.ts';
import type { LoadedScene } from '../services.ts';

const MIN_SPEED_OF_LIGHT = 0.1;
/** Used where neither the user nor the file specifies c; makes a street scene relativistic. */
const DEFAULT_SPEED_OF_LIGHT = 30;

/** 299 792 458 */
const REAL_LIGHT = String(SPEED_OF_LIGHT).replace(/\B(?=(\d{3})+$)/g, ' ');

/** How light travels: the single place that sets a scene's physics. */
export const relativityConsoleNode = defineNode({
  id: 'relativity-console',
  title: msg`Relativity console`,
  help: msg`How light travels, and the speed limits.`,
  category: 'composition',
  params: {
    speedOfLight: {
      kind: 'number',
      title: msg`Speed of light`,
      help: msg`The lower it is, the stronger relativistic effects are. In nature: ${REAL_LIGHT} m/s.`,
      unit: 'm/s',
      default: DEFAULT_SPEED_OF_LIGHT,
      min: MIN_SPEED_OF_LIGHT,
      max: SPEED_OF_LIGHT,
      step: 0.1,
      scale: 'log',
      suggestion: 'speedOfLight',
    },
    maxSpeed: {
      kind: 'number',
      title: msg`Maximum speed`,
      help: msg`Your maximum speed while Shift is held. Without Shift: half of it, or 8 m/s if that is less.`,
      unit: 'c',
      default: 0.95,
      min: 0.01,
      max: 0.999999,
      step: 0.000001,
      scale: 'approach',
    },
    ...settingParams('relativity-console'),
  },
  inputs: { scene: { type: 'scene' } },
  outputs: { relativity: { type: 'relativity' } },
  evaluate({ scene: loaded }, params, { node }) {
    const speedOfLight = params.speedOfLight ?? loaded.scene.hints.speedOfLight ?? fittingSpeedOfLight(loaded);
    assertSubluminal(withFastestAt(loaded, speedOfLight), speedOfLight, node);
    assertWithinHorizon(loaded, speedOfLight);
    return { relativity: { ...params, ...loaded, speedOfLight } };
  },
});

/** The default speed of light, or a greater one that leaves the fastest point at 0.8 c. */
const fittingSpeedOfLight = ({ fastest }: LoadedScene): number =>
  Math.max(DEFAULT_SPEED_OF_LIGHT, roundUp((fastest?.speed ?? 0) / 0.8));

/** The Rindler horizon, which limits how far a Born-rigid body may extend behind its origin, also depends on c. */
function assertWithinHorizon({ scene }: LoadedScene, c: number): void {
  const objects = scene.objects.filter(({ motion, authoredIn }) => approachesC(motion) && authoredIn === 'rest');
  if (objects.length === 0) return;
  const found = validate({ ...scene, objects, cameras: [] }, c).find(({ code }) => code === 'motion.horizon');
  if (found) throw new NodeRefusal({ severity: 'error', code: found.code, place: found.place, message: found.message });
}

/**
 * Without a suggested c the fastest point was computed with another speed of light; hyperbolic motion never reaches c.
 */
function withFastestAt(loaded: LoadedScene, speedOfLight: number): LoadedScene {
  const { scene, fastest } = loaded;
  const evenly = scene.objects.some(({ path, motion }) => path === fastest?.path && approachesC(motion));
  if (!fastest || fastest.speed < speedOfLight || !evenly) return loaded;
  return { scene, fastest: fastestInScene({ ...scene, hints: { ...scene.hints, speedOfLight } }) };
}

function assertSubluminal({ fastest }: LoadedScene, c: number, node: string): void {
  if (!fastest || fastest.speed < c) return;
  const least = roundUp(fastest.speed);
  const message = msg`${(fastest.speed / c).toPrecision(3)} c at t = ${fastest.time.toFixed(2)} s; raise the speed of light to ${least} m/s or more, or slow it down`;
  const remedy = { node, param: 'speedOfLight', value: least };
  throw new NodeRefusal({ severity: 'error', code: 'motion.superluminal', place: fastest.path, message, remedy });
}

/** Rounds up to three digits, so that the result is not below the value. */
function roundUp(value: number): number {
  if (value <= 0) return 0;
  const unit = 10 ** (Math.floor(Math.log10(value)) - 2);
  return Number(((Math.floor(value / unit) + 1) * unit).toPrecision(3));
}
