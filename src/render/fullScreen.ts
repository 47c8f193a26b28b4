import { attribute, ivec2, normalize, screenCoordinate, texture, vec3 } from 'three/tsl';
import { type Node, NodeMaterial, QuadMesh, type RenderTarget, type Texture, type WebGPURenderer } from 'three/webgpu';
import type { Vec3, Vec4 } from '../shaders/types.ts';
import type { Uniforms } from './uniforms.ts';

/** A picture-filling pass: `output` is a colour, or an `mrt()`. */
export class FullScreen {
  private readonly material = new NodeMaterial();
  private readonly quad: QuadMesh;

  constructor(output: Node, name: string) {
    this.material.name = name;
    this.material.fragmentNode = output;
    this.material.depthTest = false;
    this.material.depthWrite = false;
    this.quad = new QuadMesh(this.material);
  }

  render(renderer: WebGPURenderer, target: RenderTarget | null): void {
    renderer.setMRT(null);
    renderer.setRenderTarget(target);
    this.quad.render(renderer);
  }

  dispose(): void {
    this.material.dispose();
  }
}

/** The texel of another target of the same size under this fragment. */
export const texelHere = (of: Texture): Vec4 => texture(of).load(ivec2(screenCoordinate));

/** Unit direction of this pixel in the observer's frame, on the world axes that the boost carries. */
export function pixelDirection({ halfTangents, jitter, orientation }: Uniforms): Vec3 {
  const ndc = attribute<'vec3'>('position', 'vec3').xy.add(jitter);
  return normalize(orientation.mul(vec3(ndc.mul(halfTangents), -1)));
}
