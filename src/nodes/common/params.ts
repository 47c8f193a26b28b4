import {
  type BooleanParam,
  type ChoiceParam,
  NodeRefusal,
  type NumberParam,
  type TextParam,
  type VectorParam,
} from '../../graph/nodeType.ts';
import { radians } from '../../math/angle.ts';
import { fromAxisAngle, IDENTITY, multiply, type Quat } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { type LocalizedText, listed, type Message, msg } from '../../messages/message.ts';
import { matchesPath } from '../../scene/compose/mergeScenes.ts';
import { InputError, type Scene } from '../../scene/types.ts';

/** Path of the objects that a node applies to. */
export const whichParam: TextParam = {
  kind: 'text',
  title: msg`Applies to`,
  help: msg`Path of an object, with everything below it, such as /Car; empty for everything.`,
  default: '',
};

export const vectorParam = (title: LocalizedText, value: Vec3, unit?: string): VectorParam => ({
  kind: 'vector',
  title,
  default: value,
  ...(unit && { unit }),
});

/** A world time [s]. */
export const timeParam = (title: LocalizedText, value: number): NumberParam => ({
  kind: 'number',
  title,
  unit: 's',
  default: value,
  min: -1e9,
  max: 1e9,
  step: 0.001,
  slider: false,
});

/** Whether something that moves along a path turns with it. */
export const facingParam: BooleanParam = {
  kind: 'boolean',
  title: msg`Face along motion`,
  help: msg`Turns with the direction of motion; otherwise it keeps its pose.`,
  default: true,
};

/** In which frame the shape of a file is that of something that is made to move. */
export const authoredInParam = (value: 'rest' | 'world'): ChoiceParam<'rest' | 'world'> => ({
  kind: 'choice',
  title: msg`The file’s shape is that`,
  help: msg`At rest: the flight contracts it. In flight: it is already contracted. Deforming objects are always treated as in flight.`,
  default: value,
  options: [
    { value: 'rest', title: msg`At rest` },
    { value: 'world', title: msg`In flight` },
  ],
});

type Remedy = NodeRefusal['problem']['remedy'];

export const nodeRefusal = (code: string, place: LocalizedText, message: Message, remedy?: Remedy) =>
  new NodeRefusal({ severity: 'error', code, place, message, ...(remedy && { remedy }) });

/** What is read from a file that a parameter names. Throws a NodeRefusal where an InputError is thrown, with its place. */
export async function readOrRefuse<T>(read: () => Promise<T>, remedy?: Remedy): Promise<T> {
  try {
    return await read();
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    const { code, place, message } = error.diagnostic;
    throw nodeRefusal(code, place, message, remedy);
  }
}

/** Throws a NodeRefusal if the scene has no object or light, and none of `others`, at a path, instead of changing nothing silently. */
export function assertPathExists(scene: Scene, path: string, node: string, others: Scene['cameras'] = []): void {
  const paths = [...scene.objects, ...scene.lights, ...others].map((each) => each.path);
  if (path === '' || paths.some((each) => matchesPath(each, path))) return;
  const few = listed([...paths.slice(0, 8), ...(paths.length > 8 ? ['…'] : [])]);
  const message = msg`there is nothing at "${path}"; there is ${few || msg`nothing at all`}`;
  throw nodeRefusal('geometry.path', `${node}.which`, message, { node, param: 'which', value: '' });
}

/** Rotation about x, then y, then z [°], as USD's rotateXYZ. */
export const rotationXYZ = ([x, y, z]: Vec3): Quat =>
  [
    fromAxisAngle([0, 0, 1], radians(z)),
    fromAxisAngle([0, 1, 0], radians(y)),
    fromAxisAngle([1, 0, 0], radians(x)),
  ].reduce(multiply, IDENTITY);
