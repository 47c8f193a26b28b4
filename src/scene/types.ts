import type { Vec3 } from '../math/vec3.ts';
import type { MeasuredReflectance } from '../spectrum/reflectance/measuredReflectance.ts';
import type { Light } from './lights/light.ts';
import type { Texture } from './materials/texture.ts';
import type { Lifetime, Motion, SampledMotion, StaticMotion } from './motion/motionTypes.ts';

export type * from './lights/light.ts';
export type * from './materials/texture.ts';
export type * from './motion/motionTypes.ts';

/**
 * What is observed. Everything is in the world frame (the inertial frame the scene is authored in), in SI:
 * metres, seconds, metres per second, radians. The axes are the file's own; only its lengths are scaled to metres.
 */
export interface Scene {
  readonly name: string;
  /** The axis of the file that points up; it only chooses the default camera's up, the grid's plane and the sky's zenith. */
  readonly upAxis: 'Y' | 'Z';
  /** As the file had it, for writing it back. All lengths here are metres already. */
  readonly metersPerUnit: number;
  readonly timeCodesPerSecond: number;
  /** Range of the animation [s]. */
  readonly startTime: number;
  readonly endTime: number;
  readonly objects: readonly SceneObject[];
  readonly materials: readonly Material[];
  readonly lights: readonly Light[];
  readonly cameras: readonly SceneCamera[];
  /** What the author suggests for viewing; a user's choice comes before it. */
  readonly hints: SceneHints;
  /** What the file offers to choose between; absent where it offers nothing. */
  readonly variants?: readonly VariantSet[];
  /** Greatest distance between a path as the file means it and as it is drawn, straight between samples [m]; absent where none was resampled. */
  readonly pathError?: number;
  readonly diagnostics: readonly Diagnostic[];
}

/** Things that a file shows one at a time, with the one that is shown. */
export interface VariantSet {
  /** Unique in the scene. glTF: `material`; USD: prim path and set, `/World/Car{paint}`. */
  readonly set: string;
  readonly options: readonly string[];
  /** One of `options`, or empty where none is chosen. */
  readonly chosen: string;
}

export interface SceneHints {
  /** Speed of light [m/s]. */
  readonly speedOfLight?: number;
  readonly title?: string;
  /** What to look for, one or two sentences. */
  readonly lookFor?: string;
  /** The observer's velocity in units of c, where the scene wants one from the start. */
  readonly beta?: Vec3;
  /** Time the page opens at [s]. */
  readonly openAt?: number;
}

export interface SceneObject {
  /** Prim path, unique: `/World/Cube`. Its place in `objects` plus one is the id in the object AOV (0 is background). */
  readonly path: string;
  readonly mesh: Mesh;
  readonly motion: Motion;
  readonly lifetime: Lifetime;
  /**
   * `world`: at each world time the object has the shape as written. `rest`: the mesh is the shape in the object's own
   * rest frame, so that in the world it is contracted along its velocity.
   */
  readonly authoredIn: 'world' | 'rest';
}

/** Triangles in the object's own frame. Vertices are split where normals or uvs differ. */
export interface Mesh {
  /** [m], 3 per vertex. For `sampled-points` the rest shape (the first sample). */
  readonly positions: Float32Array;
  /** Unit, 3 per vertex. */
  readonly normals: Float32Array;
  /** 2 per vertex, v up (v = 0 is the image's bottom row). */
  readonly uvs: Float32Array;
  /** Linear RGB, 3 per vertex, multiplied with the base colour; absent where all is white. */
  readonly colors?: Float32Array;
  readonly indices: Uint32Array;
  /** Runs of `indices`, each with its material; together they cover `indices`. */
  readonly groups: readonly MeshGroup[];
  readonly doubleSided: boolean;
}

export interface MeshGroup {
  readonly start: number;
  readonly count: number;
  /** Place in `Scene.materials`. */
  readonly material: number;
}

export interface Material {
  readonly name: string;
  /** Linear sRGB. */
  readonly baseColor: Vec3;
  readonly baseColorTexture?: Texture;
  /** Linear sRGB radiance. */
  readonly emissive: Vec3;
  readonly emissiveTexture?: Texture;
  /** 0 … 1; where a texture tells, its mean. */
  readonly roughness: number;
  readonly roughnessTexture?: TextureChannel;
  /** 0 … 1; where a texture tells, its mean. */
  readonly metallic: number;
  readonly metallicTexture?: TextureChannel;
  readonly normalTexture?: NormalTexture;
  /** 0 … 1 */
  readonly opacity: number;
  /** Fragments less opaque than this are cut out; 0: none is. */
  readonly opacityThreshold: number;
  /** Refractive index, where the file gives it; without one a surface reflects as glass of 1.5 does. */
  readonly ior?: number;
  /** Share that it reflects of light below 360 nm and beyond 830 nm, 0 … 1; where absent, what the visible colour ends at. */
  readonly uv?: number;
  readonly ir?: number;
  /** As it was measured; `baseColor`, `uv` and `ir` are then its bands (spectrum/color/filterOfReflectance.ts). Where a picture or colours of vertices paint it, these alone count. */
  readonly reflectance?: MeasuredReflectance;
  /** Where a texture tells, `uv` and `ir` are their means. */
  readonly uvTexture?: TextureChannel;
  readonly irTexture?: TextureChannel;
  /** Share of the light from all round that gets to each point, past what the mesh does not show: of the sky and of other surfaces, not of distant and local lights. */
  readonly occlusionTexture?: TextureChannel;
  /** [K]: it shines as a blackbody does, and `emissive` tells its luminance at rest alone. */
  readonly emissionTemperature?: number;
}

/** A number for each texel: `scale` times one channel in linear light, plus `bias`, held within 0 … 1. */
export interface TextureChannel {
  readonly texture: Texture;
  readonly channel: 0 | 1 | 2 | 3;
  readonly scale: number;
  readonly bias: number;
}

/**
 * Normals in the frame that a surface's uvs give it: x the way u rises, y the way v rises, both across the surface's own normal, and z along it.
 * A texel (r, g, b) means (strength_x (2r − 1), strength_y (2g − 1), 2b − 1), of any length.
 */
export interface NormalTexture {
  /** Linear. */
  readonly texture: Texture;
  readonly strength: readonly [x: number, y: number];
}

/** A perspective camera that looks down −Z with +Y up; animated by its poses. */
export interface SceneCamera {
  readonly path: string;
  /** Static, or `sampled`. */
  readonly motion: StaticMotion | SampledMotion;
  /** Vertical field of view [rad]. */
  readonly fovY: number;
}

/** Something a person should know about the file: named by place, with what to do. */
export interface Diagnostic {
  readonly severity: 'error' | 'warning' | 'info';
  /** Short and stable, for programs: `usd.unsupported-arc`. */
  readonly code: string;
  /** File, or file and prim path. */
  readonly place: string;
  readonly message: string;
  /** The file that was asked for, where one is not there: who has it can supply it. */
  readonly missing?: MissingFile;
}

export interface MissingFile {
  /** As the file writes it. */
  readonly name: string;
  /** Paths, in the order of the search. */
  readonly lookedFor: readonly string[];
}

/** A clear refusal of an input: names file, place and value and says what to do. The only error type readers throw. */
export class InputError extends Error {
  readonly diagnostic: Diagnostic;
  constructor(diagnostic: Diagnostic) {
    super(`${diagnostic.place}: ${diagnostic.message}`);
    this.name = 'InputError';
    this.diagnostic = diagnostic;
  }
}
