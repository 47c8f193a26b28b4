import { convolve, type FeatureMap, maxPool, upsample } from './convolution.ts';
import type { Tensor } from './tza.ts';

/** Width and height of the input are multiples of this: it is halved four times. */
export const UNET_ALIGNMENT = 16;

/**
 * Open Image Denoise's U-Net: five levels of convolutions, each at half the resolution of the one before, and back, each with what the level had on the
 * way down. Source: training/model.py of Open Image Denoise 2.
 */
export function runUnet(weights: ReadonlyMap<string, Tensor>, input: FeatureMap): FeatureMap {
  const layer = (map: FeatureMap, name: string): FeatureMap => {
    const [weight, bias] = [weights.get(`${name}.weight`), weights.get(`${name}.bias`)];
    if (!weight || !bias) throw new Error(`the network has no layer ${name}`);
    return convolve(map, { weight, bias });
  };
  const both = (below: FeatureMap, beside: FeatureMap): FeatureMap => ({
    ...beside,
    channels: [...upsample(below).channels, ...beside.channels],
  });
  const level1 = maxPool(layer(layer(input, 'enc_conv0'), 'enc_conv1'));
  const level2 = maxPool(layer(level1, 'enc_conv2'));
  const level3 = maxPool(layer(level2, 'enc_conv3'));
  const level4 = maxPool(layer(level3, 'enc_conv4'));
  const bottom = layer(layer(level4, 'enc_conv5a'), 'enc_conv5b');
  const up3 = layer(layer(both(bottom, level3), 'dec_conv4a'), 'dec_conv4b');
  const up2 = layer(layer(both(up3, level2), 'dec_conv3a'), 'dec_conv3b');
  const up1 = layer(layer(both(up2, level1), 'dec_conv2a'), 'dec_conv2b');
  return layer(layer(layer(both(up1, input), 'dec_conv1a'), 'dec_conv1b'), 'dec_conv0');
}
