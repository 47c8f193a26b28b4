import type { Mat3 } from '../math/mat3.ts';
import type { Vec3 } from '../math/vec3.ts';
import { type LocalizedText, type Message, msg } from '../messages/message.ts';
import { MessageError } from '../messages/messageError.ts';
import type { CubicLine } from '../physics/worldLines/kinds/cubicLine.ts';
import type { MeasuredReflectance } from '../spectrum/reflectance/measuredReflectance.ts';
import type { Light } from './lights/light.ts';
import type {
  Anisotropy,
  Clearcoat,
  Iridescence,
  Sheen,
  SpecularReflection,
  Transmission,
  Volume,
} from './materials/layers.ts';
import type { NormalTexture, Texture, TextureChannel } from './materials/texture.ts';
import type { Quadric } from './mesh/quadricTypes.ts';
import type { Lifetime, Motion, RigidMotion } from './motion/motionTypes.ts';

export type * from './lights/light.ts';
export type * from './materials/layers.ts';
export type * from './materials/texture.ts';
export type * from './mesh/quadricTypes.ts';
export type * from './motion/motionTypes.ts';

/**
 * The observed objects, lights and cameras. Everything is in the world frame (the inertial frame in which the scene is authored) and in SI units: metres,
 * seconds, metres per second, radians. The axes are the file's own; only its lengths are scaled to metres.
 */
export interface Scene {
  /** For people. */
  readonly name: string;
  /** The up axis of the file; determines only the default camera's up, the grid's plane and the sky's zenith. */
  readonly upAxis: 'Y' | 'Z';
  /** As in the file, for writing it back. All lengths of a scene are metres already. */
  readonly metersPerUnit: number;
  /** As in the file, for writing it back. All times of a scene are seconds already. */
  readonly timeCodesPerSecond: number;
  /** Start of the animation [s]. */
  readonly startTime: number;
  /** End of the animation [s]. */
  readonly endTime: number;
  /** What is seen. */
  readonly objects: readonly SceneObject[];
  /** What surfaces are made of; `MeshGroup.material` counts in them. */
  readonly materials: readonly Material[];
  /** What shines. */
  readonly lights: readonly Light[];
  /** What the file looks with. */
  readonly cameras: readonly SceneCamera[];
  /** The author's suggestions for viewing; the user's choices take precedence. */
  readonly hints: SceneHints;
  /** Alternatives that the file offers; absent if there are none. */
  readonly variants?: readonly VariantSet[];
  /** Largest distance between a path in the file and its samples joined by straight lines [m]; absent if none was resampled. */
  readonly pathError?: number;
  /** What its reader could not read, or changed. */
  readonly diagnostics: readonly Diagnostic[];
}

/** Alternatives of which a file shows one at a time, and the chosen one. */
export interface VariantSet {
  /** Unique in the scene. glTF: `material`; USD: prim path and set, `/World/Car{paint}`. */
  readonly set: string;
  /** Their names. */
  readonly options: readonly string[];
  /** One of `options`, or empty if none is chosen. */
  readonly chosen: string;
}

/** The author's suggestions for viewing. */
export interface SceneHints {
  /** Speed of light [m/s]. */
  readonly speedOfLight?: number;
  /** For people. */
  readonly title?: string;
  /** What to look for, one or two sentences. */
  readonly lookFor?: string;
  /** The observer's initial velocity in units of c, if the scene suggests one. */
  readonly beta?: Vec3;
  /** Time at which the page opens the scene [s]. */
  readonly openAt?: number;
}

/** Something seen: a mesh that moves. */
export interface SceneObject {
  /** Prim path, unique: `/World/Cube`. Its index in `objects` plus one is the id in the object AOV (0 is background). */
  readonly path: string;
  /** Its shape, in its own frame; with `stretch` before that. */
  readonly mesh: Mesh;
  /**
   * Constant linear map S from the mesh's axes to those of the object's own frame, so that bodies of other sizes and proportions share a mesh: a point x of the
   * mesh is at R(t) S x + T(t). Finite, with a positive determinant. Absent: the identity. Deforming objects and round solids have none.
   */
  readonly stretch?: Mat3;
  /** How it moves. */
  readonly motion: Motion;
  /** When it exists. */
  readonly lifetime: Lifetime;
  /**
   * Path of the thing of which this is one piece, absent of a whole: a thing that exists at several times, or has several topologies one after another, is
   * several objects with lifetimes that do not overlap.
   */
  readonly pieceOf?: string;
  /**
   * `world`: at each world time the object has the shape as written. `rest`: the mesh is the shape in the object's rest frame, so in the world it is
   * contracted along its velocity.
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
  /** Linear RGB, 3 per vertex, multiplied with the base colour, or the emission of unlit materials; absent if all are white. */
  readonly colors?: Float32Array;
  /** Three vertices per triangle, counterclockwise seen from outside. */
  readonly indices: Uint32Array;
  /** Runs of `indices`, each with its material; together they cover `indices`. */
  readonly groups: readonly MeshGroup[];
  /** Whether faces are seen from both sides. */
  readonly doubleSided: boolean;
  /** The round solid that these triangles approximate, which is what is seen of it; absent where the triangles are the shape. */
  readonly quadric?: Quadric;
}

/** Triangles of one material. */
export interface MeshGroup {
  /** Its first place in `Mesh.indices`. */
  readonly start: number;
  /** How many places: three per triangle. */
  readonly count: number;
  /** Index in `Scene.materials`. */
  readonly material: number;
}

