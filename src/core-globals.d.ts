// The few platform globals the core may use: those that browsers, workers and Node all have.
// Only tsconfig.core.json needs this file; elsewhere the DOM library declares the same names.
declare class TextDecoder {
  constructor(label?: string, options?: { fatal?: boolean; ignoreBOM?: boolean });
  decode(input?: ArrayBufferView | ArrayBuffer): string;
}
declare class TextEncoder {
  encode(input?: string): Uint8Array<ArrayBuffer>;
}
/** base64 → one character per byte. */
declare function atob(data: string): string;
/** One character per byte → base64. */
declare function btoa(data: string): string;
/** [ms], from some time on. */
declare const performance: { now(): number };
/** The parameters of an address. */
declare class URLSearchParams {
  constructor(init?: string | URLSearchParams);
  get(name: string): string | null;
}
