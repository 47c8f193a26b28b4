import * as mat4 from '../../math/mat4.ts';
import { normalize, scale, type Vec3 } from '../../math/vec3.ts';
import type { FrameMotion, Light } from '../../scene/types.ts';
import { attributeOf, numberAt, sampleTimes, textOf, valueAt, vec3At } from './attributes.ts';
import { isTrue, report, type StageContext } from './context.ts';
import { type Frame, scaledFrame } from './frame.ts';
import type { PrimSpec, PropertySpec } from './layer.ts';
import { frameMotion } from './placement.ts';
import { type Directions, directedMotion, lifetimeOf, poseTimeOf } from './slowlight.ts';
import { type TextureLoader, textureOf } from './textures.ts';

const LIGHTS = new Set(['DistantLight', 'SphereLight', 'DomeLight', 'DomeLight_1']);
const OTHER_LIGHTS = new Set([
  'RectLight',
  'DiskLight',
  'CylinderLight',
  'GeometryLight',
  'PortalLight',
  'PluginLight',
]);

export const isLight = (typeName: string): boolean => LIGHTS.has(typeName);
export const isUnreadLight = (typeName: string): boolean => OTHER_LIGHTS.has(typeName);

/** A light with the brightness and, but for a sphere's place, the pose that it has at the stage's start. */
export async function lightOf(
  context: StageContext,
  textures: TextureLoader,
  prim: PrimSpec,
  frame: Frame,
  directions: Directions,
): Promise<Light> {
  noteWhatIsNotRead(context, prim, frame, directions);
  const matrix = scaledFrame(frame, context.unit).matrixAt(context.startCode);
  const { path } = prim;
  const color = colorOf(context, prim);
  if (prim.typeName === 'DistantLight') {
    const direction = normalize(mat4.transformVector(matrix, [0, 0, -1]), [0, 0, -1]);
    return { kind: 'distant', path, direction, color };
  }
  if (prim.typeName === 'SphereLight') {
    const size = Math.hypot(...mat4.transformVector(matrix, normalize([1, 1, 1])));
    const radius = isTrue(context, prim, 'treatAsPoint') ? 0 : (input(context, prim, 'radius') ?? 0.5) * size;
    const motion = sphereMotion(context, prim, frame, directions);
    return { kind: 'sphere', path, motion, lifetime: lifetimeOf(directions), radius, color };
  }
  const file = valueAt(attributeOf(prim, 'inputs:texture:file'), context.startCode);
  const name = textOf(file);
  const image = name ? await textures.file(file, path) : undefined;
  if (!image) return { kind: 'dome', path, color };
  return { kind: 'dome', path, color, texture: { ...textureOf(context, prim, image, false), name: name! } };
}

function sphereMotion(context: StageContext, prim: PrimSpec, frame: Frame, directions: Directions): FrameMotion {
  const poseTime = poseTimeOf(directions);
  if (poseTime === undefined) return frameMotion(context, prim.path, frame);
  const world = scaledFrame(frame, context.unit).matrixAt(poseTime * context.codesPerSecond);
  return directedMotion(context, prim.path, mat4.decomposeRigid(world).pose, directions);
}

/** `inputs:name`, or `name` as files before USD 21 wrote it. */
const input = (context: StageContext, prim: PrimSpec, name: string): number | undefined =>
  numberAt(prim, `inputs:${name}`, context.startCode) ?? numberAt(prim, name, context.startCode);

/**
 * Where no intensity is written. UsdLux gives a distant light 50000 over its disc of 0.53°, which is an irradiance of
 * 50000 π sin²(0.265°).
 */
const FALLBACK = { distant: 50000 * Math.PI * Math.sin((0.265 * Math.PI) / 180) ** 2, other: 1 };

/** color · intensity · 2^exposure */
function colorOf(context: StageContext, prim: PrimSpec): Vec3 {
  const color = vec3At(prim, 'inputs:color', context.startCode) ??
    vec3At(prim, 'color', context.startCode) ?? [1, 1, 1];
  const fallback = prim.typeName === 'DistantLight' ? FALLBACK.distant : FALLBACK.other;
  return scale(color, (input(context, prim, 'intensity') ?? fallback) * 2 ** (input(context, prim, 'exposure') ?? 0));
}

function noteWhatIsNotRead(context: StageContext, prim: PrimSpec, frame: Frame, directions: Directions): void {
  const sphere = prim.typeName === 'SphereLight';
  const moved = frame.times.length > 0 || poseTimeOf(directions) !== undefined;
  if ((moved && !sphere) || [...prim.properties.values()].some(isAnimatedInput))
    report(context, 'warning', 'usd.animated-light', prim.path, 'the light changes with time; it is held at the start');
  const warm =
    isTrue(context, prim, 'inputs:enableColorTemperature') || isTrue(context, prim, 'enableColorTemperature');
  if (warm)
    report(context, 'info', 'usd.light-input', prim.path, 'its colour temperature is not applied, only its colour');
  const shaped = attributeOf(prim, 'inputs:shaping:cone:angle');
  if (shaped && sphere)
    report(context, 'info', 'usd.light-input', prim.path, 'the shaping of the light is not applied');
}

const isAnimatedInput = (property: PropertySpec): boolean =>
  property.kind === 'attribute' && !property.name.startsWith('xformOp:') && sampleTimes(property).length > 0;
