import { createDefaultContainer, type KTX2Container, write } from 'ktx-parse';

/** Colour models of data format descriptors. */
const [RGBSDA, UASTC] = [1, 166];

interface Ktx2Parts {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8Array;
  /** Bytes that the data are without Zstandard; absent: it has none. */
  readonly unpacked?: number;
  readonly orientation?: string;
}

const file = ({ width, height, data, unpacked, orientation }: Ktx2Parts, more: Partial<KTX2Container>): Uint8Array =>
  write({
    ...createDefaultContainer(),
    pixelWidth: width,
    pixelHeight: height,
    levelCount: 1,
    levels: [{ levelData: data, uncompressedByteLength: unpacked ?? data.length }],
    supercompressionScheme: unpacked === undefined ? 0 : 2,
    ...(orientation !== undefined && { keyValue: { KTXorientation: orientation } }),
    ...more,
  });

const descriptor = (colorModel: number, block: number, bytes: number): KTX2Container['dataFormatDescriptor'] => [
  {
    vendorId: 0,
    descriptorType: 0,
    versionNumber: 2,
    colorModel,
    colorPrimaries: 1,
    transferFunction: 2,
    flags: 0,
    texelBlockDimension: [block - 1, block - 1, 0, 0],
    bytesPlane: [bytes, 0, 0, 0, 0, 0, 0, 0],
    samples: [
      {
        bitOffset: 0,
        bitLength: 8 * bytes - 1,
        channelType: colorModel === UASTC ? 3 : 0,
        samplePosition: [0, 0, 0, 0],
        sampleLower: 0,
        sampleUpper: 0xffffffff,
      },
    ],
  },
];

/** A KTX 2.0 picture of UASTC blocks. */
export const uastcKtx2 = (parts: Ktx2Parts): Uint8Array =>
  file(parts, { vkFormat: 0, typeSize: 1, dataFormatDescriptor: descriptor(UASTC, 4, 16) });

/** One colour, as UASTC of 4 × 4 pixels: mode 8, whose prefix is 10111, and four bytes. */
export function solidKtx2(...color: readonly [r: number, g: number, b: number, a: number]): Uint8Array {
  const bits = color.reduce((sum, value, i) => sum | (BigInt(value) << BigInt(5 + 8 * i)), 0x17n);
  const data = Uint8Array.from({ length: 16 }, (_, i) => Number((bits >> BigInt(8 * i)) & 255n));
  return uastcKtx2({ width: 4, height: 4, data });
}

/** A KTX 2.0 picture in a format of Vulkan. */
export const plainKtx2 = (vkFormat: KTX2Container['vkFormat'], parts: Ktx2Parts): Uint8Array =>
  file(parts, {
    vkFormat,
    typeSize: 1,
    dataFormatDescriptor: descriptor(RGBSDA, 1, parts.data.length / (parts.width * parts.height)),
  });

/** Bytes as a frame of Zstandard without compression. */
export function storedZstd(bytes: Uint8Array): Uint8Array {
  const head = (bytes.length << 3) | 1;
  return Uint8Array.of(0x28, 0xb5, 0x2f, 0xfd, 0, 0x58, head & 255, (head >> 8) & 255, head >> 16, ...bytes);
}
