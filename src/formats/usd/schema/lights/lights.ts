import { msg } from '../../../../messages/message.ts';
import type { Light } from '../../../../scene/types.ts';
import { report } from '../../diagnostics.ts';
import { sampleTimes } from '../../layer/attributes.ts';
import type { PropertySpec } from '../../layer/layer.ts';
import { poseTimeOf } from '../slowlightAttributes.ts';
import { CYLINDER_LIGHT } from './kinds/cylinderLight.ts';
import { DISK_LIGHT } from './kinds/diskLight.ts';
import { DISTANT_LIGHT } from './kinds/distantLight.ts';
import { DOME_LIGHT } from './kinds/domeLight.ts';
import type { LightPrim, LightSchema } from './kinds/lightSchema.ts';
import { NIGHT_SKY } from './kinds/nightSky.ts';
import { RECT_LIGHT } from './kinds/rectLight.ts';
import { SPHERE_LIGHT } from './kinds/sphereLight.ts';

/** Schemas that are recognized by an attribute precede others of their type. */
const LIGHTS: { readonly [K in Light['kind']]: LightSchema<Extract<Light, { readonly kind: K }>> } = {
  sphere: SPHERE_LIGHT,
  rect: RECT_LIGHT,
  disk: DISK_LIGHT,
  cylinder: CYLINDER_LIGHT,
  distant: DISTANT_LIGHT,
  stars: NIGHT_SKY,
  dome: DOME_LIGHT,
};
const SCHEMAS: readonly LightSchema<Light>[] = Object.values(LIGHTS);
const UNREAD_LIGHTS = new Set(['PortalLight', 'PluginLight']);

export const isLight = (typeName: string): boolean => SCHEMAS.some(({ typeNames }) => typeNames.includes(typeName));
export const isUnreadLight = (typeName: string): boolean => UNREAD_LIGHTS.has(typeName);

/** Reads a light prim (`isLight`), with its brightness at the stage's start; only local lights move. */
export function lightOf(of: LightPrim): Promise<Light> {
  const schema = SCHEMAS.find(
    ({ typeNames, isAsked }) => typeNames.includes(of.prim.typeName) && (isAsked?.(of.prim) ?? true),
  )!;
  reportHeldInputs(of, schema.moves);
  return schema.read(of);
}

function reportHeldInputs({ context, prim, frame, slowlight }: LightPrim, moves: boolean): void {
  const moved = frame.times.length > 0 || poseTimeOf(slowlight) !== undefined;
  if ((moved && !moves) || [...prim.properties.values()].some(isAnimatedInput))
    report(
      context,
      'warning',
      'usd.animated-light',
      prim.path,
      msg`the light changes with time; it is held at the start`,
    );
}

const isAnimatedInput = (property: PropertySpec): boolean =>
  property.kind === 'attribute' &&
  property.name !== 'visibility' &&
  !property.name.startsWith('xformOp:') &&
  sampleTimes(property).length > 0;
