/** Maximum number of objects of a scene; instancing makes many from little. */
export const MAX_OBJECTS = 250_000;

/** Maximum normal map strength: beyond it all normals lie in the surface. */
const MAX_NORMAL_STRENGTH = 1000;
/** Normal map strength of a file, clamped to what shaders can represent. */
export const clampNormalStrength = (strength: number): number =>
  Number.isFinite(strength) ? Math.max(-MAX_NORMAL_STRENGTH, Math.min(MAX_NORMAL_STRENGTH, strength)) : 1;
