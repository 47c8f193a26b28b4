/** Most objects of a scene: instances make many of little. */
export const MAX_OBJECTS = 250_000;

/** The steepest that normals of a picture are made: beyond it all of them lie in the surface. */
const MAX_NORMAL_STRENGTH = 1000;
/** How much steeper a file wants the normals of a picture to be, within what shaders can hold. */
export const clampNormalStrength = (strength: number): number =>
  Number.isFinite(strength) ? Math.max(-MAX_NORMAL_STRENGTH, Math.min(MAX_NORMAL_STRENGTH, strength)) : 1;
