import { Discard, Fn, float, length, min, select, vec4 } from 'three/tsl';
import { NoBlending, NodeMaterial, NormalBlending, type Texture } from 'three/webgpu';
import { isStatic } from '../../scene/motion/motion.ts';
import type { Float, Vec3, Vec4 } from '../../shaders/types.ts';
import type { ColorPipeline } from '../color/radiance.ts';
import { type DrawCall, materialSide } from '../gbuffer/drawCall.ts';
import type { GBuffer } from '../gbuffer/gbuffer.ts';
import { readSurface, surfaceOutputs, type TargetName } from '../gbuffer/surface.ts';
import {
  unpackEmission,
  unpackNormals,
  unpackRoughnessAndOcclusion,
  unpackSpecular,
} from '../gbuffer/surfacePacking.ts';
import { type SpacetimeProjection, vertexStage, vObserverPosition } from '../geometry/vertexStage.ts';
import { logarithmicDepth } from '../gpu/depth.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { pixelDirection, texelHere } from '../gpu/fullScreenPass.ts';
import type { Environment } from '../lights/environment.ts';
import type { LightVisibility } from '../shadows/distant/parallelReceiver.ts';
import { type ShadedSurface, shade } from './shade.ts';
import { backgroundRadiance } from './sky.ts';

/** Largest finite half float: what may be kept where the light target has no more. */
export const MAX_LIGHT = 65_000;

/** `reversed`: whether the depth buffer is. */
export function geometryMaterial(
  drawable: DrawCall,
  projection: SpacetimeProjection,
  names: readonly TargetName[],
  reversed: boolean,
): NodeMaterial {
  const material = new NodeMaterial();
  material.name = `${drawable.batch.kind} ${projection.event} ${projection.place}`;
  material.vertexNode = vertexStage(drawable.vertex, projection);
  material.fragmentNode = surfaceOutputs(drawable.surface, names);
  if (!reversed) material.depthNode = logarithmicDepth(vObserverPosition);
  material.side = materialSide(drawable.batch);
  material.blending = NoBlending;
  return material;
}

const clampToHalf = (light: Vec3): Vec4 => vec4(min(light, MAX_LIGHT), 1);

/** The sky, for pixels in which nothing is. */
export const skyPass = (environment: Environment, uniforms: FrameUniforms, pipeline: ColorPipeline): Vec4 =>
  Fn(() => clampToHalf(backgroundRadiance(environment, uniforms, pipeline, pixelDirection(uniforms))))();

/** The G-buffer shaded, for pixels in which something is. `moving`: not all of it rests; `openness`: of each to the sky, where that is to count. */
export const lightingPass = (
  buffer: GBuffer,
  environment: Environment,
  uniforms: FrameUniforms,
  pipeline: ColorPipeline,
  moving: boolean,
  shadows: LightVisibility | undefined,
  openness: Texture | undefined,
): Vec4 =>
  Fn(() => clampToHalf(shade(readGBuffer(buffer, moving, openness), environment, uniforms, pipeline, shadows)))();

function readGBuffer(buffer: GBuffer, moving: boolean, openness: Texture | undefined): ShadedSurface {
  const [base, emissive, normal, event, motion] = (['base', 'emissive', 'normal', 'event', 'motion'] as const).map(
    (name) => texelHere(buffer.texture(name)).toVar(),
  );
  const speed = length(motion.xyz).toVar();
  const velocity = vec4(motion.xyz, speed.oneMinus().mul(speed.add(1)));
  return {
    color: vec4(base.rgb, 1),
    ...unpackRoughnessAndOcclusion(base.w),
    emission: unpackEmission(emissive.xyz),
    ...unpackSpecular(emissive.w),
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
  drawable: DrawCall,
  projection: SpacetimeProjection,
  buffer: GBuffer,
  environment: Environment,
  pipeline: ColorPipeline,
  shadows?: LightVisibility,
): NodeMaterial {
  const { uniforms } = drawable.surface;
  const material = new NodeMaterial();
  material.name = `transparent ${drawable.batch.kind}`;
  material.vertexNode = vertexStage(drawable.vertex, projection);
  material.fragmentNode = Fn(() => {
    const surface = readSurface(drawable.surface);
    const velocity = isStatic(drawable.batch) ? undefined : surface.velocity;
    Discard(surface.distance.greaterThan(depthHere(buffer)));
    const light = shade({ ...surface, velocity }, environment, uniforms, pipeline, shadows);
    return vec4(min(light, MAX_LIGHT), surface.color.w);
  })();
  material.side = materialSide(drawable.batch);
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
