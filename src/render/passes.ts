import { Discard, Fn, float, If, length, min, vec3, vec4 } from 'three/tsl';
import { NoBlending, NodeMaterial, NormalBlending } from 'three/webgpu';
import { apparentPosition } from '../shaders/apparentPosition.ts';
import { simultaneousPosition } from '../shaders/simultaneousPosition.ts';
import type { Float, Vec3, Vec4 } from '../shaders/types.ts';
import type { Environment } from './environment.ts';
import { pixelDirection, texelHere } from './fullScreen.ts';
import { type Drawable, sideOf } from './sceneUpload.ts';
import { shade } from './shade.ts';
import { background } from './sky.ts';
import { readSurface, surfaceOutputs, type TargetName } from './surface.ts';
import type { GBuffer } from './targets.ts';
import type { Uniforms } from './uniforms.ts';
import { type Projection, vertexStage } from './vertexStage.ts';

/** Largest finite half float: what may be kept where the light target has no more. */
const MOST_LIGHT = 65_000;

export function geometryMaterial(
  drawable: Drawable,
  projection: Projection,
  names: readonly TargetName[],
): NodeMaterial {
  const material = new NodeMaterial();
  material.name = `${drawable.batch.kind} ${projection.event} ${projection.place}`;
  material.vertexNode = vertexStage(drawable.vertex, projection);
  material.fragmentNode = surfaceOutputs(drawable.surface, names);
  material.side = sideOf(drawable.batch);
  material.blending = NoBlending;
  return material;
}

/** Every pixel of the G-buffer shaded, and the sky where nothing is. */
export const deferredLight = (buffer: GBuffer, environment: Environment, uniforms: Uniforms): Vec4 =>
  Fn(() => {
    const light = vec3(0).toVar();
    If(texelHere(buffer.texture('object')).x.lessThan(0.5), () => {
      light.assign(background(environment, uniforms, pixelDirection(uniforms)));
    }).Else(() => {
      light.assign(shade(surfaceHere(buffer), environment, uniforms));
    });
    return vec4(min(light, MOST_LIGHT), 1);
  })();

function surfaceHere(buffer: GBuffer) {
  const [base, emissive, event, motion] = (['base', 'emissive', 'event', 'motion'] as const).map((name) =>
    texelHere(buffer.texture(name)).toVar(),
  );
  const speed = length(motion.xyz).toVar();
  return {
    color: vec4(base.rgb, 1),
    roughness: base.w,
    emissive: emissive.rgb,
    metallic: emissive.w,
    normal: texelHere(buffer.texture('normal')).xyz.normalize(),
    dx: event.xyz,
    velocity: vec4(motion.xyz, speed.oneMinus().mul(speed.add(1))),
    D: motion.w,
  };
}

/** Shaded and blended over what is behind it, hidden where something opaque is nearer. */
export function forwardMaterial(
  drawable: Drawable,
  projection: Projection,
  buffer: GBuffer,
  environment: Environment,
): NodeMaterial {
  const { uniforms } = drawable.surface;
  const material = new NodeMaterial();
  material.name = `transparent ${drawable.batch.kind}`;
  material.vertexNode = vertexStage(drawable.vertex, projection);
  material.fragmentNode = Fn(() => {
    const surface = readSurface(drawable.surface);
    Discard(
      shownDistance(surface.dx, projection.place, uniforms).greaterThan(depthHere(buffer, projection.place, uniforms)),
    );
    return vec4(min(shade(surface, environment, uniforms), MOST_LIGHT), surface.color.w);
  })();
  material.side = sideOf(drawable.batch);
  material.transparent = true;
  material.blending = NormalBlending;
  material.depthTest = false;
  material.depthWrite = false;
  return material;
}

function shownDistance(dx: Vec3, place: Projection['place'], { u, gamma }: Uniforms): Float {
  if (place === 'apparent') return length(apparentPosition(dx, u, gamma));
  return length(place === 'contracted' ? simultaneousPosition(dx, u, gamma) : dx);
}

/** Apparent distance |Δx′| of the opaque surface under this fragment [m], or very far. */
export function depthHere(buffer: GBuffer, place: Projection['place'], uniforms: Uniforms): Float {
  const distance = shownDistance(texelHere(buffer.texture('event')).xyz, place, uniforms);
  return texelHere(buffer.texture('object')).x.greaterThan(0.5).select(distance, float(1e30));
}
