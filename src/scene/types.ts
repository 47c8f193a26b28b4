import type { Quat } from '../math/quat.ts';
import type { Vec3 } from '../math/vec3.ts';
import type { MeasuredReflectance } from '../spectrum/reflectance/measuredReflectance.ts';
import type { LightSpectrum } from '../spectrum/sources/lightSpectrum.ts';
import type { Stars } from './stars/brightStars.ts';
import type { StreamedPoints } from './streaming/storedPoints.ts';

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

/** World times between which the object exists [s]; ±Infinity where it always did or always will. */
export interface Lifetime {
  readonly birth: number;
  readonly death: number;
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

/** Position [m] and orientation: x_world = position + orientation · x_object. */
export interface Pose {
  readonly position: Vec3;
  readonly orientation: Quat;
}

/** How an object's frame, or each of its points, moves through the world. */
export type Motion = RigidMotion | SampledPointsMotion;

/** How one frame moves through the world: of a rigid object, a light, a camera. */
export type RigidMotion = StaticMotion | UniformMotion | HyperbolicMotion | SampledMotion;

export interface StaticMotion {
  readonly kind: 'static';
  readonly pose: Pose;
}
export interface UniformMotion {
  readonly kind: 'uniform';
  /** At world time 0. */
  readonly pose: Pose;
  /** [m/s], |v| < c. */
  readonly velocity: Vec3;
}
/** Constant proper acceleration along a line, momentarily at rest at `t0`; for all times, before and after. */
export interface HyperbolicMotion {
  readonly kind: 'hyperbolic';
  /** At world time `t0`. */
  readonly pose: Pose;
  /** [m/s²]. With `authoredIn: 'rest'` it is the frame origin's, and the body is Born rigid. */
  readonly properAcceleration: Vec3;
  /** [s] */
  readonly t0: number;
}
/**
 * Rigid poses at rising times. Between samples every *vertex* moves in a straight line from its place in one pose to its
 * place in the next; before the first and after the last sample it rests. Rotation is resampled so that the chord error stays small.
 */
export interface SampledMotion {
  readonly kind: 'sampled';
  /** [s], strictly rising, at least 2. */
  readonly times: Float64Array;
  /** 7 per sample: position x y z [m], orientation x y z w (unit). */
  readonly poses: Float64Array;
}
/**
 * A deforming mesh: every vertex moves between its places at rising times, in a straight line or, where velocities are given, along a cubic;
 * it rests outside them.
 */
export interface SampledPointsMotion {
  readonly kind: 'sampled-points';
  /** [s], strictly rising, at least 2. */
  readonly times: Float64Array;
  /** Where `points` are measured from [m], so that f32 holds them well. */
  readonly origin: Vec3;
  /**
   * One array per sample, 3 per vertex, world-oriented, relative to `origin` [m]; or where to find them, where they are too
   * many for memory. To be read with `pointsAt` (samplePoints.ts), which knows both.
   */
  readonly points: readonly Float32Array[] | StreamedPoints;
  /**
   * Of every vertex at each sample, world-oriented [m/s], 3 per vertex: between samples it moves along the cubic with these (Hermite), or so much of
   * it as stays slower than light (`bendFactor`). Absent where it goes straight, as all that is left in files does.
   */
  readonly velocities?: readonly Float32Array[];
  /** World-frame normals per sample, where they were given or could be computed; else from the mesh. To be read with `vertexNormalsAt`. */
  readonly normals?: readonly Float32Array[];
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
  /** Share of the light from all round that gets to each point, past what the mesh does not show: of the sky and of other surfaces, not of suns and lamps. */
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

export interface Texture {
  /** Where it came from, for messages. */
  readonly name: string;
  readonly width: number;
  readonly height: number;
  /** RGBA, rows from the top. */
  readonly data: Uint8Array;
  readonly colorSpace: 'srgb' | 'linear';
  readonly filter: 'nearest' | 'linear';
  readonly wrapS: TextureWrap;
  readonly wrapT: TextureWrap;
}
/** A picture of radiance, for what is brighter than white. */
export interface RadianceTexture extends Omit<Texture, 'data'> {
  /** RGBA as halves, linear sRGB of 0 … 65504, rows from the top. */
  readonly data: Uint16Array;
}
/** Outside the picture; `black` is transparent too. */
export type TextureWrap = 'repeat' | 'clamp' | 'mirror' | 'black';

export type Light = SpectrumLight | NightSky;

/** What shines with one colour and one spectrum. */
export type SpectrumLight = DistantLight | LocalLight | DomeLight;

/** What shines from somewhere, and may move. */
export type LocalLight = SphereLight | AreaLight;
export type AreaLight = RectLight | DiskLight | CylinderLight;

export interface DistantLight {
  readonly kind: 'distant';
  readonly path: string;
  /** Unit, the way the light travels. */
  readonly direction: Vec3;
  /** Linear sRGB times intensity and exposure: irradiance on a facing surface. */
  readonly color: Vec3;
  /** Diameter of its disc [rad], as wide as which edges of shadows are blurred; the sun's where absent. */
  readonly angle?: number;
  /** What its light is made of, in its own frame; daylight where absent. */
  readonly spectrum?: LightSpectrum;
}
interface LocalLightBase {
  readonly path: string;
  /** Of its middle; its axes are the axes of its frame. */
  readonly motion: RigidMotion;
  /** World times between which it shines [s]. */
  readonly lifetime: Lifetime;
  /** Linear sRGB in its own frame: the radiance L of its surface, the same in all directions of its front. */
  readonly color: Vec3;
  /** What its light is made of, in its own frame; daylight where absent. */
  readonly spectrum?: LightSpectrum;
  /** Absent where it shines alike to all sides. */
  readonly shaping?: LightShaping;
}
export interface SphereLight extends LocalLightBase {
  readonly kind: 'sphere';
  /** In its own frame [m]. E = πL(radius/distance)²; of a point (radius 0) `color` is the intensity I, E = I/distance². */
  readonly radius: number;
}
/** A face in the XY plane of its frame, dark behind: it shines towards −Z. */
export interface RectLight extends LocalLightBase {
  readonly kind: 'rect';
  /** Along X and Y of its own frame [m]. */
  readonly width: number;
  readonly height: number;
}
/** The same, round. */
export interface DiskLight extends LocalLightBase {
  readonly kind: 'disk';
  /** In its own frame [m]. */
  readonly radius: number;
}
/** The side of a tube along X of its frame; its caps are dark. */
export interface CylinderLight extends LocalLightBase {
  readonly kind: 'cylinder';
  /** In its own frame [m]. Of a line (radius 0) `color` is 2·radius·L: the intensity of a metre of it, seen from the side. */
  readonly radius: number;
  readonly length: number;
}
/**
 * What of its light goes out at an angle θ from −Z of its frame, 0 … 1: cos(θ)^focus, and all of it within `inner`, none
 * beyond `outer` [rad], between them 1 − smoothstep.
 */
export interface LightShaping {
  readonly inner: number;
  readonly outer: number;
  readonly focus: number;
}
export interface DomeLight {
  readonly kind: 'dome';
  readonly path: string;
  readonly color: Vec3;
  /** What its light is made of, in its own frame; daylight where absent. */
  readonly spectrum?: LightSpectrum;
  /** It is brighter or darker at the horizon and below, `color` is that of the zenith; without this and a picture all directions are alike. */
  readonly gradient?: SkyGradient;
  /** Of all directions, by latitude and longitude (latLong.ts). */
  readonly texture?: Texture | RadianceTexture;
  /** The picture's axes → world axes; the same where absent. */
  readonly orientation?: Quat;
}
/** Linear sRGB radiance at the horizon, and of the ground well below it. The zenith is where the scene's up axis points. */
export interface SkyGradient {
  readonly horizon: Vec3;
  readonly ground: Vec3;
}
/** The fixed stars before the cosmic background. They are seen; on things they shine too faintly to tell. */
export interface NightSky {
  readonly kind: 'stars';
  readonly path: string;
  readonly stars: Stars;
  /** Equatorial axes → world axes. */
  readonly orientation: Quat;
  /** Radiance for each cd/m², and irradiance for each lx. */
  readonly gain: number;
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
