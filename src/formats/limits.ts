/** Most objects of a scene: instances make many of little. */
export const MAX_OBJECTS = 250_000;

/** The steepest that normals of a picture are made: beyond it all of them lie in the surface. */
const STEEPEST = 1000;
/** How much steeper a file wants the normals of a picture to be, within what shaders can hold. */
export const heldStrength = (strength: number): number =>
  Number.isFinite(strength) ? Math.max(-STEEPEST, Math.min(STEEPEST, strength)) : 1;
