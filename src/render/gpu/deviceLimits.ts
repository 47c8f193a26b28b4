/** Limits of a device that are raised to what its adapter has: bytes per sample for the G-buffer, and sizes of buffers and textures for large scenes. */
export const RAISED_LIMITS = [
  'maxColorAttachmentBytesPerSample',
  'maxTextureDimension2D',
  'maxBufferSize',
  'maxStorageBufferBindingSize',
] as const;
