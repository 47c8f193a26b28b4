/** The part of Draco's decoder in use; the package has no types. */
declare module 'draco3dgltf/draco_decoder_gltf_nodejs.js' {
  interface NumberArray {
    GetValue(index: number): number;
  }
  interface Status {
    ok(): boolean;
    error_msg(): string;
  }
  interface Mesh {
    num_faces(): number;
    num_points(): number;
  }
  interface Attribute {
    readonly ptr: number;
    num_components(): number;
  }
  interface Buffer {
    Init(bytes: Uint8Array, length: number): void;
  }
  type ReadAll = (mesh: Mesh, attribute: Attribute, out: NumberArray) => boolean;
  interface Decoder {
    DecodeBufferToMesh(buffer: Buffer, mesh: Mesh): Status;
    GetAttributeByUniqueId(mesh: Mesh, id: number): Attribute;
    GetFaceFromMesh(mesh: Mesh, face: number, out: NumberArray): boolean;
    GetAttributeFloatForAllPoints: ReadAll;
    GetAttributeInt8ForAllPoints: ReadAll;
    GetAttributeUInt8ForAllPoints: ReadAll;
    GetAttributeInt16ForAllPoints: ReadAll;
    GetAttributeUInt16ForAllPoints: ReadAll;
    GetAttributeUInt32ForAllPoints: ReadAll;
  }
  interface DracoModule {
    readonly Decoder: new () => Decoder;
    readonly DecoderBuffer: new () => Buffer;
    readonly Mesh: new () => Mesh;
    readonly DracoFloat32Array: new () => NumberArray;
    readonly DracoInt8Array: new () => NumberArray;
    readonly DracoUInt8Array: new () => NumberArray;
    readonly DracoInt16Array: new () => NumberArray;
    readonly DracoUInt16Array: new () => NumberArray;
    readonly DracoInt32Array: new () => NumberArray;
    readonly DracoUInt32Array: new () => NumberArray;
    /** Resizes the decoder's memory; false on failure. */
    reallocBuffer: (bytes: number) => ArrayBuffer | false;
    destroy(thing: Decoder | Buffer | Mesh | NumberArray): void;
  }
  const createModule: (settings: {
    readonly ENVIRONMENT: 'WEB' | 'WORKER' | 'NODE' | 'SHELL';
    print(text: string): void;
    printErr(text: string): void;
  }) => DracoModule;

  export type { Attribute, Decoder, DracoModule, Mesh, NumberArray };
  export default createModule;
}
