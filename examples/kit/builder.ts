import { fromParts, type Mat4, multiply } from '../../src/math/mat4.ts';
import { fromAxisAngle, IDENTITY, type Quat, toMatrix } from '../../src/math/quat.ts';
import { add, scale, type Vec3, ZERO } from '../../src/math/vec3.ts';
import { mergeMeshes, transformMesh, withMaterial } from '../../src/scene/mesh/meshOps.ts';
import type {
  DistantLight,
  DomeLight,
  Light,
  Material,
  Mesh,
  Motion,
  Scene,
  SceneCamera,
  SceneHints,
  SceneObject,
  StaticMotion,
  Texture,
} from '../../src/scene/types.ts';
import { colorOfSpectrum } from '../../src/spectrum/color/observerColor.ts';
import { MATERIAL_PRESETS, type MaterialPreset } from '../../src/spectrum/reflectance/materialPresets.ts';
import type { LightSpectrum } from '../../src/spectrum/sources/lightSpectrum.ts';
import { linear } from './paint.ts';
import { aroundBase, roundMesh, roundMotion } from './tidy.ts';

/** Placement of a part: rotation about the vertical axis [rad], then translation [m]. */
export const place = (position: Vec3, turn = 0): Mat4 => fromParts(toMatrix(fromAxisAngle([0, 1, 0], turn)), position);

/** A part in several materials: meshes with their material indices. */
export type Part = readonly Mesh[];

export const placePart = (part: Part, m: Mat4): Part => part.map((mesh) => transformMesh(mesh, m));
export const compose = (...m: readonly Mat4[]): Mat4 => m.reduce((a, b) => multiply(a, b));

export interface MaterialLook {
  readonly roughness?: number;
  readonly metallic?: number;
  readonly emissive?: string;
  readonly texture?: Texture;
  readonly opacity?: number;
  /** Preset of src/spectrum/reflectance/materialPresets.ts whose ultraviolet and infrared reflectance it has. */
  readonly like?: string;
  /** Temperature of its blackbody emission [K]; `emissive` is the brightness. */
  readonly emissionTemperature?: number;
}

function presetNamed(name: string): MaterialPreset {
  const preset = MATERIAL_PRESETS.get(name);
  if (!preset) throw new Error(`no surface ${name}; there are ${[...MATERIAL_PRESETS.keys()].join(', ')}`);
  return preset;
}

export const at = (position: Vec3, orientation: Quat = IDENTITY): StaticMotion => ({
  kind: 'static',
  pose: { position, orientation },
});

/** Collects a scene's materials and objects. */
export class SceneBuilder {
  private readonly materials: Material[] = [];
  private readonly objects: SceneObject[] = [];

  /** Adds a material and returns its index. With a texture the colour is a tint. */
  material(name: string, color: string, look: MaterialLook = {}): number {
    const { roughness = 0.8, metallic = 0, emissive, texture, opacity = 1, like, emissionTemperature } = look;
    const { uv, ir } = like ? presetNamed(like).filter : {};
    this.materials.push({
      name,
      baseColor: linear(color),
      ...(texture ? { baseColorTexture: texture } : {}),
      emissive: emissive ? linear(emissive) : [0, 0, 0],
      roughness,
      metallic,
      opacity,
      opacityThreshold: 0,
      ...(uv !== undefined && { uv }),
      ...(ir !== undefined && { ir }),
      ...(emissionTemperature !== undefined && { emissionTemperature }),
    });
    return this.materials.length - 1;
  }

  /** Adds a preset of src/spectrum/reflectance/materialPresets.ts. */
  preset(name: string): number {
    const { filter, metallic, roughness } = presetNamed(name);
    const finish = { roughness, metallic: metallic ? 1 : 0, opacity: 1, opacityThreshold: 0 };
    const { rgb: baseColor, uv, ir } = filter;
    this.materials.push({ name, baseColor, emissive: [0, 0, 0], ...finish, uv, ir });
    return this.materials.length - 1;
  }

  /** Adds one object with all the parts; groups of one material are merged. Without a motion it rests where they are. */
  object(
    path: string,
    parts: Part,
    motion?: Motion,
    options: Partial<Pick<SceneObject, 'lifetime' | 'authoredIn'>> = {},
  ): void {
    const sorted = [...parts].sort((a, b) => (a.groups[0]?.material ?? 0) - (b.groups[0]?.material ?? 0));
    const lifetime = { birth: -Infinity, death: Infinity };
    const merged = sorted.length === 1 ? sorted[0] : mergeMeshes(sorted);
    const { mesh, base } = motion ? { mesh: merged, base: ZERO } : aroundBase(merged);
    this.objects.push({
      path,
      mesh: roundMesh(mesh),
      motion: motion ? roundMotion(motion) : at(base),
      lifetime,
      authoredIn: 'world',
      ...options,
    });
  }

  /** Adds the last object once more, with the same mesh, elsewhere; it must be at rest. */
  copy(path: string, by: Vec3): void {
    const last = this.objects[this.objects.length - 1];
    if (last.motion.kind !== 'static') throw new Error(`${path}: ${last.path} is not at rest`);
    const { position, orientation } = last.motion.pose;
    this.objects.push({ ...last, path, motion: at(add(position, by), orientation) });
  }

  finish(
    name: string,
    hints: SceneHints,
    range: readonly [number, number],
    cameras: readonly SceneCamera[],
    lights: readonly Light[],
  ): Scene {
    return {
      name,
      upAxis: 'Y',
      metersPerUnit: 1,
      timeCodesPerSecond: 24,
      startTime: range[0],
      endTime: range[1],
      objects: this.objects,
      materials: this.materials,
      lights: lights.map((light) => ('motion' in light ? { ...light, motion: roundMotion(light.motion) } : light)),
      cameras,
      hints,
      diagnostics: [],
    };
  }
}

export const paint = (mesh: Mesh, material: number): Mesh => withMaterial(mesh, material);

/** A sky with a zenith, horizon and ground colour. */
export const sky = (zenith: string, horizon: string, ground: string): DomeLight => ({
  kind: 'dome',
  path: '/World/Sky',
  color: linear(zenith),
  gradient: { horizon: linear(horizon), ground: linear(ground) },
});

/** A sun. `from`: direction towards it. */
export function sun(from: Vec3, color: string, intensity: number): DistantLight {
  const l = Math.hypot(...from);
  return {
    kind: 'distant',
    path: '/World/Sun',
    direction: [-from[0] / l, -from[1] / l, -from[2] / l],
    color: scale(linear(color), intensity),
  };
}

/** A late-morning sun and the sky's own light. `from`: direction towards the sun. */
export const daylight = (from: Vec3, color = '#fff1d8', intensity = 3.2): Light[] => [
  sun(from, color, intensity),
  sky('#9fc0ea', '#dfe9ee', '#8f8d86'),
];

/** Colour of light with a spectrum, as bright as white daylight of this value. */
export const spectralLight = (
  spectrum: LightSpectrum,
  luminance: number,
): { color: Vec3; spectrum: LightSpectrum } => ({
  color: scale(colorOfSpectrum(spectrum), luminance),
  spectrum,
});
