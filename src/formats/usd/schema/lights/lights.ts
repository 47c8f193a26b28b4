import { radians } from '../../../../math/angle.ts';
import * as mat4 from '../../../../math/mat4.ts';
import { multiply } from '../../../../math/quat.ts';
import { normalize } from '../../../../math/vec3.ts';
import { EQUATORIAL } from '../../../../scene/stars/equatorial.ts';
import type { DistantLight, Light, NightSky } from '../../../../scene/types.ts';
import { relativeLuminance } from '../../../../scene/view/metering.ts';
import { report } from '../../diagnostics.ts';
import { sampleTimes, textAt } from '../../layer/attributes.ts';
import type { PrimSpec, PropertySpec } from '../../layer/layer.ts';
import type { StageContext } from '../context.ts';
import type { TextureLoader } from '../materials/textureLoader.ts';
import { poseTimeOf, type SlowlightAttributes } from '../slowlightAttributes.ts';
import type { StageTransform } from '../transforms/stageTransform.ts';
import { domeTexture, skyGradient } from './domeLights.ts';
import { emissionOf, lightNumber, spectrumOf } from './lightInputs.ts';
import { isLocalLight, localLightOf } from './localLights.ts';

const DOME_LIGHTS = new Set(['DomeLight', 'DomeLight_1']);
const UNREAD_LIGHTS = new Set(['PortalLight', 'PluginLight']);

export const isLight = (typeName: string): boolean =>
  isLocalLight(typeName) || DOME_LIGHTS.has(typeName) || typeName === 'DistantLight';
export const isUnreadLight = (typeName: string): boolean => UNREAD_LIGHTS.has(typeName);

/** A light with the brightness and, but for where a lamp is, the pose that it has at the stage's start. */
export async function lightOf(
  context: StageContext,
  textures: TextureLoader,
  prim: PrimSpec,
  frame: StageTransform,
  directions: SlowlightAttributes,
): Promise<Light> {
  reportHeldInputs(context, prim, frame, directions);
  if (isLocalLight(prim.typeName)) return localLightOf(context, textures, prim, frame, directions);
  const { path } = prim;
  if (prim.typeName === 'DistantLight') {
    const direction = normalize(mat4.transformVector(frame.matrixAt(context.startCode), [0, 0, -1]), [0, 0, -1]);
    const color = emissionOf(context, prim, DISTANT_INTENSITY);
    return { kind: 'distant', path, direction, color, ...angleOf(context, prim), ...(await spectrumOf(context, prim)) };
  }
  if (textAt(prim, 'slowlight:sky', undefined) === 'stars') return nightSkyOf(context, prim, frame);
  const dome = {
    kind: 'dome',
    path,
    color: emissionOf(context, prim),
    ...(await spectrumOf(context, prim)),
  } as const;
  return { ...dome, ...skyGradient(context, prim, dome.color), ...(await domeTexture(context, textures, prim, frame)) };
}

/** Diameter of a distant light's disc, which a file has in degrees, where it is written. */
function angleOf(context: StageContext, prim: PrimSpec): Pick<DistantLight, 'angle'> {
  const angle = lightNumber(context, prim, 'angle');
  return angle === undefined ? {} : { angle: radians(Math.min(Math.max(angle, 0), 180)) };
}

/** The bright stars as this prim's frame turns them; their colours are their own. */
async function nightSkyOf(context: StageContext, prim: PrimSpec, frame: StageTransform): Promise<NightSky> {
  // Loaded with the first scene that has stars: the page is light without them.
  const { brightStars } = await import('../../../../scene/stars/brightStars.ts');
  const { orientation } = mat4.decomposeRigid(frame.matrixAt(context.startCode)).pose;
  return {
    kind: 'stars',
    path: prim.path,
    stars: brightStars(),
    orientation: multiply(orientation, EQUATORIAL),
    gain: relativeLuminance(...emissionOf(context, prim)),
  };
}

/**
 * Where no intensity is written. UsdLux gives a distant light 50000 over its disc of 0.53°, which is an irradiance of
 * 50000 π sin²(0.265°). What is written is taken for the irradiance, whatever the angle.
 */
const DISTANT_INTENSITY = 50000 * Math.PI * Math.sin(radians(0.265)) ** 2;

function reportHeldInputs(
  context: StageContext,
  prim: PrimSpec,
  frame: StageTransform,
  directions: SlowlightAttributes,
): void {
  const moved = frame.times.length > 0 || poseTimeOf(directions) !== undefined;
  if ((moved && !isLocalLight(prim.typeName)) || [...prim.properties.values()].some(isAnimatedInput))
    report(context, 'warning', 'usd.animated-light', prim.path, 'the light changes with time; it is held at the start');
}

const isAnimatedInput = (property: PropertySpec): boolean =>
  property.kind === 'attribute' && !property.name.startsWith('xformOp:') && sampleTimes(property).length > 0;
