import { lightKind } from '../../scene/lights/lightKinds.ts';
import type { LocalLight, SphereLight } from '../../scene/types.ts';
import { CYLINDER_LIGHT } from './kinds/cylinderLight.ts';
import { DISK_LIGHT } from './kinds/diskLight.ts';
import type { LightShader } from './kinds/lightShader.ts';
import { POINT_LIGHT } from './kinds/pointLight.ts';
import { RECT_LIGHT } from './kinds/rectLight.ts';
import { SPHERE_LIGHT } from './kinds/sphereLight.ts';
import type { LocalLightShape } from './lightTexels.ts';

type LightOf<K> = K extends 'point' ? SphereLight : Extract<LocalLight, { readonly kind: K }>;

/** How the rasterizer shades each shape of local light; the other kinds are in environment.ts. */
const LIGHTS: { readonly [K in LocalLightShape]: LightShader<LightOf<K>> } = {
  point: POINT_LIGHT,
  sphere: SPHERE_LIGHT,
  rect: RECT_LIGHT,
  disk: DISK_LIGHT,
  cylinder: CYLINDER_LIGHT,
};

/** The shape that shaders use for a light. */
export const lightShapeOf = (light: LocalLight): LocalLightShape =>
  lightKind(light).isPoint(light) ? 'point' : light.kind;

export const lightShader = (shape: LocalLightShape): LightShader<LocalLight> => LIGHTS[shape];
