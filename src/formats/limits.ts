/** Most objects of a scene: instances make many of little. */
export const MAX_OBJECTS = 250_000;
