import { attribute, float, ivec2, normalize, screenCoordinate, textureLoad, vec3 } from 'three/tsl';
import {
  GreaterDepth,
  LessEqualDepth,
  type Node,
  NodeMaterial,
  QuadMesh,
  type RenderTarget,
  type Texture,
  type TextureNode,
  type WebGPURenderer,
} from 'three/webgpu';
import type { Vec3, Vec4 } from '../../shaders/types.ts';
import type { FrameUniforms } from './frameUniforms.ts';

/** Pixels of a pass over a target with the G-buffer's depth: where something was drawn, or where nothing was. */
export type PassRegion = 'surfaces' | 'sky';

/**
 * A picture-filling pass: `output` is a colour, or an `mrt()`. `where` is left to the depth test, and not to an `If`: that spares the pixels
 * before they are shaded, where branches are computed on both sides (docs/adr/0006-software-gpu.md).
 */
export class FullScreenPass {
  private readonly material = new NodeMaterial();
  private readonly quad: QuadMesh;
  private readonly region: PassRegion | undefined;

  constructor(output: Node, name: string, where?: PassRegion) {
    this.region = where;
    this.material.name = name;
    this.material.fragmentNode = output;
    this.material.depthTest = where !== undefined;
    this.material.depthFunc = where === 'surfaces' ? GreaterDepth : LessEqualDepth;
    this.material.depthWrite = false;
    this.quad = new QuadMesh(this.material);
  }

  /** `over`: what the target holds already stays where this pass does not draw. */
  render(renderer: WebGPURenderer, target: RenderTarget | null, over = false): void {
    // Three's quad lies at z = 0: the far plane, but where depth is not reversed.
    if (this.region && !renderer.reversedDepthBuffer) this.material.depthNode = float(1);
    renderer.setMRT(null);
    renderer.setRenderTarget(target);
    renderer.autoClearColor = !over;
    renderer.autoClearDepth = false;
    this.quad.render(renderer);
    renderer.autoClearColor = true;
    renderer.autoClearDepth = true;
  }

  dispose(): void {
    this.material.dispose();
  }
}

/** The texel of another target of the same size under this fragment. */
export const texelHere = (of: Texture | TextureNode): Vec4 => textureLoad(of, ivec2(screenCoordinate));

/** Unit direction of this pixel in the observer's frame, on the world axes that the boost carries. */
export function pixelDirection({ halfTangents, frustumCenter, jitter, orientation }: FrameUniforms): Vec3 {
  const ndc = attribute<'vec3'>('position', 'vec3').xy.add(jitter);
  return normalize(orientation.mul(vec3(ndc.mul(halfTangents).add(frustumCenter), -1)));
}
