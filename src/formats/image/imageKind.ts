/** Image format by magic number. */
export function imageKind(bytes: Uint8Array): string {
  const starts = (magic: string, at = 0): boolean => [...magic].every((c, i) => bytes[at + i] === c.charCodeAt(0));
  if (bytes.length === 0) return 'empty';
  if (starts('\x89PNG\r\n\x1a\n')) return 'PNG';
  if (starts('\xff\xd8\xff')) return 'JPEG';
  if (starts('RIFF') && starts('WEBP', 8)) return 'WebP';
  if (starts('ftypavif', 4)) return 'AVIF';
  if (starts('\xabKTX')) return 'KTX2';
  if (starts('\x76\x2f\x31\x01')) return 'OpenEXR';
  if (starts('#?RADIANCE') || starts('#?RGBE')) return 'Radiance HDR';
  return 'unknown';
}

/** Whether it is a picture of radiance. */
export const hasRadiance = (bytes: Uint8Array): boolean => ['Radiance HDR', 'OpenEXR'].includes(imageKind(bytes));

/** Whether an image without metadata is sRGB: UsdPreviewSurface's `auto` takes 8 bits and three or four channels as sRGB, all else as linear. */
export function looksLikeColor(bytes: Uint8Array): boolean {
  if (imageKind(bytes) === 'PNG') return bytes[25] === 3 || (bytes[24] === 8 && (bytes[25] & 2) !== 0);
  if (imageKind(bytes) !== 'JPEG') return false;
  const at = jpegFrame(bytes);
  return at < 0 || bytes[at + 9] >= 3;
}

/** Offset of the marker of a JPEG's frame header (SOF marker, ITU T.81 B.2.2); −1: none. */
export function jpegFrame(bytes: Uint8Array): number {
  const u16 = (at: number): number => (bytes[at] << 8) | bytes[at + 1];
  let at = 2;
  while (at + 9 < bytes.length) {
    if (bytes[at] !== 0xff || bytes[at + 1] === 0xff) {
      at++;
      continue;
    }
    const marker = bytes[at + 1];
    const isFrame = marker >= 0xc0 && marker <= 0xcf && marker !== 0xc4 && marker !== 0xc8 && marker !== 0xcc;
    if (isFrame) return at;
    at += 2 + Math.max(2, u16(at + 2));
  }
  return -1;
}
