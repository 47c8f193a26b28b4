import { IDENTITY } from '../../src/math/quat.ts';
import { add, scale, type Vec3, ZERO } from '../../src/math/vec3.ts';
import { rayToward } from '../../src/reference/camera/lensRay.ts';
import { createTracedScene, type TracedScene } from '../../src/reference/intersection/tracedScene.ts';
import type { LightOptions } from '../../src/reference/lights/lightOptions.ts';
import { pixelSequence } from '../../src/reference/sampling/pixelSequence.ts';
import { sensorsOf } from '../../src/reference/spectral/sensors.ts';
import { radiance } from '../../src/reference/transport/path.ts';
import { FOREVER, makeMaterial, makeObject, makeScene, restingAt } from '../../src/scene/defaults.ts';
import type { AreaLight, DomeLight, Light, Material, Mesh, SceneObject, SphereLight } from '../../src/scene/types.ts';
import { perspective } from '../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type RenderSettings } from '../../src/scene/view/view.ts';

/** Spectral colours, c = 1 m/s. */
export const SPECTRAL: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: 1 };
/** Approximate colours without noise and without colour shift: a Doppler shift by D only multiplies by D⁴. c = 1 m/s. */
export const GREY: RenderSettings = { ...SPECTRAL, colors: 'approximate', dopplerMix: 0 };
export const DIRECT: LightOptions = { bounces: 0, mirrors: false, glass: false };

/** A uniform dome; dark by default. */
export const dome = (color: Vec3 = ZERO): DomeLight => ({ kind: 'dome', path: '/dome', color });

/** A texture of one column, from the top. */
export const picture = (rows: readonly (readonly [number, number, number])[]) =>
  ({
    name: 'column',
    width: 1,
    height: rows.length,
    data: Uint8Array.from(rows.flatMap((row) => [...row, 255])),
    colorSpace: 'linear',
    filter: 'linear',
    wrapS: 'clamp',
    wrapT: 'clamp',
  }) as const;

/** Purely diffuse: with ior 1 there is no specular reflection. */
export const lambert = (albedo: number, given: Partial<Material> = {}): Material =>
  makeMaterial({ name: 'lambert', baseColor: [albedo, albedo, albedo], ior: 1, ...given });

export const mirror = (given: Partial<Material> = {}): Material =>
  makeMaterial({ name: 'mirror', baseColor: [1, 1, 1], metallic: 1, roughness: 0, ...given });

export const lamp = (position: Vec3, given: Partial<SphereLight> = {}): SphereLight => ({
  kind: 'sphere',
  path: '/lamp',
  motion: restingAt(position),
  lifetime: FOREVER,
  radius: 0,
  color: [1, 1, 1],
  ...given,
});

/** An area light at rest, of radiance 1, facing −Z. */
export const area = <Kind extends AreaLight['kind']>(
  kind: Kind,
  position: Vec3,
  given: Omit<Extract<AreaLight, { kind: Kind }>, 'kind' | 'path' | 'motion' | 'lifetime' | 'color'> &
    Partial<AreaLight>,
): AreaLight =>
  ({
    kind,
    path: `/${kind}`,
    motion: restingAt(position),
    lifetime: FOREVER,
    color: [1, 1, 1],
    ...given,
  }) as AreaLight;

export const twoSided = (mesh: Mesh): Mesh => ({ ...mesh, doubleSided: true });

/** A scene with the given objects and materials, under the given lights only. */
export function lit(
  things: readonly (Partial<SceneObject> & { readonly mesh: Mesh; readonly material: Material })[],
  lights: readonly Light[] = [],
): TracedScene {
  const objects = things.map(({ material: _, mesh, ...given }, k) =>
    makeObject({
      path: `/${k}`,
      mesh: { ...mesh, groups: [{ start: 0, count: mesh.indices.length, material: k }] },
      ...given,
    }),
  );
  const materials = things.map(({ material }) => material);
  const all = lights.some(({ kind }) => kind === 'dome') ? lights : [...lights, dome()];
  return createTracedScene(makeScene({ name: 'lit', objects, materials, lights: all }), 1);
}

export interface Eye {
  readonly position: Vec3;
  /** World time [s]. */
  readonly t?: number;
  /** γβ */
  readonly u?: Vec3;
}

/** What an observer sees in a direction in the observer's frame: the mean of `samples` samples. */
export function look(
  scene: TracedScene,
  { position, t = 0, u = ZERO }: Eye,
  direction: Vec3,
  options: LightOptions = DIRECT,
  samples = 1,
  { settings = GREY, seed = 1 }: { readonly settings?: RenderSettings; readonly seed?: number } = {},
): Vec3 {
  const ray = rayToward({ t, position, u, orientation: IDENTITY, lens: perspective(1) }, settings, direction);
  const sequence = pixelSequence(seed, 0, 0);
  const createSensor = sensorsOf(settings, samples);
  let sum = ZERO;
  for (let i = 0; i < samples; i++) {
    const random = sequence(i);
    sum = add(sum, radiance(scene, ray, { u }, settings, options, random, createSensor(random)));
  }
  return scale(sum, 1 / samples);
}
