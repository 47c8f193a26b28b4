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
import type { Vec2, Vec3, Vec4 } from '../../shaders/types.ts';
import type { FrameUniforms } from './frameUniforms.ts';

/** The pixels that a pass covers on a target with the G-buffer's depth: those with a surface, or those without. */
export type PassRegion = 'surfaces' | 'sky';

/**
 * A full-screen pass: `output` is a colour or an `mrt()`. A region is selected by the depth test, which skips pixels before shading; with an `If`, a software
 * GPU would compute both branches (docs/adr/0006-software-gpu.md).
 */
export class FullScreenPass {
  private readonly material = new NodeMaterial();
  private readonly quad: QuadMesh;
  private readonly region: PassRegion | undefined;

  constructor(output: Node, name: string, region?: PassRegion) {
    this.region = region;
    this.material.name = name;
    this.material.fragmentNode = output;
    this.material.depthTest = region !== undefined;
    this.material.depthFunc = region === 'surfaces' ? GreaterDepth : LessEqualDepth;
    this.material.depthWrite = false;
    this.quad = new QuadMesh(this.material);
  }

  /** `over`: the target is not cleared first. */
  render(renderer: WebGPURenderer, target: RenderTarget | null, over = false): void {
    // The quad of three.js lies at z = 0, which is the far plane only if depth is reversed.
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

/** The texel of a texture of the target's size at this fragment. */
export const texelHere = (of: Texture | TextureNode): Vec4 => textureLoad(of, ivec2(screenCoordinate));

/**
 * Unit direction of this pixel in the observer's frame, on the world axes that the boost carries, in what is drawn with a perspective lens: also the faces of
 * other lenses' pictures. `pixelDirection` (lenses/pixelDirection.ts) is for passes over whole pictures.
 */
export function frustumDirection(uniforms: FrameUniforms): Vec3 {
  const ndc = attribute<'vec3'>('position', 'vec3').xy.add(uniforms.jitter);
  return normalize(uniforms.orientation.mul(vec3(frustumTangents(ndc, uniforms), -1)));
}

/** Tangents of the angles from the forward axis at a place of the picture, −1 … 1 to the right and up. */
export const frustumTangents = (
  place: Vec2,
  { halfTangents, frustumCenter }: Pick<FrameUniforms, 'halfTangents' | 'frustumCenter'>,
): Vec2 => place.mul(halfTangents).add(frustumCenter);
