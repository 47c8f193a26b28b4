import { invert } from '../../../../math/mat4.ts';
import type { Message } from '../../../../messages/message.ts';
import { bakedObject } from '../../../../scene/mesh/stretch.ts';
import type { Scene, SceneObject } from '../../../../scene/types.ts';
import { skeletonsOf, type WrittenSkeleton } from '../../../write/skeletons.ts';
import { carriedMotion } from './carriedMesh.ts';
import { thinSkins } from './thinSkins.ts';

/** The objects of a scene as USD has them. */
export interface UsdObjects {
  readonly objects: readonly SceneObject[];
  /** Those of them that follow joints. */
  readonly skeletons: readonly WrittenSkeleton[];
  /** What the points of skins lose that become points. */
  readonly lost?: Message;
}

const KNOWN = new WeakMap<Scene, UsdObjects>();

/** Which objects of a scene keep their joints, found once for all that is written and told of it; the others, if they follow any, have as many samples as their points may be written at. */
export function usdObjects(scene: Scene): UsdObjects {
  const known = KNOWN.get(scene);
  if (known) return known;
  const objects = scene.objects.map(writtenObject);
  const { skeletons } = skeletonsOf(objects.filter(isWhole), isUsdSkeleton);
  const kept = new Set(skeletons.flatMap(({ skins }) => skins.map(({ object }) => object)));
  const made = { skeletons, ...thinSkins(objects, (object) => kept.has(object) || isCarried(object)) };
  KNOWN.set(scene, made);
  return made;
}

/** Pieces that take turns are one mesh there, with one transform. */
const writtenObject = (object: SceneObject): SceneObject =>
  object.pieceOf === undefined ? object : bakedObject(object);

/** Pieces that take turns are one prim, whose points change. */
const isWhole = (object: SceneObject): boolean => object.pieceOf === undefined && !isCarried(object);

const isCarried = (object: SceneObject): boolean => carriedMotion(object) !== undefined;

/** UsdSkel has bind matrices, not their inverses. */
const isUsdSkeleton = ({ skins }: WrittenSkeleton): boolean =>
  skins.every(({ binds }) => binds.every((bind) => !bind || invert(bind) !== undefined));
