/** Device limits that are raised to the adapter's: bytes per sample for the G-buffer, and sizes of buffers and textures for large scenes. */
export const RAISED_LIMITS = [
  'maxColorAttachmentBytesPerSample',
  'maxTextureDimension2D',
  'maxBufferSize',
  'maxStorageBufferBindingSize',
] as const;
