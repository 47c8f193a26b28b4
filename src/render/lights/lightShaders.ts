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

/** How the rasterizer draws each shape of local light. */
const LIGHTS: { readonly [K in LocalLightShape]: LightShader<LightOf<K>> } = {
  point: POINT_LIGHT,
  sphere: SPHERE_LIGHT,
  rect: RECT_LIGHT,
  disk: DISK_LIGHT,
  cylinder: CYLINDER_LIGHT,
};

/** What shaders take a light for. */
export const lightShapeOf = (light: LocalLight): LocalLightShape =>
  lightKind(light).isPoint(light) ? 'point' : light.kind;

export const lightShader = (shape: LocalLightShape): LightShader<LocalLight> => LIGHTS[shape];
