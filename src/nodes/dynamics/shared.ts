import type { NumberParam } from '../../graph/nodeType.ts';
import { isChosen } from '../../scene/compose/merge.ts';
import type { Scene } from '../../scene/types.ts';
import { checkPath, refusal } from '../geometry/shared.ts';
import { surveyed } from '../geometry/surveyed.ts';
import type { LoadedScene } from '../services.ts';

type About = Pick<NumberParam, 'title' | 'default' | 'unit'> & Partial<NumberParam>;

/** A number without a range that a slider could go through. */
export const amount = (about: About): NumberParam => ({
  kind: 'number',
  min: 0,
  max: 1e12,
  step: 0.001,
  slider: false,
  ...about,
});

/** The same, and less than nothing too. */
export const signed = (about: About): NumberParam => amount({ min: -1e12, ...about });

export const massParam = amount({
  title: 'param.mass',
  help: 'param.mass.help',
  unit: 'kg',
  default: 1,
  min: 1e-9,
});
export const penaltyParam = amount({
  title: 'param.penalty',
  help: 'param.penalty.help',
  unit: 'N/m',
  default: 10_000,
  min: 1e-6,
  step: 1,
});
export const chargeParam = signed({
  title: 'param.charge',
  help: 'param.charge.help',
  unit: 'C',
  default: 0,
  step: 1e-9,
});

/** The things at a path, which have to be at rest, and all else. */
export function parted(
  { scene }: LoadedScene,
  which: string,
  node: string,
): { readonly chosen: Scene; readonly rest: LoadedScene } {
  checkPath(scene, which, node);
  const own = (wanted: boolean): Scene['objects'] =>
    scene.objects.filter(({ path }) => isChosen(path, which) === wanted);
  const objects = own(true);
  if (objects.length === 0)
    throw refusal('matter.none', node, 'there is no thing with a surface; connect one that has');
  const moving = objects.find(({ motion }) => motion.kind !== 'static');
  if (moving) {
    const message = `${moving.path} moves already; put this before what moves it, or choose things at rest`;
    throw refusal('matter.moving', moving.path, message);
  }
  return {
    chosen: { ...scene, objects, lights: [], cameras: [] },
    rest: surveyed({ ...scene, objects: own(false), diagnostics: [] }),
  };
}