/** What a surface is made of, in its rest frame. */
export interface Material {
  /** For people. */
  readonly name: string;
  /** Linear sRGB. */
  readonly baseColor: Vec3;
  /** Multiplied with `baseColor`. */
  readonly baseColorTexture?: Texture;
  /** Linear sRGB radiance. */
  readonly emissive: Vec3;
  /** Multiplied with `emissive`. */
  readonly emissiveTexture?: Texture;
  /** 0 … 1; with a texture, the mean of that. */
  readonly roughness: number;
  /** Roughness by place. */
  readonly roughnessTexture?: TextureChannel;
  /** 0 … 1; with a texture, the mean of that. */
  readonly metallic: number;
  /** Metalness by place. */
  readonly metallicTexture?: TextureChannel;
  /** Bends the normals. */
  readonly normalTexture?: NormalTexture;
  /** 0 … 1 */
  readonly opacity: number;
  /** Fragments less opaque than this are discarded; 0: none are. */
  readonly opacityThreshold: number;
  /** Refractive index; absent: that of glass, 1.5. */
  readonly ior?: number;
  /** Strength and colour of what a dielectric reflects at its surface; absent: 1 and white. */
  readonly specular?: SpecularReflection;
  /** A clear varnish over everything else; absent: none. */
  readonly clearcoat?: Clearcoat;
  /** Grooves that widen its reflection along one direction; absent: none. */
  readonly anisotropy?: Anisotropy;
  /** Fuzz over it, under the varnish; absent: none. */
  readonly sheen?: Sheen;
  /** A thin film over it, under the varnish; absent: none. */
  readonly iridescence?: Iridescence;
  /** What passes the surface; absent: nothing but by `opacity`. */
  readonly transmission?: Transmission;
  /** The inside of a transmissive body; absent: it is a thin sheet. */
  readonly volume?: Volume;
  /** 20 over the Abbe number of its refractive index, which is `ior` at 587.6 nm in its rest frame, as of `KHR_materials_dispersion`; absent: 0. */
  readonly dispersion?: number;
  /** It emits its colour, reflects nothing (`baseColor` 0, `ior` 1), and is shown without the tone curve while it is seen unshifted. */
  readonly unlit?: true;
  /** Reflectance below 360 nm, 0 … 1; absent: that of the visible colour at its end. */
  readonly uv?: number;
  /** Reflectance above 830 nm, 0 … 1; absent: that of the visible colour at its end. */
  readonly ir?: number;
  /** Measured reflectance; `baseColor`, `uv` and `ir` are then its bands (spectrum/color/filterOfReflectance.ts). With a texture or vertex colours only these bands count. */
  readonly reflectance?: MeasuredReflectance;
  /** With it, `uv` is its mean. */
  readonly uvTexture?: TextureChannel;
  /** With it, `ir` is its mean. */
  readonly irTexture?: TextureChannel;
  /** Baked ambient occlusion: the fraction of the light of the sky and of other surfaces that reaches each point. Does not affect distant and local lights. */
  readonly occlusionTexture?: TextureChannel;
  /** Temperature of a blackbody emitter [K]; then `emissive` determines only its luminance at rest. */
  readonly emissionTemperature?: number;
}

/** A perspective camera that looks down −Z with +Y up; animated by its poses. */
export interface SceneCamera {
  /** Prim path, unique. */
  readonly path: string;
  /** The path on which an observer rides. */
  readonly motion: RigidMotion;
  /** Where one who rides on it goes instead, between the samples of its motion; absent: along straight pieces. */
  readonly course?: CameraCourse;
  /** Vertical field of view [rad]. */
  readonly fovY: number;
}

/** A smooth way through the samples of a camera (view/cameraCourse.ts): between straight pieces the velocity of one who rides on it would jump, and with it all that he sees. */
export interface CameraCourse {
  /** World frame. */
  readonly line: CubicLine;
  /** Greatest distance from the straight pieces at the same time, at eight times of every piece [m]. */
  readonly strayed: number;
  /** World times of the samples at which the velocity still jumps, since no curve there stays slower than light [s]. */
  readonly jumps: readonly number[];
}

/** Something users should know about the file: severity, code, place, and what to do. */
export interface Diagnostic {
  /** With an error, something is missing or the file is rejected; a warning tells of a simplification. */
  readonly severity: 'error' | 'warning' | 'info';
  /** Short and stable, for programs: `usd.unsupported-arc`. */
  readonly code: string;
  /** File, or file and prim path. */
  readonly place: LocalizedText;
  /** What is the matter and what to do, for people. */
  readonly message: Message;
  /** The missing file, if there is one: the user may supply it. */
  readonly missing?: MissingFile;
  /** By how much something is elsewhere, where it tells of that [m]. */
  readonly off?: number;
}

/** A file that another one names and that was not found. */
export interface MissingFile {
  /** As the file writes it. */
  readonly name: string;
  /** The searched paths, in order. */
  readonly lookedFor: readonly string[];
}

/**
 * Rejects an input: names file, place and value and says what to do. The only error type that readers throw.
 * @example
 * import { memorySource, openScene } from 'slowlight/formats';
 * const files = memorySource({ 'a.usda': new TextEncoder().encode('not USD') });
 * const error = await openScene(files, 'a.usda').catch((reason) => reason);
 * error instanceof InputError && error.diagnostic.severity; // 'error'
 */
export class InputError extends MessageError {
  /** Place, code and words, for programs and people. */
  readonly diagnostic: Diagnostic;
  constructor(diagnostic: Diagnostic, options?: ErrorOptions) {
    super(msg`${diagnostic.place}: ${diagnostic.message}`, options);
    this.name = 'InputError';
    this.diagnostic = diagnostic;
  }
}
