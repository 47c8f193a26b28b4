import * as mat4 from '../../../../math/mat4.ts';
import { addScaled, cross, dot, length, negate, normalize, scale, type Vec3 } from '../../../../math/vec3.ts';
import type { LocalLight, RigidMotion } from '../../../../scene/types.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, textOf, valueAt } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import { isTrue, type StageContext } from '../context.ts';
import { meanColor, type TextureLoader, textureOf } from '../materials/textureLoader.ts';
import { rigidMotionOf } from '../placement/resampling.ts';
import { closedFormMotion, lifetimeOf, poseTimeOf, type SlowlightAttributes } from '../slowlightAttributes.ts';
import { type StageTransform, transformInMeters } from '../transforms/stageTransform.ts';
import { emissionOf, lightFlag, lightNumber, shapingOf, spectrumOf } from './lightInputs.ts';

const LOCAL_LIGHTS = new Set(['SphereLight', 'RectLight', 'DiskLight', 'CylinderLight']);

export const isLocalLight = (typeName: string): boolean => LOCAL_LIGHTS.has(typeName);

/** A light that is somewhere, with the brightness and the size that it has at the stage's start. */
export async function localLightOf(
  context: StageContext,
  textures: TextureLoader,
  prim: PrimSpec,
  frame: StageTransform,
  directions: SlowlightAttributes,
): Promise<LocalLight> {
  const { shape, gain } = withRadianceScale(context, prim, localLightShape(context, prim, frame));
  const shaping = shapingOf(context, prim, shape.kind === 'rect' || shape.kind === 'disk');
  const tint = prim.typeName === 'RectLight' ? await meanTextureColor(context, textures, prim) : undefined;
  const color = scale(emissionOf(context, prim), gain);
  return {
    ...shape,
    path: prim.path,
    motion: localLightMotion(context, prim, frame, directions),
    lifetime: lifetimeOf(directions),
    color: tint ? [color[0] * tint[0], color[1] * tint[1], color[2] * tint[2]] : color,
    ...(await spectrumOf(context, prim)),
    ...(shaping && { shaping }),
  };
}

type ShapePart<L> = L extends LocalLight
  ? Omit<L, 'path' | 'motion' | 'lifetime' | 'color' | 'spectrum' | 'shaping'>
  : never;
type LocalLightShape = ShapePart<LocalLight>;

/** Kind and sizes [m], stretched as the prim's transform at the start says; a stretch that a shape cannot have by its mean. */
function localLightShape(context: StageContext, prim: PrimSpec, frame: StageTransform): LocalLightShape {
  const m = transformInMeters(frame, context.unit).matrixAt(context.startCode);
  const [sx, sy, sz] = AXES.map((axis) => length(mat4.transformVector(m, axis)));
  const size = (name: string, fallback: number): number => Math.max(lightNumber(context, prim, name) ?? fallback, 0);
  switch (prim.typeName) {
    case 'RectLight':
      return { kind: 'rect', width: size('width', 1) * sx, height: size('height', 1) * sy };
    case 'DiskLight':
      return { kind: 'disk', radius: size('radius', 0.5) * Math.sqrt(sx * sy) };
    case 'CylinderLight':
      return { kind: 'cylinder', radius: size('radius', 0.5) * Math.sqrt(sy * sz), length: size('length', 1) * sx };
    default:
      return { kind: 'sphere', radius: size('radius', 0.5) * Math.cbrt(sx * sy * sz) };
  }
}

const AXES: readonly Vec3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/**
 * What brightness is multiplied with to be the colour of the shape: a normalized light divides it by its surface in stage units. A sphere or tube that
 * may be taken for a point or a line is; it stays as strong from afar.
 */
function withRadianceScale(
  context: StageContext,
  prim: PrimSpec,
  shape: LocalLightShape,
): { shape: LocalLightShape; gain: number } {
  const { unit } = context;
  const normalized = lightFlag(context, prim, 'normalize');
  const over = (area: number): number => (normalized ? (area > 0 ? unit ** 2 / area : 0) : 1);
  switch (shape.kind) {
    case 'rect':
      return { shape, gain: over(shape.width * shape.height) };
    case 'disk':
      return { shape, gain: over(Math.PI * shape.radius ** 2) };
    case 'sphere': {
      const { radius } = shape;
      if (radius > 0 && !isTrue(context, prim, 'treatAsPoint')) return { shape, gain: over(4 * Math.PI * radius ** 2) };
      const gain = normalized ? unit ** 2 / 4 : radius > 0 ? Math.PI * radius ** 2 : 1;
      return { shape: { ...shape, radius: 0 }, gain };
    }
    case 'cylinder': {
      const { radius, length } = shape;
      if (radius > 0 && !isTrue(context, prim, 'treatAsLine'))
        return { shape, gain: over(2 * Math.PI * radius * length) };
      const gain = normalized ? over(Math.PI * length) : radius > 0 ? 2 * radius : 1;
      return { shape: { ...shape, radius: 0 }, gain };
    }
  }
}

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
  report(context, 'info', 'usd.light-input', prim.path, 'its texture shines with its mean colour');
  return meanColor(textureOf(context, prim, image, false));
}

function localLightMotion(
  context: StageContext,
  prim: PrimSpec,
  frame: StageTransform,
  directions: SlowlightAttributes,
): RigidMotion {
  const upright: StageTransform = { ...frame, matrixAt: (time) => orthonormalized(frame.matrixAt(time)) };
  const poseTime = poseTimeOf(directions);
  if (poseTime === undefined) return rigidMotionOf(context, prim.path, upright);
  const world = transformInMeters(upright, context.unit).matrixAt(poseTime * context.codesPerSecond);
  return closedFormMotion(context, prim.path, mat4.decomposeRigid(world).pose, directions);
}

/** The transform without stretch and mirroring: X along the lamp's own, Z across its face on the side that its own is. */
function orthonormalized(m: mat4.Mat4): mat4.Mat4 {
  const [x, y, z] = AXES.map((axis) => mat4.transformVector(m, axis));
  const X = normalize(x, [1, 0, 0]);
  const across = normalize(cross(X, y), normalize(addScaled(z, X, -dot(z, X)), [0, 0, 1]));
  const Z = dot(across, z) < 0 ? negate(across) : across;
  const Y = cross(Z, X);
  return mat4.fromParts([X[0], Y[0], Z[0], X[1], Y[1], Z[1], X[2], Y[2], Z[2]], [m[3], m[7], m[11]]);
}
