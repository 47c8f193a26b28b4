import { CYLINDER_LIGHT } from './kinds/cylinderLight.ts';
import { DISK_LIGHT } from './kinds/diskLight.ts';
import { DISTANT_LIGHT } from './kinds/distantLight.ts';
import { DOME_LIGHT } from './kinds/domeLight.ts';
import type { LightKind, LocalLightKind } from './kinds/lightKind.ts';
import { NIGHT_SKY } from './kinds/nightSky.ts';
import { RECT_LIGHT } from './kinds/rectLight.ts';
import { SPHERE_LIGHT } from './kinds/sphereLight.ts';
import type { DistantLight, DomeLight, Light, LocalLight, NightSky } from './light.ts';

type LightKindOf<L extends Light> = L extends LocalLight ? LocalLightKind<L> : LightKind<L>;

/** The kinds of light, a record each (docs/adr/0024-light-kinds.md). */
const LIGHTS: { readonly [K in Light['kind']]: LightKindOf<Extract<Light, { readonly kind: K }>> } = {
  distant: DISTANT_LIGHT,
  sphere: SPHERE_LIGHT,
  rect: RECT_LIGHT,
  disk: DISK_LIGHT,
  cylinder: CYLINDER_LIGHT,
  dome: DOME_LIGHT,
  stars: NIGHT_SKY,
};

/** The scene's record of a light's kind. */
export function lightKind<L extends LocalLight>(light: L): LocalLightKind<L>;
export function lightKind<L extends Light>(light: L): LightKind<L>;
export function lightKind(light: Light): LightKind<Light> {
  return LIGHTS[light.kind];
}

export const isLocalLight = (light: Light): light is LocalLight => lightKind(light).reach === 'local';
export const isDistantLight = (light: Light): light is DistantLight => lightKind(light).reach === 'distant';
export const isDomeLight = (light: Light): light is DomeLight => lightKind(light).reach === 'sky';
export const isNightSky = (light: Light): light is NightSky => lightKind(light).reach === 'stars';

/** The greatest intensity of a light at a large distance over its `color`: its greatest projected area [m²]; of a line its length [m], of a point 1. */
export const projectedArea = (light: LocalLight): number => lightKind(light).projectedArea(light);
