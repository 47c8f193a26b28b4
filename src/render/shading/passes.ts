import { Discard, Fn, float, select, vec4 } from 'three/tsl';
import { LessEqualDepth, NoBlending, NodeMaterial, type Texture } from 'three/webgpu';
import { isStatic } from '../../scene/motion/motion.ts';
import { fullVelocity } from '../../shaders/kinematics/fullVelocity.ts';
import type { Float, Vec4 } from '../../shaders/types.ts';
import type { ColorPipeline } from '../color/radiance.ts';
import { type DrawCall, drawOver, materialSide } from '../gbuffer/drawCall.ts';
import type { GBuffer } from '../gbuffer/gbuffer.ts';
import { readSurface, surfaceOutputs, type TargetName } from '../gbuffer/surface.ts';
import {
  unpackEmission,
  unpackNormals,
  unpackRoughnessAndOcclusion,
  unpackSpecular,
} from '../gbuffer/surfacePacking.ts';
import { type SpacetimeProjection, vCameraPosition, vertexStage } from '../geometry/vertexStage.ts';
import { logarithmicDepth } from '../gpu/depth.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { frustumDirection, texelHere } from '../gpu/fullScreenPass.ts';
import { type LightRange, limitLight } from '../gpu/lightRange.ts';
import type { Environment } from '../lights/environment.ts';
import type { LightVisibility } from '../shadows/distant/parallelReceiver.ts';
import { type ShadedSurface, shade } from './shade.ts';
import { backgroundRadiance } from './sky.ts';

/** `reversed`: whether the depth buffer is reversed. */
export function geometryMaterial(
  drawCall: DrawCall,
  projection: SpacetimeProjection,
  names: readonly TargetName[],
  reversed: boolean,
): NodeMaterial {
  const material = new NodeMaterial();
  material.name = `${drawCall.batch.kind} ${projection.event} ${projection.place}`;
  material.vertexNode = vertexStage(drawCall.vertex, projection);
  material.fragmentNode = surfaceOutputs(drawCall.surface, names);
  if (!reversed) material.depthNode = logarithmicDepth(vCameraPosition);
  material.side = materialSide(drawCall.batch);
  material.blending = NoBlending;
  return material;
}

/** The sky, for pixels without a surface. */
export const skyPass = (
  environment: Environment,
  uniforms: FrameUniforms,
  pipeline: ColorPipeline,
  range: LightRange,
): Vec4 =>
  Fn(() =>
    vec4(limitLight(backgroundRadiance(environment, uniforms, pipeline, frustumDirection(uniforms)), range.max), 1),
  )();

/** Deferred shading, for pixels with a surface. `moving`: whether anything in the scene moves; `openness`: the ambient occlusion target, if it is used. */
export const lightingPass = (
  buffer: GBuffer,
  environment: Environment,
  uniforms: FrameUniforms,
  pipeline: ColorPipeline,
  moving: boolean,
  shadows: LightVisibility | undefined,
  openness: Texture | undefined,
  range: LightRange,
): Vec4 =>
  Fn(() => {
    const light = shade(readGBuffer(buffer, moving, openness), environment, uniforms, pipeline, shadows);
    return vec4(limitLight(light, range.max), 1);
  })();

function readGBuffer(buffer: GBuffer, moving: boolean, openness: Texture | undefined): ShadedSurface {
  const [base, emissive, normal, event, motion] = (['base', 'emissive', 'normal', 'event', 'motion'] as const).map(
    (name) => texelHere(buffer.texture(name)).toVar(),
  );
  const velocity = fullVelocity(motion.xyz);
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

/** What light is computed with in the pass that draws the surfaces. */
export interface ForwardLighting {
  readonly projection: SpacetimeProjection;
  readonly environment: Environment;
  readonly pipeline: ColorPipeline;
  readonly range: LightRange;
  readonly shadows?: LightVisibility;
}

/** Forward shading of opaque surfaces. `reversed`: whether the depth buffer is reversed. */
export function opaqueMaterial(drawCall: DrawCall, lighting: ForwardLighting, reversed: boolean): NodeMaterial {
  const material = forwardMaterial(drawCall, lighting);
  if (!reversed) material.depthNode = logarithmicDepth(vCameraPosition);
  material.side = materialSide(drawCall.batch);
  material.blending = NoBlending;
  return material;
}

/** Forward shading of transparent surfaces, blended over what is behind them and hidden behind nearer opaque surfaces: those of the G-buffer. */
export function transparentMaterial(drawCall: DrawCall, lighting: ForwardLighting, buffer: GBuffer): NodeMaterial {
  return drawOver(forwardMaterial(drawCall, lighting, buffer), drawCall.batch);
}

/** The same, hidden by the depth of opaque surfaces that are drawn forward too. */
export function depthTestedMaterial(drawCall: DrawCall, lighting: ForwardLighting, reversed: boolean): NodeMaterial {
  const material = drawOver(forwardMaterial(drawCall, lighting), drawCall.batch);
  if (!reversed) material.depthNode = logarithmicDepth(vCameraPosition);
  material.depthTest = true;
  material.depthFunc = LessEqualDepth;
  return material;
}

/** `buffer`: the G-buffer with the opaque surfaces that hide it. */
function forwardMaterial(
  drawCall: DrawCall,
  { projection, environment, pipeline, range, shadows }: ForwardLighting,
  buffer?: GBuffer,
): NodeMaterial {
  const { uniforms } = drawCall.surface;
  const { kind, transparent } = drawCall.batch;
  const material = new NodeMaterial();
  material.name = `${transparent ? 'transparent' : 'opaque'} ${kind}`;
  material.vertexNode = vertexStage(drawCall.vertex, projection);
  material.fragmentNode = Fn(() => {
    const surface = readSurface(drawCall.surface);
    const velocity = isStatic(drawCall.batch) ? undefined : surface.velocity;
    if (buffer) Discard(surface.distance.greaterThan(depthHere(buffer)));
    const light = shade({ ...surface, velocity }, environment, uniforms, pipeline, shadows);
    return vec4(limitLight(light, range.max), transparent ? surface.color.w : 1);
  })();
  return material;
}

/** Apparent distance of the opaque surface under this fragment [m], or a very large number. */
export function depthHere(buffer: GBuffer): Float {
  const object = texelHere(buffer.texture('object')).toVar();
  return select(object.x.greaterThan(0.5), object.y, float(1e30));
}
