import {
  dot,
  floor,
  int,
  ivec2,
  length,
  mat4,
  max,
  min,
  mix,
  normalize,
  screenCoordinate,
  select,
  textureLoad,
  textureSize,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import type { Node, Texture, UniformNode, Vector4 } from 'three/webgpu';
import { PROJECTION_NEAR } from '../../scene/shaderText/program.ts';
import { unaberrate } from '../../shaders/kinematics/unaberrate.ts';
import type { Bool, Float, Int, Vec2, Vec3, Vec4 } from '../../shaders/types.ts';
import type { TargetName } from '../gbuffer/surface.ts';
import { unpackNormals, unpackRoughnessAndOcclusion, unpackSpecular } from '../gbuffer/surfacePacking.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { frustumTangents } from '../gpu/fullScreenPass.ts';
import { cameraDirection } from '../lenses/pixelDirection.ts';

/** Three's types do not know the columns of a matrix. */
interface Matrix {
  element(column: Int): Vec3;
}

/** Textures of a G-buffer, by name. */
export interface GBufferTextures {
  texture(name: TargetName): Texture;
}

/** Colour of the fog, and in w how it is chosen: 0 the effect's own, 1 the sky's, 2 this one (`FogColor`). */
export type FogUniform = UniformNode<'vec4', Vector4>;

/** Inputs of an effect. */
export interface EffectSources {
  readonly image: Texture;
  /** What `image2` of a user's text reads. */
  readonly second?: Texture;
  /** Present if the effect reads it (`EFFECTS[id].reads`). */
  readonly buffer?: GBufferTextures;
  readonly uniforms: FrameUniforms;
  readonly args: UniformNode<'vec4', Vector4>;
  readonly fog: FogUniform;
  /** World time of the observer [s]. */
  readonly time: UniformNode<'float', number>;
}

/** An image read by integer texel coordinates from the top left; mirrored beyond its edges. */
export class EffectImage {
  readonly size: Vec2;
  private readonly texture: Texture;

  constructor(texture: Texture) {
    this.texture = texture;
    this.size = vec2(sizeOf(texture));
  }

  at(pixel: Vec2): Vec4 {
    return textureLoad(this.texture, ivec2(mirrored(pixel, this.size)));
  }
}

/** The cast corrects the declared type of `textureSize`. */
const sizeOf = (texture: Texture) => textureSize(textureLoad(texture)) as unknown as Node<'ivec2'>;

/** `mirrorIndex` of reference/post/effects/effectInput.ts, in x and y: … 1 0 | 0 1 … n−1 | n−1 n−2 … */
function mirrored(pixel: Vec2, size: Vec2): Vec2 {
  const once = max(pixel, pixel.negate().sub(1));
  const twice = min(once, size.mul(2).sub(1).sub(once));
  return max(min(twice, size.sub(1)), vec2(0));
}

/** (1 − s) a + s b: exactly a at s = 0 and exactly b at s = 1, however different their magnitudes. */
export const mixExact = (a: Vec4, b: Vec4, s: Float): Vec4 => a.mul(s.oneMinus()).add(b.mul(s));

/** What an effect reads at a pixel, as `GBufferReader` of reference/post/effects/effectInput.ts. For use within a shader function. */
export class EffectContext {
  readonly image: EffectImage;
  /** The pixel of the target that is being written. */
  readonly pixel: Vec2 = floor(screenCoordinate);
  readonly uniforms: FrameUniforms;
  private readonly sources: EffectSources;
  private readonly steps: ReadonlyMap<string, Texture>;
  private readonly images = new Map<Texture, EffectImage>();

  constructor(sources: EffectSources, steps: ReadonlyMap<string, Texture>) {
    this.sources = sources;
    this.steps = steps;
    this.uniforms = sources.uniforms;
    this.image = this.imageOf(sources.image);
  }

  get args(): readonly [Float, Float, Float, Float] {
    const { x, y, z, w } = this.sources.args;
    return [x, y, z, w];
  }

  /** What distant things fade into, of the effect's own colour and that of the sky. */
  fogColor(own: Vec3, sky: Vec3): Vec3 {
    const { fog } = this.sources;
    return select(fog.w.lessThan(0.5), own, select(fog.w.lessThan(1.5), sky, fog.xyz));
  }

  get time(): Float {
    return this.sources.time;
  }

  /** The image of an earlier step. */
  stepImage(name: string): EffectImage {
    const texture = this.steps.get(name);
    if (!texture) throw new Error(`no step ${name} has gone before`);
    return this.imageOf(texture);
  }

  hasSurface(pixel: Vec2): Bool {
    return this.surface('object', pixel).x.greaterThan(0.5);
  }

  /** (1 if there is a surface, otherwise 0; apparent distance |Δx′| [m]) */
  depth(pixel: Vec2): Vec2 {
    const { x, y } = this.surface('object', pixel).toVar();
    return vec2(min(x, 1), y);
  }

  normal(pixel: Vec2): Vec3 {
    return unpackNormals(this.surface('normal', pixel)).normal;
  }

  /** Observer → event, world frame [m]. */
  event(pixel: Vec2): Vec3 {
    return this.surface('event', pixel).xyz;
  }

  /** The direction that this pixel shows: unit, world frame. */
  direction(): Vec3 {
    const { u, gamma, boosted, orientation } = this.uniforms;
    const nPrime = orientation.mul(this.cameraDirection(this.pixel)).toVar();
    return normalize(mix(nPrime, unaberrate(nPrime, u, gamma), boosted));
  }

  /** Direction of a pixel, on the camera's axes: unit. */
  private cameraDirection(pixel: Vec2): Vec3 {
    return cameraDirection(this.placeOf(pixel), this.uniforms);
  }

  /** Tangents of a pixel's angles from the forward axis, right and up; of a perspective lens. */
  tangents(pixel: Vec2): Vec2 {
    return frustumTangents(this.placeOf(pixel), this.uniforms);
  }

  /** Place of a pixel's centre in the picture, −1 … 1 to the right and up. */
  placeOf(pixel: Vec2): Vec2 {
    const ndc = pixel.add(0.5).div(this.image.size).mul(2).sub(1);
    return vec2(ndc.x, ndc.y.negate());
  }

  /** The second image; 0 if there is none. */
  secondImage(pixel: Vec2): Vec4 {
    const { second } = this.sources;
    return second ? this.imageOf(second).at(pixel) : vec4(0, 0, 0, 1);
  }

  albedo(pixel: Vec2): Vec3 {
    return this.surface('base', pixel).xyz;
  }

  roughness(pixel: Vec2): Float {
    return unpackRoughnessAndOcclusion(this.surface('base', pixel).w).roughness;
  }

  metallic(pixel: Vec2): Float {
    return unpackSpecular(this.surface('emissive', pixel).w).metallic;
  }

  /** Direction of the pixel in the picture's space, the observer's frame on world axes carried by the boost: unit. */
  apparentDirection(pixel: Vec2): Vec3 {
    return this.uniforms.orientation.mul(this.cameraDirection(pixel));
  }

  /** Observer → apparent position, observer's frame on world axes carried by the boost [m]. */
  apparentPosition(pixel: Vec2): Vec3 {
    return this.apparentDirection(pixel).mul(this.depth(pixel).y);
  }

  /** Place in the picture [px from its top left corner] of a point in the camera's space, on those axes [m]; z: its distance along the camera's axis, positive in front. */
  pixelOf(point: Vec3): Vec3 {
    const { halfTangents, frustumCenter } = this.uniforms;
    const axes = this.uniforms.orientation as unknown as Matrix;
    const [right, up, back] = [0, 1, 2].map((k) => dot(axes.element(int(k)), point));
    const ndc = vec2(right, up).div(back.negate()).sub(frustumCenter).div(halfTangents);
    return vec3(vec2(ndc.x, ndc.y.negate()).add(1).div(2).mul(this.image.size), back.negate());
  }

  /** z/w of the apparent position under `projectionMatrix`. */
  clipDepth(pixel: Vec2): Float {
    const axial = this.depth(pixel).y.div(length(vec3(this.tangents(pixel), 1)));
    return axial
      .reciprocal()
      .mul(2 * PROJECTION_NEAR)
      .oneMinus();
  }

  /** Apparent positions → camera axes. */
  viewMatrix(): Node<'mat4'> {
    const [x, y, z] = [0, 1, 2].map((row) => vec4(this.orientationRow(row), 0));
    return mat4(x, y, z, vec4(0, 0, 0, 1)) as Node<'mat4'>;
  }

  /** Camera axes → clip space of OpenGL, without a far plane. */
  projectionMatrix(): Node<'mat4'> {
    const { halfTangents: half, frustumCenter: center } = this.uniforms;
    const [x, y] = [half.x.reciprocal(), half.y.reciprocal()];
    return mat4(
      vec4(x, 0, 0, 0),
      vec4(0, y, 0, 0),
      vec4(center.x.mul(x), center.y.mul(y), -1, -1),
      vec4(0, 0, -2 * PROJECTION_NEAR, 0),
    ) as Node<'mat4'>;
  }

  /** A row of the rotation from camera to world axes: a column of its inverse. */
  private orientationRow(row: number): Vec3 {
    const columns = [0, 1, 2].map((k) => (this.uniforms.orientation as unknown as Matrix).element(int(k)));
    return vec3(...(columns.map((column) => [column.x, column.y, column.z][row]) as [Float, Float, Float]));
  }

  /** World time of the event minus that of the observer [s]. */
  emissionTime(pixel: Vec2): Float {
    return this.surface('event', pixel).w.mul(this.uniforms.secondsPerMetre);
  }

  /** (velocity of the surface, world frame, units of c; D) */
  motion(pixel: Vec2): Vec4 {
    return this.surface('motion', pixel);
  }

  object(pixel: Vec2): Float {
    return this.surface('object', pixel).x;
  }

  private surface(name: TargetName, pixel: Vec2): Vec4 {
    const { buffer } = this.sources;
    if (!buffer) throw new Error(`this effect reads the surfaces' ${name}, and was given none`);
    return this.imageOf(buffer.texture(name)).at(pixel);
  }

  private imageOf(texture: Texture): EffectImage {
    const image = this.images.get(texture) ?? new EffectImage(texture);
    this.images.set(texture, image);
    return image;
  }
}
