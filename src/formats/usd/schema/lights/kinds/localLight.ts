import * as mat4 from '../../../../../math/mat4.ts';
import { addScaled, cross, dot, length, negate, normalize, scale, type Vec3 } from '../../../../../math/vec3.ts';
import { msg } from '../../../../../messages/message.ts';
import type { LocalLight, LocalLightBase, RigidMotion } from '../../../../../scene/types.ts';
import { report } from '../../../diagnostics.ts';
import { attributeOf, textOf, valueAt } from '../../../layer/attributes.ts';
import type { PrimSpec } from '../../../layer/layer.ts';
import { isTrue, type StageContext } from '../../context.ts';
import { meanColor, type TextureLoader, textureOf } from '../../materials/textureLoader.ts';
import { rigidMotionOf } from '../../placement/resampling.ts';
import { closedFormMotion, lifetimeOf, poseTimeOf, type SlowlightAttributes } from '../../slowlightAttributes.ts';
import { type StageTransform, transformInMeters } from '../../transforms/stageTransform.ts';
import { emissionOf, lightFlag, lightNumber, shapingOf, spectrumOf } from '../lightInputs.ts';
import type { LightSchema } from './lightSchema.ts';

type ShapePart<L extends LocalLight> = Pick<L, Exclude<keyof L, keyof LocalLightBase>>;

/** What differs between kinds of local lights. */
interface ShapeSchema<L extends LocalLight> {
  readonly isOneSided: boolean;
  /** Whether its schema has a texture, whose mean colour is used. */
  readonly isTextured?: boolean;
  /** Kind and sizes [m], scaled along X, Y, Z by the prim's transform at the start; by the mean scale where the shape cannot be non-uniform. */
  shape(size: (name: string, fallback: number) => number, stretch: Vec3): ShapePart<L>;
  /** The shape to draw, and the factor from authored brightness to `color`. */
  radiance(shape: ShapePart<L>, of: RadianceInputs): { readonly shape: ShapePart<L>; readonly gain: number };
}

interface RadianceInputs {
  /** Metres per stage unit. */
  readonly unit: number;
  /** A normalized light divides its brightness by its surface area in stage units. */
  readonly isNormalized: boolean;
  /** 1, or for normalized lights the reciprocal of an area [m²] in stage units. */
  over(area: number): number;
  isFlagged(name: string): boolean;
}

/** Reads local lights, with their brightness and size at the stage's start. */
export const localLightSchema = <L extends LocalLight>(
  typeName: string,
  kind: ShapeSchema<L>,
): LightSchema<ShapePart<L> & LocalLightBase> => ({
  typeNames: [typeName],
  moves: true,
  async read({ context, textures, prim, frame, slowlight }) {
    const { shape, gain } = kind.radiance(
      kind.shape(sizeReader(context, prim), stretchOf(context, frame)),
      radianceInputs(context, prim),
    );
    const shaping = shapingOf(context, prim, kind.isOneSided);
    const tint = kind.isTextured ? await meanTextureColor(context, textures, prim) : undefined;
    const color = scale(emissionOf(context, prim), gain);
    const base: LocalLightBase = {
      path: prim.path,
      motion: localLightMotion(context, prim, frame, slowlight),
      lifetime: lifetimeOf(slowlight),
      color: tint ? [color[0] * tint[0], color[1] * tint[1], color[2] * tint[2]] : color,
      ...(await spectrumOf(context, prim)),
      ...(shaping && { shaping }),
    };
    return { ...shape, ...base };
  },
});

const sizeReader =
  (context: StageContext, prim: PrimSpec) =>
  (name: string, fallback: number): number =>
    Math.max(lightNumber(context, prim, name) ?? fallback, 0);

function stretchOf(context: StageContext, frame: StageTransform): Vec3 {
  const m = transformInMeters(frame, context.unit).matrixAt(context.startCode);
  const [x, y, z] = AXES.map((axis) => length(mat4.transformVector(m, axis)));
  return [x, y, z];
}

function radianceInputs(context: StageContext, prim: PrimSpec): RadianceInputs {
  const { unit } = context;
  const isNormalized = lightFlag(context, prim, 'normalize');
  return {
    unit,
    isNormalized,
    over: (area) => (isNormalized ? (area > 0 ? unit ** 2 / area : 0) : 1),
    isFlagged: (name) => isTrue(context, prim, name),
  };
}

const AXES: readonly Vec3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

async function meanTextureColor(
  context: StageContext,
  textures: TextureLoader,
  prim: PrimSpec,
): Promise<Vec3 | undefined> {
  const file = ['inputs:texture:file', 'texture:file']
    .map((n) => valueAt(attributeOf(prim, n), context.startCode))
    .find(textOf);
  const image = file && (await textures.file(file, prim.path));
  if (!image) return undefined;
  report(context, 'info', 'usd.light-input', prim.path, msg`its texture shines with its mean colour`);
  return meanColor(textureOf(context, prim, image, false));
}

function localLightMotion(
  context: StageContext,
  prim: PrimSpec,
  frame: StageTransform,
  slowlight: SlowlightAttributes,
): RigidMotion {
  const upright: StageTransform = { ...frame, matrixAt: (time) => orthonormalized(frame.matrixAt(time)) };
  const poseTime = poseTimeOf(slowlight);
  if (poseTime === undefined) return rigidMotionOf(context, prim.path, upright);
  const world = transformInMeters(upright, context.unit).matrixAt(poseTime * context.codesPerSecond);
  return closedFormMotion(context, prim.path, mat4.decomposeRigid(world).pose, slowlight);
}

/** The pose of a transform with scale or mirroring: X along the light's own X axis, Z normal to its face on the side of its own Z axis. */
function orthonormalized(m: mat4.Mat4): mat4.Mat4 {
  const [x, y, z] = AXES.map((axis) => mat4.transformVector(m, axis));
  const X = normalize(x, [1, 0, 0]);
  const across = normalize(cross(X, y), normalize(addScaled(z, X, -dot(z, X)), [0, 0, 1]));
  const Z = dot(across, z) < 0 ? negate(across) : across;
  const Y = cross(Z, X);
  return mat4.fromParts([X[0], Y[0], Z[0], X[1], Y[1], Z[1], X[2], Y[2], Z[2]], [m[3], m[7], m[11]]);
}
