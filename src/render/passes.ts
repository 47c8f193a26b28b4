import { Discard, Fn, float, length, min, select, vec4 } from 'three/tsl';
import { NoBlending, NodeMaterial, NormalBlending, type Texture } from 'three/webgpu';
import type { Float, Vec3, Vec4 } from '../shaders/types.ts';
import { logarithmicDepth } from './depth.ts';
import { type Drawable, sideOf } from './drawable.ts';
import type { Environment } from './environment.ts';
import { pixelDirection, texelHere } from './fullScreen.ts';
import type { Optics } from './radiance.ts';
import { type ShadedSurface, shade } from './shade.ts';
import type { Shadowing } from './shadows/receiver.ts';
import { background } from './sky.ts';
import { readSurface, surfaceOutputs, type TargetName } from './surface.ts';
import { roughnessAndOcclusion, unpackEmission, unpackFinish, unpackNormals } from './surfaceCode.ts';
import type { GBuffer } from './targets.ts';
import type { Uniforms } from './uniforms.ts';
import { type Projection, vertexStage, vShown } from './vertexStage.ts';

/** Largest finite half float: what may be kept where the light target has no more. */
export const MOST_LIGHT = 65_000;

/** `reversed`: whether the depth buffer is. */
export function geometryMaterial(
  drawable: Drawable,
  projection: Projection,
  names: readonly TargetName[],
  reversed: boolean,
): NodeMaterial {
  const material = new NodeMaterial();
  material.name = `${drawable.batch.kind} ${projection.event} ${projection.place}`;
  material.vertexNode = vertexStage(drawable.vertex, projection);
  material.fragmentNode = surfaceOutputs(drawable.surface, names);
  if (!reversed) material.depthNode = logarithmicDepth(vShown);
  material.side = sideOf(drawable.batch);
  material.blending = NoBlending;
  return material;
}

const kept = (light: Vec3): Vec4 => vec4(min(light, MOST_LIGHT), 1);

/** The sky, for pixels in which nothing is. */
export const skyLight = (environment: Environment, uniforms: Uniforms, optics: Optics): Vec4 =>
  Fn(() => kept(background(environment, uniforms, optics, pixelDirection(uniforms))))();

/** The G-buffer shaded, for pixels in which something is. `moving`: not all of it rests; `openness`: of each to the sky, where that is to count. */
export const surfaceLight = (
  buffer: GBuffer,
  environment: Environment,
  uniforms: Uniforms,
  optics: Optics,
  moving: boolean,
  shadows: Shadowing | undefined,
  openness: Texture | undefined,
): Vec4 => Fn(() => kept(shade(surfaceHere(buffer, moving, openness), environment, uniforms, optics, shadows)))();

function surfaceHere(buffer: GBuffer, moving: boolean, openness: Texture | undefined): ShadedSurface {
  const [base, emissive, normal, event, motion] = (['base', 'emissive', 'normal', 'event', 'motion'] as const).map(
    (name) => texelHere(buffer.texture(name)).toVar(),
  );
  const speed = length(motion.xyz).toVar();
  const velocity = vec4(motion.xyz, speed.oneMinus().mul(speed.add(1)));
  return {
    color: vec4(base.rgb, 1),
    ...roughnessAndOcclusion(base.w),
    emission: unpackEmission(emissive.xyz),
    ...unpackFinish(emissive.w),
    ...unpackNormals(normal),
    dx: event.xyz,
    time: event.w,
    velocity: moving ? velocity : undefined,
    D: motion.w,
    ...(openness && { openness: texelHere(openness).x.toVar() }),
  };
}

/** Shaded and blended over what is behind it, hidden where something opaque is nearer. */
export function forwardMaterial(
  drawable: Drawable,
  projection: Projection,
  buffer: GBuffer,
  environment: Environment,
  optics: Optics,
  shadows?: Shadowing,
): NodeMaterial {
  const { uniforms } = drawable.surface;
  const material = new NodeMaterial();
  material.name = `transparent ${drawable.batch.kind}`;
  material.vertexNode = vertexStage(drawable.vertex, projection);
  material.fragmentNode = Fn(() => {
    const surface = readSurface(drawable.surface);
    const velocity = drawable.batch.kind === 'static' ? undefined : surface.velocity;
    Discard(surface.distance.greaterThan(depthHere(buffer)));
    const light = shade({ ...surface, velocity }, environment, uniforms, optics, shadows);
    return vec4(min(light, MOST_LIGHT), surface.color.w);
  })();
  material.side = sideOf(drawable.batch);
  material.transparent = true;
  material.blending = NormalBlending;
  material.depthTest = false;
  material.depthWrite = false;
  return material;
}

/** Apparent distance of the opaque surface under this fragment [m], or very far. */
export function depthHere(buffer: GBuffer): Float {
  const found = texelHere(buffer.texture('object')).toVar();
  return select(found.x.greaterThan(0.5), found.y, float(1e30));
}
