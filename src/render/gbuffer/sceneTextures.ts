import type { DataTexture } from 'three/webgpu';
import type { Texture, TextureChannel } from '../../scene/types.ts';
import type { BatchTextures } from '../geometry/batches.ts';
import { ChannelPacker } from '../gpu/channelPacking.ts';
import { textureKey, uploadTexture } from '../gpu/textures.ts';
import type { ChannelTexture, SurfaceTextures } from './surface.ts';

/** The images of a scene on the GPU, uploaded by the first shader that reads them. */
export class SceneTextures {
  private readonly anisotropic: boolean;
  private readonly packer = new ChannelPacker();
  private readonly uploaded = new Map<string, DataTexture>();

  /** `anisotropic`: see `uploadTexture`. */
  constructor(anisotropic: boolean) {
    this.anisotropic = anisotropic;
  }

  of(image: Texture): DataTexture {
    const key = textureKey(image);
    const texture = this.uploaded.get(key) ?? uploadTexture(image, this.anisotropic);
    this.uploaded.set(key, texture);
    return texture;
  }

  /** Those of a batch's surfaces. */
  ofSurface({ baseColorTexture, emissiveTexture, normalTexture, ...channels }: BatchTextures): SurfaceTextures {
    const { roughnessTexture, metallicTexture, occlusionTexture, uvTexture, irTexture } = channels;
    return {
      ...(baseColorTexture && { baseColor: this.of(baseColorTexture) }),
      ...(emissiveTexture && { emissive: this.of(emissiveTexture) }),
      ...(normalTexture && { normal: this.of(normalTexture.texture) }),
      ...this.channels({
        ...(roughnessTexture && { roughness: roughnessTexture }),
        ...(metallicTexture && { metallic: metallicTexture }),
        ...(occlusionTexture && { occlusion: occlusionTexture }),
        ...(uvTexture && { uv: uvTexture }),
        ...(irTexture && { ir: irTexture }),
      }),
    };
  }

  /** The channels that one material reads, packed into few textures (`ChannelPacker`). */
  channels<Name extends string>(
    channels: Partial<Record<Name, TextureChannel>>,
  ): Partial<Record<Name, ChannelTexture>> {
    const packed = Object.entries(this.packer.pack(channels)) as [Name, TextureChannel][];
    return Object.fromEntries(
      packed.map(([name, { texture, channel }]) => [name, { texture: this.of(texture), channel }]),
    ) as Partial<Record<Name, ChannelTexture>>;
  }

  dispose(): void {
    for (const texture of this.uploaded.values()) texture.dispose();
  }
}
