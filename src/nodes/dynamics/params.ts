import type { NumberParam } from '../../graph/nodeType.ts';
import { msg } from '../../messages/message.ts';
import { matchesPath } from '../../scene/compose/mergeScenes.ts';
import { deforms, isStatic } from '../../scene/motion/motion.ts';
import type { Scene } from '../../scene/types.ts';
import { toLoadedScene } from '../common/loadedScene.ts';
import { assertPathExists, nodeRefusal } from '../common/params.ts';
import type { LoadedScene } from '../services.ts';

type NumberParamOptions = Pick<NumberParam, 'title' | 'default' | 'unit'> & Partial<NumberParam>;

/** A number without a bounded range for a slider. */
export const quantityParam = (about: NumberParamOptions): NumberParam => ({
  kind: 'number',
  min: 0,
  max: 1e12,
  step: 0.001,
  slider: false,
  ...about,
});

/** The same, including negative numbers. */
export const signedQuantityParam = (about: NumberParamOptions): NumberParam => quantityParam({ min: -1e12, ...about });

export const massParam = quantityParam({
  title: msg`Mass`,
  help: msg`Mass of each object.`,
  unit: 'kg',
  default: 1,
  min: 1e-9,
});
export const penaltyParam = quantityParam({
  title: msg`Contact stiffness`,
  help: msg`Stiffness of the contact force; faster impacts penetrate deeper.`,
  unit: 'N/m',
  default: 10_000,
  min: 1e-6,
  step: 1,
});
export const chargeParam = signedQuantityParam({
  title: msg`Charge`,
  help: msg`Charge of each object.`,
  unit: 'C',
  default: 0,
  step: 1e-9,
});

/** Splits off the objects at a path. They must be at rest or, if allowed, `rigid`. */
export function splitByPath(
  { scene }: LoadedScene,
  which: string,
  node: string,
  may: 'rest' | 'rigid',
): { readonly chosen: Scene; readonly rest: LoadedScene } {
  assertPathExists(scene, which, node);
  const objectsThat = (match: boolean): Scene['objects'] =>
    scene.objects.filter(({ path }) => matchesPath(path, which) === match);
  const objects = objectsThat(true);
  if (objects.length === 0) throw nodeRefusal('matter.none', node, msg`there is no object with a surface; connect one`);
  for (const { path, motion } of objects) {
    if (isStatic(motion) || (may === 'rigid' && !deforms(motion))) continue;
    const how = may === 'rigid' ? msg`changes its shape` : msg`moves`;
    const message = msg`${path} ${how} already; put this before what moves it, or choose things ${may === 'rigid' ? msg`that keep theirs` : msg`at rest`}`;
    throw nodeRefusal('matter.moving', path, message);
  }
  return {
    chosen: { ...scene, objects, lights: [], cameras: [] },
    rest: toLoadedScene({ ...scene, objects: objectsThat(false), diagnostics: [] }),
  };
}
