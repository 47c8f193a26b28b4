declare module 'draco3dgltf/draco_encoder_gltf_nodejs.js' {
  const createEncoder: (settings: { readonly ENVIRONMENT: string }) => object;
  export default createEncoder;
}
