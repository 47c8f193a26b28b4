import { radians } from '../../math/angle.ts';
import * as mat4 from '../../math/mat4.ts';
import { multiply } from '../../math/quat.ts';
import { normalize } from '../../math/vec3.ts';
import { luminanceOf } from '../../scene/gauge.ts';
import { EQUATORIAL } from '../../scene/stars/equatorial.ts';
import type { DistantLight, Light, NightSky } from '../../scene/types.ts';
import { sampleTimes, textAt } from './attributes.ts';
import { report, type StageContext } from './context.ts';
import { domePicture, skyGradient } from './domes.ts';
import type { Frame } from './frame.ts';
import { isLamp, lampOf } from './lamps.ts';
import type { PrimSpec, PropertySpec } from './layer.ts';
import { brightnessOf, lightNumber, spectrumOf } from './lightInputs.ts';
import { type Directions, poseTimeOf } from './slowlight.ts';
import type { TextureLoader } from './textures.ts';

const SKIES = new Set(['DomeLight', 'DomeLight_1']);
const UNREAD = new Set(['PortalLight', 'PluginLight']);

export const isLight = (typeName: string): boolean =>
  isLamp(typeName) || SKIES.has(typeName) || typeName === 'DistantLight';
export const isUnreadLight = (typeName: string): boolean => UNREAD.has(typeName);

/** A light with the brightness and, but for where a lamp is, the pose that it has at the stage's start. */
export async function lightOf(
  context: StageContext,
  textures: TextureLoader,
  prim: PrimSpec,
  frame: Frame,
  directions: Directions,
): Promise<Light> {
  noteWhatIsHeld(context, prim, frame, directions);
  if (isLamp(prim.typeName)) return lampOf(context, textures, prim, frame, directions);
  const { path } = prim;
  if (prim.typeName === 'DistantLight') {
    const direction = normalize(mat4.transformVector(frame.matrixAt(context.startCode), [0, 0, -1]), [0, 0, -1]);
    const color = brightnessOf(context, prim, DISTANT_INTENSITY);
    return { kind: 'distant', path, direction, color, ...angleOf(context, prim), ...(await spectrumOf(context, prim)) };
  }
  if (textAt(prim, 'slowlight:sky', undefined) === 'stars') return nightSkyOf(context, prim, frame);
  const dome = {
    kind: 'dome',
    path,
    color: brightnessOf(context, prim),
    ...(await spectrumOf(context, prim)),
  } as const;
  return { ...dome, ...skyGradient(context, prim, dome.color), ...(await domePicture(context, textures, prim, frame)) };
}

/** Diameter of a distant light's disc, which a file has in degrees, where it is written. */
function angleOf(context: StageContext, prim: PrimSpec): Pick<DistantLight, 'angle'> {
  const angle = lightNumber(context, prim, 'angle');
  return angle === undefined ? {} : { angle: radians(Math.min(Math.max(angle, 0), 180)) };
}

/** The bright stars as this prim's frame turns them; their colours are their own. */
async function nightSkyOf(context: StageContext, prim: PrimSpec, frame: Frame): Promise<NightSky> {
  // Loaded with the first scene that has stars: the page is light without them.
  const { brightStars } = await import('../../scene/stars/brightStars.ts');
  const { orientation } = mat4.decomposeRigid(frame.matrixAt(context.startCode)).pose;
  return {
    kind: 'stars',
    path: prim.path,
    stars: brightStars(),
    orientation: multiply(orientation, EQUATORIAL),
    gain: luminanceOf(...brightnessOf(context, prim)),
  };
}

/**
 * Where no intensity is written. UsdLux gives a distant light 50000 over its disc of 0.53°, which is an irradiance of
 * 50000 π sin²(0.265°). What is written is taken for the irradiance, whatever the angle.
 */
const DISTANT_INTENSITY = 50000 * Math.PI * Math.sin(radians(0.265)) ** 2;

function noteWhatIsHeld(context: StageContext, prim: PrimSpec, frame: Frame, directions: Directions): void {
  const moved = frame.times.length > 0 || poseTimeOf(directions) !== undefined;
  if ((moved && !isLamp(prim.typeName)) || [...prim.properties.values()].some(isAnimatedInput))
    report(context, 'warning', 'usd.animated-light', prim.path, 'the light changes with time; it is held at the start');
}

const isAnimatedInput = (property: PropertySpec): boolean =>
  property.kind === 'attribute' && !property.name.startsWith('xformOp:') && sampleTimes(property).length > 0;
