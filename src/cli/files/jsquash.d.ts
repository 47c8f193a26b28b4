/** The parts of the decoders in use. Their own types need those of emscripten. */
declare module '@jsquash/webp/decode.js' {
  export interface Picture {
    readonly width: number;
    readonly height: number;
    readonly data: Uint8ClampedArray;
  }
  export function init(module: WebAssembly.Module): Promise<void>;
  export default function decode(bytes: ArrayBuffer): Promise<Picture>;
}

declare module '@jsquash/avif/decode.js' {
  export function init(module: WebAssembly.Module): Promise<void>;
  export default function decode(bytes: ArrayBuffer): Promise<import('@jsquash/webp/decode.js').Picture | null>;
}
