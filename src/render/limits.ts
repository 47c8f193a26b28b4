/**
 * Limits of a device that are raised to what its adapter has: bytes per sample for the G-buffer, sizes of buffers and textures for large scenes, and textures of a
 * shader: moving shadows, lamps, coloured light and occlusion together take 17, one more than every device has.
 */
export const RAISED_LIMITS = [
  'maxColorAttachmentBytesPerSample',
  'maxTextureDimension2D',
  'maxBufferSize',
  'maxStorageBufferBindingSize',
  'maxSampledTexturesPerShaderStage',
  'maxSamplersPerShaderStage',
] as const;
